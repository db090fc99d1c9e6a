//! Local light, and the mirrored rays that go on, for all rays of a level that met one primitive.

use catoptric_scene::{Numerics, Phong, PointLight, Scalar, Shape};
use glam::DVec3;

use crate::hits::Hits;
use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::nearest::Nearest;
use crate::packet::{NONE, Rays, World};
use crate::plan::is_unlit;
use crate::power::power;
use crate::sight::in_f64;
use crate::stack::Pending;
use crate::surfaces::{Met, Origin, Surfaces};
use crate::vec3::Vec3;
use crate::wave::{Mirrored, PACKETS, Slot, Wave};
use crate::{ball, flat, textbook};

/// So many shadow tests are fewer than finding out which of them can be left out costs.
const WORTH_BOUNDS: usize = 8;

/// The level in flight, and the next.
pub(crate) struct Level<'a, S> {
    pub(crate) wave: &'a Wave<S>,
    pub(crate) nearest: &'a [Nearest<S>; PACKETS],
    pub(crate) hits: &'a mut Hits,
    pub(crate) pending: &'a mut [Pending<S>],
    pub(crate) next: &'a mut Wave<S>,
    pub(crate) next_pending: &'a mut [Pending<S>],
    /// Whether mirrored rays are traced.
    pub(crate) followed: bool,
}

/// Room for what shading finds out about one primitive.
pub(crate) struct Shading<S> {
    surfaces: Surfaces<S>,
    /// Of all lamps, one after another, and where each lamp's end.
    occluders: Vec<u32>,
    ends: Vec<usize>,
}

/// The lamps, and for each what can stand before it: a part of the list, up to its end.
#[derive(Clone, Copy)]
struct Lamps<'a, S: Scalar> {
    lights: &'a [PointLight<S>],
    occluders: &'a [u32],
    ends: &'a [usize],
}

/// Where eight rays met a primitive.
struct Place<L> {
    point: Vec3<L>,
    normal: Vec3<L>,
    /// Where shadow and mirrored rays start.
    start: Vec3<L>,
    mirrored: Vec3<L>,
}

impl<S: Lane> Shading<S> {
    pub(crate) fn new(occluders: usize, lamps: usize) -> Self {
        // One more: a place is written before it is known whether it counts.
        let occluders = vec![0; (occluders + 1) * lamps];
        Self { surfaces: Surfaces::new(), occluders, ends: vec![0; lamps] }
    }
}

/// Shades the rays of a level that met primitive `index`; how many shadow rays they have.
#[inline(always)]
pub(crate) fn shade<L: Lanes>(
    world: World<L::Scalar>,
    index: u32,
    level: &mut Level<L::Scalar>,
    shading: &mut Shading<L::Scalar>,
) -> u64 {
    let scene = world.scene;
    let primitive = &scene.primitives[index as usize];
    let material = &scene.materials[primitive.material as usize];
    let followed = level.followed && material.mirror > L::Scalar::ZERO;
    let highlight = material.specular > L::Scalar::ZERO || !world.omit.directions;
    let met = Met {
        wave: level.wave,
        nearest: level.nearest,
        hits: level.hits,
        index,
        numerics: scene.numerics,
        mirrors: followed || highlight,
    };
    let Shading { surfaces, occluders, ends } = shading;
    match &primitive.shape {
        Shape::Ball(ball) => surfaces.collect::<L, _>(*ball, met),
        Shape::Flat(flat) => surfaces.collect::<L, _>(*flat, met),
        Shape::TextbookSphere(sphere) => surfaces.collect::<L, _>(*sphere, met),
        Shape::TextbookPlane(plane) => surfaces.collect::<L, _>(*plane, met),
    }

    let few = world.occluders.len() * surfaces.all().len() < WORTH_BOUNDS;
    let (center, radius) =
        if few || !world.omit.occluders { (DVec3::ZERO, f64::INFINITY) } else { surfaces.bounds() };
    let mut end = 0;
    let unlit = world.omit.shadows && is_unlit(material);
    let lights = if unlit { world.hidden } else { &scene.lights };
    for (lamp, lamp_end) in lights.iter().zip(&mut *ends) {
        if !lamp.hidden {
            let lamp = in_f64::<L::Scalar>(lamp.position);
            let list = &mut occluders[end..];
            end += world.occluders.find::<L>(lamp, center, radius, index, list);
        }
        *lamp_end = end;
    }

    let lamps = Lamps { lights, occluders, ends };
    let mut shadow = 0;
    for at in surfaces.all() {
        let (point, normal) = (Vec3::from_arrays(&at.point), Vec3::from_arrays(&at.normal));
        let start = match &primitive.shape {
            Shape::Ball(_) | Shape::Flat(_) => point,
            Shape::TextbookSphere(sphere) => textbook::sphere_start(sphere, point),
            Shape::TextbookPlane(_) => textbook::plane_start(point, normal),
        };
        let place = Place { point, normal, start, mirrored: Vec3::from_arrays(&at.mirrored) };
        let lanes = match at.rays {
            Origin::Packet(_) => Mask::every(),
            Origin::Single(_, live) => Mask::first(live),
        };
        let colour = local::<L>(world, material, &place, lamps, lanes, &mut shadow);
        put(level.pending, &at.rays, colour);
        if followed {
            go_on(world, index, material.mirror, &place, lanes, &at.rays, level);
        }
    }
    shadow
}

/// Ambient light plus what each visible lamp adds, in file order.
///
/// A lane that a lamp does not reach adds +0, which changes nothing: no colour is -0. Without
/// a highlight the recursion adds 0 · power, which changes nothing either.
#[inline(always)]
fn local<L: Lanes>(
    world: World<L::Scalar>,
    material: &Phong<L::Scalar>,
    at: &Place<L>,
    lamps: Lamps<L::Scalar>,
    lanes: Mask<L>,
    shadow: &mut u64,
) -> Vec3<L> {
    let mut colour = Vec3::splat(material.ambient);
    let mut start = 0;
    for (lamp, &end) in lamps.lights.iter().zip(lamps.ends) {
        let occluders = &lamps.occluders[start..end];
        start = end;
        let to_lamp = Vec3::splat(lamp.position) - at.point;
        let distance = to_lamp.length();
        let l = to_lamp * (L::constant(1.0) / distance);
        let facing = at.normal.dot(l);
        let zero = L::constant(0.0);
        let faces = lanes & facing.gt(zero) & distance.gt(zero);
        *shadow += faces.count();
        if lamp.hidden || !faces.any() {
            continue;
        }
        let lit = visible(world, at, occluders, l, distance, faces);
        if !lit.any() {
            continue;
        }
        let mut light = Vec3::splat(material.diffuse) * facing;
        if material.specular > L::Scalar::ZERO || !world.omit.directions {
            let highlight = L::splat(material.specular) * power(l.dot(at.mirrored), material.power);
            light = light + Vec3::all(highlight);
        }
        colour = colour + (Vec3::splat(lamp.intensity) * light).keep(lit);
    }
    colour
}

/// The lanes of `faces` between which and a lamp none of `occluders` stands.
#[inline(always)]
fn visible<L: Lanes>(
    world: World<L::Scalar>,
    at: &Place<L>,
    occluders: &[u32],
    l: Vec3<L>,
    distance: L,
    faces: Mask<L>,
) -> Mask<L> {
    let mut lit = faces;
    let rays = Rays { origin: at.start, direction: l };
    for &index in occluders {
        let dark = match &world.scene.primitives[index as usize].shape {
            Shape::Ball(ball) => ball::occludes(ball, at.start, l, distance),
            Shape::Flat(flat) => flat::occludes(flat, at.start, l, distance),
            Shape::TextbookSphere(sphere) => {
                let root = textbook::sphere_distance(sphere, &rays);
                root.met & root.t.lt(distance)
            }
            Shape::TextbookPlane(plane) => {
                let root = textbook::plane_distance(plane, &rays);
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

/// Keeps local colours until what the mirrors show comes back.
#[inline(always)]
fn put<L: Lanes>(pending: &mut [Pending<L::Scalar>], rays: &Origin, colour: Vec3<L>) {
    let colour = colour.to_arrays();
    match rays {
        Origin::Packet(packet) => pending[*packet].colour = colour,
        Origin::Single(slots, live) => {
            for (lane, &slot) in slots[..*live].iter().enumerate() {
                let to = &mut pending[slot as usize / LANES].colour;
                for axis in 0..3 {
                    to[axis][slot as usize % LANES] = colour[axis][lane];
                }
            }
        }
    }
}

/// Adds the mirrored rays whose weight is not below the cut to the next wave.
///
/// Without a cut every weight passes, and weights are not even formed.
#[inline(always)]
fn go_on<L: Lanes>(
    world: World<L::Scalar>,
    index: u32,
    k: L::Scalar,
    at: &Place<L>,
    lanes: Mask<L>,
    rays: &Origin,
    level: &mut Level<L::Scalar>,
) {
    let left = match world.scene.numerics {
        Numerics::Robust => index,
        Numerics::Textbook => NONE,
    };
    let mut next = Mirrored { origin: at.start, direction: at.mirrored, weight: None, k, left };
    let mut goes_on = lanes;
    if world.scene.min_weight > L::Scalar::ZERO {
        let weight = match rays {
            Origin::Packet(packet) => L::from_array(*level.wave.weight(*packet)),
            Origin::Single(slots, live) => {
                let mut weight = [L::Scalar::ZERO; LANES];
                for (weight, &slot) in weight.iter_mut().zip(&slots[..*live]) {
                    *weight = level.wave.weight(slot as usize / LANES)[slot as usize % LANES];
                }
                L::from_array(weight)
            }
        };
        let product = weight * L::splat(k);
        goes_on = goes_on & product.ge(L::splat(world.scene.min_weight));
        next.weight = Some(product);
    }
    match rays {
        Origin::Packet(packet) if goes_on.all() => {
            level.next.push_packet(&next, *packet, level.next_pending);
        }
        Origin::Packet(packet) => {
            let mut slots: [Slot; LANES] = [0; LANES];
            for (lane, slot) in slots.iter_mut().enumerate() {
                *slot = (packet * LANES + lane) as Slot;
            }
            level.next.push_lanes(&next, goes_on, &slots, level.next_pending);
        }
        Origin::Single(slots, _) => {
            level.next.push_lanes(&next, goes_on, slots, level.next_pending);
        }
    }
}
