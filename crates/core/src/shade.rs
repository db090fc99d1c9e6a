//! Local light, and the mirrored rays that go on, for all rays of a level that met one primitive.

use catoptric_scene::{DepthCount, Numerics, PointLight, Scalar, Shape};
use glam::DVec3;

use crate::ball::Ball;
use crate::flat::Flat;
use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::light::{Lamp, Place, SIDE_BY_SIDE, light};
use crate::nearest::{Form, Found, Nearest};
use crate::packet::{NONE, Rays, World};
use crate::plan::is_unlit;
use crate::sight::in_f64;
use crate::stack::{Owed, Stack};
use crate::surfaces::{Met, Surface, Surfaces};
use crate::textbook::{TextbookPlane, TextbookSphere};
use crate::vec3::Vec3;
use crate::wave::{Mirrored, Wave};

/// Below this many shadow tests, finding out which can be left out costs more than it saves.
const WORTH_BOUNDS: usize = 8;

/// Number of occluders that the lamps' lists have room for, or all of one lamp if that is more. A lamp
/// whose list finds no room has it made anew for every [`SIDE_BY_SIDE`] places.
const LISTED: usize = 1 << 14;

/// The level in flight, and the next.
pub(crate) struct Level<'a, 'b, S: Lane> {
    pub(crate) wave: &'a Wave<S>,
    pub(crate) nearest: &'a Nearest<S>,
    pub(crate) stack: &'a mut Stack<'b, S>,
    pub(crate) next: &'a mut Wave<S>,
    /// Whether mirrored rays are traced.
    pub(crate) followed: bool,
    /// Whether there is a cut by weight.
    pub(crate) cut: bool,
    pub(crate) count: DepthCount,
}

/// Room for what shading finds out about one primitive.
pub(crate) struct Shading<S> {
    surfaces: Surfaces<S>,
    /// Lists of lamps, one after another, and where each ends; see [`LISTED`].
    occluders: Vec<u32>,
    ends: Vec<usize>,
    /// List of a lamp that found no room there.
    anew: Vec<u32>,
    places: [Place<S>; SIDE_BY_SIDE],
}

/// What eight rays owe on the return.
struct Owes<'a, L: Lanes> {
    local: Vec3<L>,
    rays: &'a [Owed; LANES],
    material: u32,
    k: L::Scalar,
}

impl<S: Lane> Shading<S> {
    pub(crate) fn new(occluders: usize, lamps: usize) -> Self {
        // One more: a place is written before it is known whether it counts.
        let one = occluders + 1;
        let (all, room) = (one * lamps, if one > LISTED { one } else { LISTED });
        let (listed, anew) = if all > room { (room, one) } else { (all, 0) };
        Self {
            surfaces: Surfaces::new(),
            occluders: vec![0; listed],
            ends: vec![0; lamps],
            anew: vec![0; anew],
            places: [Place::EMPTY; SIDE_BY_SIDE],
        }
    }
}

/// Shades the rays of a level that met one primitive, and counts them and their shadow rays.
#[inline(always)]
pub(crate) fn shade<L: Lanes>(
    world: World<L::Scalar>,
    found: Found,
    level: &mut Level<L::Scalar>,
    shading: &mut Shading<L::Scalar>,
) {
    match &world.scene.primitives[found.index as usize].shape {
        Shape::Ball(ball) => shade_form(Ball::<L>::splat(ball), world, found, level, shading),
        Shape::Flat(flat) => shade_form(Flat::<L>::splat(flat), world, found, level, shading),
        Shape::TextbookSphere(sphere) => {
            shade_form(TextbookSphere::<L>::splat(sphere), world, found, level, shading);
        }
        Shape::TextbookPlane(plane) => {
            shade_form(TextbookPlane::<L>::splat(plane), world, found, level, shading);
        }
    }
}

/// [`shade`] for a primitive of one form.
#[inline(always)]
fn shade_form<L: Lanes, F: Form<L>>(
    form: F,
    world: World<L::Scalar>,
    found: Found,
    level: &mut Level<L::Scalar>,
    shading: &mut Shading<L::Scalar>,
) {
    let (scene, index) = (world.scene, found.index);
    let primitive = &scene.primitives[index as usize];
    let material = &scene.materials[primitive.material as usize];
    let followed = level.followed && material.mirror > L::Scalar::ZERO;
    let highlight = material.specular > L::Scalar::ZERO || !world.omit.directions;
    let Shading { surfaces, occluders, ends, anew, places } = shading;
    let met = Met { wave: level.wave, nearest: level.nearest, found };
    let hits = surfaces.collect::<L, _>(form, met);
    if hits == 0 {
        return;
    }
    level.count.hits += hits;

    let few = world.occluders.len() * surfaces.all().len() < WORTH_BOUNDS;
    let (center, radius) = if few || !world.omit.occluders {
        (DVec3::ZERO, f64::INFINITY)
    } else {
        surfaces.bounds(anchor(&primitive.shape))
    };
    let unlit = world.omit.shadows && is_unlit(material);
    let lights = if unlit { world.hidden } else { &scene.lights };
    let lit = Lit { world, center, radius, index };
    let mut end = 0;
    let mut listed = 0;
    for (lamp, lamp_end) in lights.iter().zip(&mut *ends) {
        let list = &mut occluders[end..];
        if list.len() <= world.occluders.len() {
            break;
        }
        end += lit.find::<L>(lamp, list);
        *lamp_end = end;
        listed += 1;
    }

    let ambient = Vec3::<L>::splat(material.ambient);
    for surfaces in surfaces.all().chunks(SIDE_BY_SIDE) {
        let places = &mut places[..surfaces.len()];
        for (at, to) in surfaces.iter().zip(&mut *places) {
            let (live, direction) = match Owed::packet(&at.rays) {
                Some(packet) => (LANES as u32, level.wave.directions().packet(packet)),
                None => (at.live, Vec3::from_arrays(&at.direction)),
            };
            let normal = form.normal(Vec3::<L>::from_arrays(&at.arm), direction);
            to.normal = normal.to_arrays();
            if followed || highlight {
                to.mirrored = mirrored(F::NUMERICS, direction, normal).to_arrays();
            }
            (to.colour, to.live) = (ambient.to_arrays(), live);
        }
        let mut start = 0;
        for (number, (lamp, &end)) in lights.iter().zip(&*ends).enumerate() {
            let occluders = if number < listed {
                &occluders[start..end]
            } else {
                let len = lit.find::<L>(lamp, anew);
                &anew[..len]
            };
            start = end;
            let lamp = Lamp { lamp, toward: world.occluders.toward(number), occluders };
            level.count.shadow +=
                light::<L, F>(form, world, material, highlight, lamp, surfaces, places);
        }
        for (at, place) in surfaces.iter().zip(&*places) {
            let local = Vec3::<L>::from_arrays(&place.colour);
            if followed {
                let owes = Owes {
                    local,
                    rays: &at.rays,
                    material: primitive.material,
                    k: material.mirror,
                };
                go_on::<L, F>(form, world, index, (at, place), owes, level);
            } else {
                level.stack.push(local, &at.rays, Owed::END);
            }
        }
    }
}

/// [`Form::anchor`] in f64.
#[inline(always)]
fn anchor<S: Scalar>(shape: &Shape<S>) -> DVec3 {
    match shape {
        Shape::Ball(ball) => in_f64::<S>(ball.center),
        _ => DVec3::ZERO,
    }
}

/// Points on a primitive, and a ball that holds them.
#[derive(Clone, Copy)]
struct Lit<'a, S: Scalar> {
    world: World<'a, S>,
    center: DVec3,
    radius: f64,
    index: u32,
}

impl<S: Lane> Lit<'_, S> {
    /// Puts the numbers of what can stand between a lamp and the points into `list`; how many.
    #[inline(always)]
    fn find<L: Lanes<Scalar = S>>(&self, lamp: &PointLight<S>, list: &mut [u32]) -> usize {
        if lamp.hidden {
            return 0;
        }
        let lamp = in_f64::<S>(lamp.position);
        self.world.occluders.find::<L>(lamp, self.center, self.radius, self.index, list)
    }
}

/// d - 2 (d·n) n; robust: made a unit vector again by one Newton step.
#[inline(always)]
fn mirrored<L: Lanes>(numerics: Numerics, d: Vec3<L>, n: Vec3<L>) -> Vec3<L> {
    let v = d - n * (L::constant(2.0) * d.dot(n));
    match numerics {
        Numerics::Robust => v * (L::constant(1.5) - L::constant(0.5) * v.dot(v)),
        Numerics::Textbook => v,
    }
}

/// Adds the mirrored rays whose weight is not below the cut to the next wave.
///
/// Without a cut every weight passes, and weights are not even formed.
#[inline(always)]
fn go_on<L: Lanes, F: Form<L>>(
    form: F,
    world: World<L::Scalar>,
    index: u32,
    (surface, at): (&Surface<L::Scalar>, &Place<L::Scalar>),
    owes: Owes<L>,
    level: &mut Level<L::Scalar>,
) {
    let left = match F::NUMERICS {
        Numerics::Robust => index,
        Numerics::Textbook => NONE,
    };
    let point = form.point(Vec3::from_arrays(&surface.arm));
    let start = form.start(point, Vec3::from_arrays(&at.normal));
    let rays_on = Rays { origin: start, direction: Vec3::from_arrays(&at.mirrored) };
    let mut next = Mirrored { rays: rays_on, weight: None, left };
    if !level.cut && at.live as usize == LANES {
        level.next.push(&next);
        level.stack.push(owes.local, owes.rays, owes.material);
        return;
    }
    let lanes = Mask::first(at.live);
    let mut goes_on = lanes;
    if level.cut {
        let weight = match Owed::packet(owes.rays) {
            Some(packet) => level.wave.weights().packet::<L>(packet),
            None => level.wave.weights().gather(|lane| owes.rays[lane].slot()),
        };
        let product = weight * L::splat(owes.k);
        goes_on = goes_on & product.ge(L::splat(world.scene.min_weight));
        next.weight = Some(product);
    }
    if goes_on.all() {
        level.next.push(&next);
        level.stack.push(owes.local, owes.rays, owes.material);
        return;
    }
    let (local, owed) = (owes.local.to_arrays(), Owed::each(owes.rays, owes.material));
    let ends = lanes.without(goes_on);
    if ends.any() {
        // Lanes that go on repeat the first one that ends.
        let set = ends.bits();
        let first = set.trailing_zeros() as usize % LANES;
        let Vec3 { x, y, z } = owes.local;
        let all = Vec3 {
            x: ends.select(x, L::splat(local[0][first])),
            y: ends.select(y, L::splat(local[1][first])),
            z: ends.select(z, L::splat(local[2][first])),
        };
        let mut ended = [owed[first].ended(); LANES];
        for (lane, (ended, owed)) in ended.iter_mut().zip(owed).enumerate() {
            if set >> lane & 1 != 0 {
                *ended = owed.ended();
            }
        }
        level.stack.push(all, &ended, 0);
    }
    level.next.push_lanes(&next, goes_on, &local, &owed, level.stack);
}

#[cfg(test)]
mod tests {
    use super::{LISTED, Shading};

    #[test]
    fn lists_take_memory_by_lamps_and_occluders_and_not_by_both() {
        for lamps in [0, 1, 3, 1000, 100_000] {
            for occluders in [0, 1, 5, 100, 20_000] {
                let shading = Shading::<f32>::new(occluders, lamps);
                let taken = shading.occluders.len() + shading.anew.len() + shading.ends.len();
                assert!(taken <= LISTED + 2 * (occluders + 1) + lamps);
                // Without a second room, each lamp's list of all fits.
                let all = (occluders + 1) * lamps;
                assert!(shading.occluders.len() == all || shading.anew.len() > occluders);
                assert!(lamps == 0 || shading.occluders.len() > occluders);
            }
        }
    }
}
