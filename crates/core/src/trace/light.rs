//! The light that one light source sends back from points on one primitive.
//!
//! Points are shaded side by side: a step is taken for all of them before the next step. No step
//! waits for the root and the quotient of its own point then, and all that depends on the light or
//! on an occluder is the same for all points.

use catoptric_scene::{Numerics, Phong, PointLight, Scalar};

use super::frame::Frame;
use super::hit_groups::HitGroup;
use super::points::{ShadePoints, ShadowRays};
use super::shadow::{shadows_in_turn, shadows_side_by_side};
use crate::cull::LightCones;
use crate::omission::Omission;
use crate::shape::Shape;
use crate::simd::{Lanes, Vec3, power};

/// A light, and what may stand before it.
#[derive(Clone, Copy)]
pub(crate) struct Illumination<'a, S: Scalar> {
    pub(crate) light: &'a PointLight<S>,
    pub(crate) cones: LightCones<'a, S>,
    /// Numbers of occluders.
    pub(crate) occluders: &'a [u32],
}

/// Adds what a light sends back from points on `shape`; how many shadow rays were sent to it.
///
/// A lane that the light does not reach adds +0, which changes nothing: no colour is -0. Without
/// a highlight the recursion adds 0 · power, which changes nothing either.
#[inline(always)]
pub(crate) fn add_light<L: Lanes, F: Shape<L>>(
    shape: F,
    frame: &Frame<L::Scalar>,
    (material, highlight): (&Phong<L::Scalar>, bool),
    from: Illumination<L::Scalar>,
    groups: &[HitGroup<L::Scalar>],
    points: &mut [ShadePoints<L::Scalar>],
) -> u64 {
    let Illumination { light, cones, occluders } = from;
    // Formed once: in the loops, which write, the compiler would read and spread them each time.
    let position = shape.relative(Vec3::splat(light.position));
    let reach = L::splat(cones.reach);
    let (intensity, diffuse) = (Vec3::<L>::splat(light.intensity), Vec3::splat(material.diffuse));
    let specular = L::splat(material.specular);

    // Shadow rays, and which of them face the light; those beyond the cones' reach are marked.
    let mut rays = 0;
    let mut far = 0;
    for (group, at) in groups.iter().zip(&mut *points).rev() {
        let to_light = position - Vec3::from_arrays(&group.arm);
        let distance = to_light.length();
        let direction = to_light * (L::constant(1.0) / distance);
        let facing = Vec3::from_arrays(&at.normal).dot(direction);
        let zero = L::constant(0.0);
        let faces = facing.gt(zero) & distance.gt(zero);
        rays += u64::from((faces.bits() & ((1 << at.live) - 1)).count_ones());
        far = far * 2 + u32::from(faces.without(distance.lt(reach)).any());
        at.shadow = ShadowRays {
            direction: direction.to_arrays(),
            distance: distance.to_array(),
            facing: facing.to_array(),
            lit: faces.to_array(),
        };
    }
    if light.hidden {
        return rays;
    }

    if F::NUMERICS == Numerics::Robust && frame.omissions.contains(Omission::Occluders) {
        shadows_side_by_side::<L, F>(shape, frame, far, (cones, occluders), groups, points);
    } else {
        shadows_in_turn::<L, F>(shape, frame, occluders, groups, points);
    }

    // The sum, where some lane is lit.
    for at in points {
        let lit = at.shadow.lit::<L>();
        if !lit.any() {
            continue;
        }
        let mut back = diffuse * L::from_array(at.shadow.facing);
        if highlight {
            let direction = Vec3::<L>::from_arrays(&at.shadow.direction);
            let shine = direction.dot(Vec3::from_arrays(&at.reflected));
            back = back + Vec3::all(specular * power(shine, material.power));
        }
        let sent = (intensity * back).keep(lit);
        at.colour = (Vec3::from_arrays(&at.colour) + sent).to_arrays();
    }
    rays
}
