//! Shading: local light, and the reflected rays that go on, for all hits of one primitive.

use catoptric_scene::{DepthCount, Numerics, PointLight, Scalar};
use glam::DVec3;

use super::frame::Frame;
use super::hit_groups::{HitGroup, HitGroups};
use super::light::{Illumination, add_light};
use super::nearest::{MetPrimitive, NearestHits};
use super::pending::ReturnSlot;
use super::points::{BATCH, ShadePoints};
use super::regroup::Regroup;
use super::stack::Stack;
use crate::omission::Omission;
use crate::ray::{Departing, NONE, RayQueue, Rays};
use crate::shape::{Shape, ShapeVisitor, dispatch};
use crate::simd::{LANES, Lane, Lanes, Mask, Vec3, in_f64};

/// Below this many shadow tests, culling occluders costs more than it saves.
const WORTH_BOUNDS: usize = 8;

/// Number of occluders that the lights' lists have room for, or all of one light if that is more. A
/// light whose list finds no room has it made anew for every [`BATCH`] of points.
const LISTED: usize = 1 << 14;

/// The bounce in flight, and what it fills: the stack and the next queue.
pub(crate) struct InFlight<'a, 'b, S: Lane> {
    pub(crate) queue: &'a RayQueue<S>,
    pub(crate) nearest: &'a NearestHits<S>,
    pub(crate) stack: &'a mut Stack<'b, S>,
    pub(crate) regroup: &'a mut Regroup<S>,
    pub(crate) next: &'a mut RayQueue<S>,
    /// Whether reflected rays are traced.
    pub(crate) followed: bool,
    /// Whether there is a cut by weight.
    pub(crate) cut: bool,
    pub(crate) count: DepthCount,
}

/// Room for what shading finds out about one primitive.
pub(crate) struct ShadeScratch<S> {
    groups: HitGroups<S>,
    /// The lights' lists of occluders, one after another, and where each ends; see [`LISTED`].
    occluders: Vec<u32>,
    ends: Vec<usize>,
    /// List of a light that found no room there.
    anew: Vec<u32>,
    points: [ShadePoints<S>; BATCH],
}

impl<S: Lane> ShadeScratch<S> {
    pub(crate) fn new(occluders: usize, lights: usize) -> Self {
        // One more: a place is written before it is known whether it counts.
        let one = occluders + 1;
        let (all, room) = (one * lights, if one > LISTED { one } else { LISTED });
        let (listed, anew) = if all > room { (room, one) } else { (all, 0) };
        Self {
            groups: HitGroups::new(),
            occluders: vec![0; listed],
            ends: vec![0; lights],
            anew: vec![0; anew],
            points: [ShadePoints::EMPTY; BATCH],
        }
    }
}

/// Shades the rays of a bounce that met one primitive, and counts them and their shadow rays.
pub(crate) struct Shade<'a, 'b, 'c, S: Lane> {
    pub(crate) frame: &'a Frame<'a, S>,
    pub(crate) met: MetPrimitive,
    pub(crate) flight: &'a mut InFlight<'b, 'c, S>,
    pub(crate) scratch: &'a mut ShadeScratch<S>,
}

impl<S: Lane> Shade<'_, '_, '_, S> {
    #[inline(always)]
    pub(crate) fn run<L: Lanes<Scalar = S>>(self) {
        let shape = &self.frame.scene.primitives[self.met.index as usize].shape;
        dispatch::<L, _, false>(shape, self);
    }
}

impl<S: Lane, L: Lanes<Scalar = S>> ShapeVisitor<L> for Shade<'_, '_, '_, S> {
    type Output = ();

    #[inline(always)]
    fn visit<F: Shape<L>>(self, shape: F) {
        let Self { frame, met, flight, scratch } = self;
        let (scene, index) = (frame.scene, met.index);
        let primitive = &scene.primitives[index as usize];
        let material = &scene.materials[primitive.material as usize];
        let followed = flight.followed && material.mirror > S::ZERO;
        let omissions = frame.omissions;
        let highlight = material.specular > S::ZERO || !omissions.contains(Omission::Directions);

        // Collect the hits.
        let ShadeScratch { groups, occluders, ends, anew, points } = scratch;
        let hits = groups.collect::<L, _>(shape, met, flight.queue, flight.nearest);
        if hits == 0 {
            return;
        }
        flight.count.hits += hits;

        // List what can stand between each light and any of them.
        let few = frame.occluders.len() * groups.all().len() < WORTH_BOUNDS;
        let (center, radius) = if few || !omissions.contains(Omission::Occluders) {
            (DVec3::ZERO, f64::INFINITY)
        } else {
            groups.bounds(anchor(shape))
        };
        let unlit = omissions.contains(Omission::Shadows) && material.is_unlit();
        let lights = if unlit { &frame.hidden_lights } else { &scene.lights };
        let receiver = Receiver { frame, center, radius, index };
        let mut end = 0;
        let mut listed = 0;
        for (light, light_end) in lights.iter().zip(&mut *ends) {
            let list = &mut occluders[end..];
            if list.len() <= frame.occluders.len() {
                break;
            }
            end += receiver.occluders::<L>(light, list);
            *light_end = end;
            listed += 1;
        }

        let ambient = Vec3::<L>::splat(material.ambient);
        for groups in groups.all().chunks(BATCH) {
            // Normals and reflected directions.
            let points = &mut points[..groups.len()];
            for (at, to) in groups.iter().zip(&mut *points) {
                let (live, direction) = match ReturnSlot::packet(&at.slots) {
                    Some(packet) => (LANES as u32, flight.queue.directions().packet(packet)),
                    None => (at.live, Vec3::from_arrays(&at.direction)),
                };
                let normal = shape.normal(Vec3::<L>::from_arrays(&at.arm), direction);
                to.normal = normal.to_arrays();
                if followed || highlight {
                    to.reflected = reflected(F::NUMERICS, direction, normal).to_arrays();
                }
                (to.colour, to.live) = (ambient.to_arrays(), live);
            }
            // Light after light.
            let mut start = 0;
            for (number, (light, &end)) in lights.iter().zip(&*ends).enumerate() {
                let occluders = if number < listed {
                    &occluders[start..end]
                } else {
                    let len = receiver.occluders::<L>(light, anew);
                    &anew[..len]
                };
                start = end;
                let cones = frame.occluders.cones(number);
                let from = Illumination { light, cones, occluders };
                flight.count.shadow +=
                    add_light::<L, F>(shape, frame, (material, highlight), from, groups, points);
            }
            // What is owed, and the rays that go on.
            for (at, point) in groups.iter().zip(&*points) {
                let local = Vec3::<L>::from_arrays(&point.colour);
                if followed {
                    let mirror = Mirror {
                        index,
                        material: primitive.material,
                        reflectance: material.mirror,
                    };
                    spawn_reflected::<L, F>(
                        shape,
                        frame.scene.min_weight,
                        mirror,
                        (at, point),
                        flight,
                    );
                } else {
                    flight.stack.push_end(local, &at.slots);
                }
            }
        }
    }
}

/// The anchor of a shape in f64, or the eye.
#[inline(always)]
fn anchor<L: Lanes, F: Shape<L>>(shape: F) -> DVec3 {
    match shape.anchor() {
        Some(anchor) => {
            let [x, y, z] = anchor.first();
            DVec3::new(x.to_f64(), y.to_f64(), z.to_f64())
        }
        None => DVec3::ZERO,
    }
}

/// Points on the primitive of that index, and a sphere that holds them.
#[derive(Clone, Copy)]
struct Receiver<'a, S: Lane> {
    frame: &'a Frame<'a, S>,
    center: DVec3,
    radius: f64,
    index: u32,
}

impl<S: Lane> Receiver<'_, S> {
    /// Puts the numbers of what can stand between a light and the points into `list`; how many.
    #[inline(always)]
    fn occluders<L: Lanes<Scalar = S>>(&self, light: &PointLight<S>, list: &mut [u32]) -> usize {
        if light.hidden {
            return 0;
        }
        let light = in_f64::<S>(light.position);
        self.frame.occluders.find::<L>(light, self.center, self.radius, self.index, list)
    }
}

/// d - 2 (d·n) n; robust: made a unit vector again by one Newton step.
#[inline(always)]
fn reflected<L: Lanes>(numerics: Numerics, d: Vec3<L>, n: Vec3<L>) -> Vec3<L> {
    let v = d - n * (L::constant(2.0) * d.dot(n));
    match numerics {
        Numerics::Robust => v * (L::constant(1.5) - L::constant(0.5) * v.dot(v)),
        Numerics::Textbook => v,
    }
}

/// What reflects: a primitive, its material and how much that reflects.
struct Mirror<S> {
    index: u32,
    material: u32,
    reflectance: S,
}

/// Sends on the reflected rays whose weight is not below the cut, and puts what they owe on the
/// stack.
///
/// Without a cut every weight passes, and weights are not even formed.
#[inline(always)]
fn spawn_reflected<L: Lanes, F: Shape<L>>(
    shape: F,
    min_weight: L::Scalar,
    mirror: Mirror<L::Scalar>,
    (group, at): (&HitGroup<L::Scalar>, &ShadePoints<L::Scalar>),
    flight: &mut InFlight<L::Scalar>,
) {
    // The rays.
    let from = match F::NUMERICS {
        Numerics::Robust => mirror.index,
        Numerics::Textbook => NONE,
    };
    let point = shape.point(Vec3::from_arrays(&group.arm));
    let origin = shape.start(point, Vec3::from_arrays(&at.normal));
    let rays = Rays { origin, direction: Vec3::from_arrays(&at.reflected) };
    let mut departing = Departing { rays, weight: None, from };
    let (local, slots) = (Vec3::from_arrays(&at.colour), &group.slots);

    // A whole packet goes on as it is.
    if !flight.cut && at.live as usize == LANES {
        flight.stack.push::<L>(local, slots, mirror.material, flight.next.len());
        flight.next.push(&departing);
        return;
    }
    let lanes = Mask::first(at.live);
    let mut goes_on = lanes;
    if flight.cut {
        let weight = match ReturnSlot::packet(slots) {
            Some(packet) => flight.queue.weights().packet::<L>(packet),
            None => flight.queue.weights().gather(|lane| slots[lane].slot()),
        };
        let product = weight * L::splat(mirror.reflectance);
        goes_on = goes_on & product.ge(L::splat(min_weight));
        departing.weight = Some(product);
    }
    if goes_on.all() {
        flight.stack.push::<L>(local, slots, mirror.material, flight.next.len());
        flight.next.push(&departing);
        return;
    }

    // Lanes whose path ends here owe their local light alone.
    let (colours, each) = (local.to_arrays(), ReturnSlot::each(slots, mirror.material));
    let ends = lanes.without(goes_on);
    if ends.any() {
        // Lanes that go on repeat the first one that ends.
        let set = ends.bits();
        let first = set.trailing_zeros() as usize % LANES;
        let Vec3 { x, y, z } = local;
        let all = Vec3 {
            x: ends.select(x, L::splat(colours[0][first])),
            y: ends.select(y, L::splat(colours[1][first])),
            z: ends.select(z, L::splat(colours[2][first])),
        };
        let mut ended = [each[first].ended(); LANES];
        for (lane, (ended, slot)) in ended.iter_mut().zip(each).enumerate() {
            if set >> lane & 1 != 0 {
                *ended = slot.ended();
            }
        }
        flight.stack.push_end(all, &ended);
    }

    // The others wait for company.
    flight.regroup.add(&departing, goes_on, (&colours, &each), flight.next, flight.stack);
}

#[cfg(test)]
mod tests {
    use super::{LISTED, ShadeScratch};

    #[test]
    fn lists_take_memory_by_lights_and_occluders_and_not_by_both() {
        for lights in [0, 1, 3, 1000, 100_000] {
            for occluders in [0, 1, 5, 100, 20_000] {
                let scratch = ShadeScratch::<f32>::new(occluders, lights);
                let taken = scratch.occluders.len() + scratch.anew.len() + scratch.ends.len();
                assert!(taken <= LISTED + 2 * (occluders + 1) + lights);
                // Without a second room, each light's list of all fits.
                let all = (occluders + 1) * lights;
                assert!(scratch.occluders.len() == all || scratch.anew.len() > occluders);
                assert!(lights == 0 || scratch.occluders.len() > occluders);
            }
        }
    }
}
