//! Shadows: which points an occluder hides the light from.

use catoptric_scene::Numerics;

use super::frame::Frame;
use super::hit_groups::HitGroup;
use super::points::{BATCH, ShadePoints};
use crate::cull::LightCones;
use crate::ray::Rays;
use crate::shape::{Shape, ShapeVisitor, dispatch};
use crate::simd::{Lanes, Mask, Vec3};

/// Darkens points occluder by occluder. `far`: the points beyond the reach of the light's cones.
///
/// A sphere is tested from those packets of points alone that its cone, or `far`, says it may hide
/// the light from.
#[inline(always)]
pub(crate) fn shadows_side_by_side<L: Lanes, F: Shape<L>>(
    shape: F,
    frame: &Frame<L::Scalar>,
    far: u32,
    (cones, occluders): (LightCones<L::Scalar>, &[u32]),
    groups: &[HitGroup<L::Scalar>],
    points: &mut [ShadePoints<L::Scalar>],
) {
    for &number in occluders {
        let packets = if frame.occluders.is_sphere(number) {
            far | reached::<L>(cones, number, points)
        } else {
            (1 << points.len()) - 1
        };
        let blocker = frame.occluders.shape(number);
        dispatch::<L, _, false>(blocker, Darken { shape, packets, groups, points: &mut *points });
    }
}

/// Darkens some packets of points on `shape`, packet i as bit i, where a blocker hides the light.
struct Darken<'a, L: Lanes, F> {
    shape: F,
    packets: u32,
    groups: &'a [HitGroup<L::Scalar>],
    points: &'a mut [ShadePoints<L::Scalar>],
}

impl<L: Lanes, F: Shape<L>> ShapeVisitor<L> for Darken<'_, L, F> {
    type Output = ();

    #[inline(always)]
    fn visit<B: Shape<L>>(self, blocker: B) {
        // A scene's forms are all of its numerics.
        if B::NUMERICS as u8 != F::NUMERICS as u8 {
            return;
        }
        let mut rest = self.packets;
        while rest != 0 {
            let packet = rest.trailing_zeros() as usize % BATCH;
            rest &= rest - 1;
            let origin = self.shape.point(Vec3::from_arrays(&self.groups[packet].arm));
            let shadow = &mut self.points[packet].shadow;
            let (direction, distance) = shadow.way();
            shadow.darken(blocker.blocks(&Rays { origin, direction }, distance));
        }
    }
}

/// Darkens points packet by packet, until a packet is dark. Textbook roots cost more than to find
/// that out, and so do occluders none of which is left out.
#[inline(always)]
pub(crate) fn shadows_in_turn<L: Lanes, F: Shape<L>>(
    shape: F,
    frame: &Frame<L::Scalar>,
    occluders: &[u32],
    groups: &[HitGroup<L::Scalar>],
    points: &mut [ShadePoints<L::Scalar>],
) {
    for (group, at) in groups.iter().zip(points) {
        let (direction, limit) = at.shadow.way::<L>();
        let point = shape.point(Vec3::from_arrays(&group.arm));
        let origin = shape.start(point, Vec3::from_arrays(&at.normal));
        let rays = Rays { origin, direction };
        let mut lit = at.shadow.lit::<L>();
        for &number in occluders {
            if !lit.any() {
                break;
            }
            let blocks = Blocks { numerics: F::NUMERICS, rays: &rays, limit };
            let dark = dispatch::<L, _, false>(frame.occluders.shape(number), blocks);
            lit = lit.without(dark);
        }
        at.shadow.lit = lit.to_array();
    }
}

/// The shadow test of one packet of points against a blocker.
struct Blocks<'a, L> {
    numerics: Numerics,
    rays: &'a Rays<L>,
    limit: L,
}

impl<L: Lanes> ShapeVisitor<L> for Blocks<'_, L> {
    type Output = Mask<L>;

    #[inline(always)]
    fn visit<B: Shape<L>>(self, blocker: B) -> Mask<L> {
        // A scene's forms are all of its numerics.
        if B::NUMERICS as u8 != self.numerics as u8 {
            return Mask::none();
        }
        blocker.blocks(self.rays, self.limit)
    }
}

/// The packets of points that a sphere may hide the light from, packet i as bit i; from no others
/// does it. Points beyond the reach of the cones are not asked for; a light without cones has none.
#[inline(always)]
fn reached<L: Lanes>(
    cones: LightCones<L::Scalar>,
    number: u32,
    points: &[ShadePoints<L::Scalar>],
) -> u32 {
    let Some(cone) = cones.cones.get(number as usize) else { return 0 };
    let (axis, cos) = (Vec3::<L>::splat(cone.axis), L::splat(cone.cos));
    let mut reached = 0;
    for at in points.iter().rev() {
        let outside = Vec3::from_arrays(&at.shadow.direction).dot(axis).lt(cos);
        let lit = at.shadow.lit::<L>();
        reached = reached * 2 + u32::from(lit.without(outside).any());
    }
    reached
}
