//! Local light and the mirrored direction, for the lanes that met one primitive.

use catoptric_scene::{Compiled, DepthCount, Numerics, Phong, Shape};

use crate::lanes::{Lanes, Mask};
use crate::packet::{NONE, Rays, Surface};
use crate::power::power;
use crate::vec3::Vec3;
use crate::{ball, flat, textbook};

/// What the lanes that met one primitive take from it.
pub(crate) struct Shaded<L> {
    /// Ambient light and lamps.
    pub(crate) local: Vec3<L>,
    /// The mirror factor, the same for all lanes.
    pub(crate) k: f32,
    pub(crate) surface: Surface<L>,
    /// Directions of the mirrored rays.
    pub(crate) mirrored: Vec3<L>,
    /// What mirrored rays leave: the primitive, or [`NONE`].
    pub(crate) left: u32,
}

/// Shades the lanes that met primitive `index` at their `distance`. Counts shadow rays.
#[inline(always)]
pub(crate) fn shade<L: Lanes>(
    scene: &Compiled,
    index: u32,
    rays: &Rays<L>,
    distance: L,
    lanes: Mask<L>,
    count: &mut DepthCount,
) -> Shaded<L> {
    let primitive = &scene.primitives[index as usize];
    let material = &scene.materials[primitive.material as usize];
    let (surface, left) = match &primitive.shape {
        Shape::Ball(ball) => (ball::surface(ball, rays, distance), index),
        Shape::Flat(flat) => (flat::surface(flat, rays, distance), index),
        Shape::TextbookSphere(s) => (textbook::sphere_surface(s, rays, distance), NONE),
        Shape::TextbookPlane(p) => (textbook::plane_surface(p, rays, distance), NONE),
    };
    let mirrored = mirrored(scene.numerics, rays.direction, surface.normal);
    let local = local(scene, material, &surface, left, mirrored, lanes, count);
    Shaded { local, k: material.mirror, surface, mirrored, left }
}

/// d - 2 (d·n) n; robust: made a unit vector again by one Newton step.
#[inline(always)]
fn mirrored<L: Lanes>(numerics: Numerics, d: Vec3<L>, n: Vec3<L>) -> Vec3<L> {
    let v = d - n * (L::splat(2.0) * d.dot(n));
    match numerics {
        Numerics::Robust => v * (L::splat(1.5) - L::splat(0.5) * v.dot(v)),
        Numerics::Textbook => v,
    }
}

/// Ambient light plus what each visible lamp adds, in file order.
///
/// A lane that a lamp does not reach adds +0, which changes nothing: no colour is -0. Without
/// a highlight the recursion adds 0 · power, which changes nothing either.
#[inline(always)]
fn local<L: Lanes>(
    scene: &Compiled,
    material: &Phong,
    at: &Surface<L>,
    left: u32,
    mirrored: Vec3<L>,
    lanes: Mask<L>,
    count: &mut DepthCount,
) -> Vec3<L> {
    let mut colour = Vec3::splat(material.ambient);
    for lamp in &scene.lights {
        let to_lamp = Vec3::splat(lamp.position) - at.point;
        let distance = to_lamp.length();
        let l = to_lamp * (L::splat(1.0) / distance);
        let facing = at.normal.dot(l);
        let faces = lanes & facing.gt(L::splat(0.0));
        count.shadow += faces.count();
        if lamp.hidden || !faces.any() {
            continue;
        }
        let lit = visible(scene, at, left, l, distance, faces);
        if !lit.any() {
            continue;
        }
        let mut light = Vec3::splat(material.diffuse) * facing;
        if material.specular > 0.0 {
            let highlight = L::splat(material.specular) * power(l.dot(mirrored), material.power);
            light = light + Vec3 { x: highlight, y: highlight, z: highlight };
        }
        colour = colour + (Vec3::splat(lamp.intensity) * light).keep(lit);
    }
    colour
}

/// The lanes of `faces` between which and a lamp nothing stands.
#[inline(always)]
fn visible<L: Lanes>(
    scene: &Compiled,
    at: &Surface<L>,
    left: u32,
    l: Vec3<L>,
    distance: L,
    faces: Mask<L>,
) -> Mask<L> {
    let mut lit = faces;
    let rays = Rays { origin: at.start, direction: l, left: L::index(NONE) };
    for (index, primitive) in (0..).zip(&scene.primitives) {
        if index == left {
            continue;
        }
        let dark = match &primitive.shape {
            Shape::Ball(ball) => ball::occludes(ball, at.start, l, distance),
            Shape::Flat(flat) => flat::occludes(flat, at.start, l, distance),
            Shape::TextbookSphere(s) => {
                let root = textbook::sphere_distance(s, &rays);
                root.met & root.t.lt(distance)
            }
            Shape::TextbookPlane(p) => {
                let root = textbook::plane_distance(p, &rays);
                root.met & root.t.lt(distance)
            }
        };
        lit = lit.without(dark);
        if !lit.any() {
            break;
        }
    }
    lit
}
