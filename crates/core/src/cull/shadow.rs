//! Shadow culling: the primitives that can stand between a light and what it lights.
//!
//! The points of a bounce that are on one primitive lie in a sphere of radius R around a point q.
//! All their ways to a light then lie within R of the segment from q to the light. A sphere further
//! than R + r from that segment hides the light from none of them, and need not be tested.
//!
//! The reference decides on the foot of the perpendicular: between the ends, and within r of
//! the centre. In exact arithmetic that is no closer than the way itself. Its error is that of
//! the foot, at most 20u (|w| + R) with w from q to the centre, and of r^2, 4u relative; u is
//! half an ulp of 1, 6e-8 in f32. Here the square of the distance has to pass (R + r)^2 by 1e-5
//! of |w|^2 + (R + r)^2, so the distance itself passes R + r by more than 50u (|w| + R + r),
//! after the few u that are lost here.
//!
//! Where points are all over a primitive, that leaves little out. So there is a second bound, for
//! eight points at a time. Seen from the light a sphere at distance D, centre to light, fills a
//! cone of sine r/D around its centre. A way that comes no closer to the centre than rho < D is
//! outside the cone of sine rho/D: l·axis is below sqrt(1 - (rho/D)^2), l being the unit vector to
//! the light and axis the one from the centre to the light. As said above, the reference finds x
//! dark only where rho is at most r(1 + 2u) + 20u |f|, f from x to the centre, and |f| is at most D
//! more than x's distance from the light. Within 1000 D of the light, rho/D is below r/D + 20 040u,
//! which is r/D + 1.2e-3 in f32. Here it is 1.4e-3 more. l, axis and their product are off by 12u;
//! here the cosine is 1e-5 less. Points further away are tested, and a sphere that nearly touches
//! the light, or is too small or large for its squares to be rounded relative to their size, has no
//! cone. A point so near the light that the square of its distance is not rounded so, and l perhaps
//! no unit vector, is lit whether tried or not: its foot is within twice its distance, which the
//! sphere is far from.
//!
//! Both bounds take a way for one that ends in the light. From a sphere it starts at the rounded
//! point and goes where the point would lead before it was rounded (`reference`'s `Surface::to`):
//! it passes the light by what the point was rounded by, at most 2u of the way from the eye to the
//! point. The first bound's R is so much larger than the points ask for. For the second, a point
//! within 1000 D of the light is at most 1000 D further from the eye: the sine is 2u of the light's
//! distance from the eye, over D, more; and 2000u, which fits in what it is widened by.
//! This rests on centres that are not far beyond the points: a robust sphere's radius is below 4 times
//! the eye's distance from its surface. A form with an anchor farther away needs wider bounds.
//!
//! A large sphere hides nothing where its height rises along the whole way, for the reference
//! asks for a height that falls at the start. Spheres around the eye and planes hide nothing at
//! all. About textbook forms nothing is known. A comparison with NaN keeps the primitive.

use catoptric_scene::{Compiled, PointLight, Scalar, Shape};
use glam::DVec3;

use crate::shape::{Blocker, Horizon, facts};
use crate::simd::{LANES, Lane, Lanes, Packed, Vec3, in_f64};

/// What bounds are widened by, relative; see above.
const MARGIN: f64 = 1e-5;

/// How far away a cone holds, in distances of its sphere from the light.
const REACH: f64 = 1000.0;

/// What the sine of a cone is widened by; see above.
const SPREAD: f64 = 1.4e-3;

/// What a point is rounded by, at most, relative to its distance from the eye: above 2u.
pub(crate) const POINT: f64 = 2e-7;

/// Squares of lengths between these are normal numbers of every scalar, also [`REACH`] times the
/// larger one's.
const SMALLEST: f64 = 1e-15;
const LARGEST: f64 = 1e15;

/// Number of cones that are always allowed: a megabyte in f32.
const CONES: usize = 1 << 16;

/// Cones that are allowed a sphere and light, where that is more.
const CONES_EACH: usize = 4;

/// The primitives that can stand before a light at all, by number: spheres, then large spheres,
/// then those of which nothing is known.
pub(crate) struct Occluders<S: Scalar> {
    /// The shape of each, and its index in the scene.
    shapes: Vec<Shape<S>>,
    indices: Vec<u32>,
    /// Spheres, eight at a time: centres and radii. The last eight are filled up with nothing.
    eights: Vec<(Packed<S>, [S; LANES])>,
    /// How many of the shapes are spheres.
    spheres: usize,
    /// Large spheres, whose numbers follow.
    horizons: Vec<Horizon>,
    /// Cones of the first lights, one for each sphere: 16 bytes in f32.
    cones: Vec<Cone<S>>,
    /// How far the cones of each such light hold.
    reaches: Vec<S>,
}

/// The directions to a light on which a sphere may hide it, as unit vectors l: l·axis is not below
/// cos.
#[derive(Clone, Copy)]
pub(crate) struct Cone<S: Scalar> {
    pub(crate) axis: S::Vec3,
    pub(crate) cos: S,
}

/// The shadow cones towards one light.
#[derive(Clone, Copy)]
pub(crate) struct LightCones<'a, S: Scalar> {
    /// One for each sphere, by its number; none where the light has none.
    pub(crate) cones: &'a [Cone<S>],
    /// How far from the light they hold.
    pub(crate) reach: S,
}

/// Number of lights that have cones: the first ones, as far as [`CONES`] or [`CONES_EACH`] allow,
/// or none in a picture that has no more packets of eye rays than there are spheres.
///
/// A cone takes some 80 instructions before the first ray, and saves 13 of a packet's shadow test.
/// So cones take at most 10 instructions an eye ray and light, far less than 5 % of what lighting
/// takes.
fn lights_with_cones(spheres: usize, lights: usize, samples: usize) -> usize {
    if spheres > samples / LANES {
        return 0;
    }
    lights.min(most_cones(spheres, lights) / spheres.max(1))
}

/// Cones that so many spheres and lights may have.
fn most_cones(spheres: usize, lights: usize) -> usize {
    CONES.max(CONES_EACH * (spheres + lights))
}

/// Bytes that the shadow cones of a scene take, at most, in f32.
#[must_use]
pub fn cone_bytes(spheres: usize, lights: usize) -> usize {
    spheres.saturating_mul(lights).min(most_cones(spheres, lights)) * size_of::<Cone<f32>>()
}

impl<S: Lane> Occluders<S> {
    /// The occluders among some primitives, without cones.
    pub(crate) fn new(scene: &Compiled<S>, candidates: &[u32]) -> Self {
        let (mut spheres, mut large, mut unknown) = (Vec::new(), Vec::new(), Vec::new());
        let (mut eights, mut horizons) = (Vec::new(), Vec::new());
        for &index in candidates {
            let shape = scene.primitives[index as usize].shape;
            let facts = facts(&shape);
            match (facts.blocker(), facts.sphere()) {
                (Blocker::Nowhere, _) => {}
                (Blocker::Sphere, Some((center, radius))) => {
                    let lane = spheres.len() % LANES;
                    if lane == 0 {
                        eights.push(([[S::ZERO; LANES]; 3], [S::ZERO; LANES]));
                    }
                    let (centers, radii) = eights.last_mut().expect("just made");
                    for (axis, x) in center.to_array().into_iter().enumerate() {
                        centers[axis][lane] = S::rounded(x);
                    }
                    radii[lane] = S::rounded(radius);
                    spheres.push((shape, index));
                }
                (Blocker::Horizon(horizon), _) => {
                    horizons.push(horizon);
                    large.push((shape, index));
                }
                _ => unknown.push((shape, index)),
            }
        }
        let of_spheres = spheres.len();
        let (shapes, indices) = spheres.into_iter().chain(large).chain(unknown).unzip();
        Self {
            shapes,
            indices,
            eights,
            spheres: of_spheres,
            horizons,
            cones: Vec::new(),
            reaches: Vec::new(),
        }
    }

    /// Adds the shadow cones that lights are culled with, one a light and sphere, for a picture of
    /// so many samples; see [`lights_with_cones`].
    pub(crate) fn with_cones(mut self, lights: &[PointLight<S>], samples: usize) -> Self {
        let with_cones = lights_with_cones(self.spheres, lights.len(), samples);
        for light in lights.iter().take(with_cones) {
            let position = in_f64::<S>(light.position);
            let mut reach = f64::INFINITY;
            for shape in &self.shapes[..self.spheres] {
                let (cone, held) = Cone::new(shape, position);
                self.cones.push(cone);
                reach = reach.min(held);
            }
            self.reaches.push(S::rounded(reach));
        }
        self
    }

    /// The cones of the light of that number. One without cones has none within its reach.
    #[inline(always)]
    pub(crate) fn cones(&self, light: usize) -> LightCones<'_, S> {
        match self.reaches.get(light) {
            Some(&reach) => {
                let cones = &self.cones[light * self.spheres..][..self.spheres];
                LightCones { cones, reach }
            }
            None => LightCones { cones: &[], reach: S::ZERO },
        }
    }

    /// How many there are, before any light.
    pub(crate) fn len(&self) -> usize {
        self.shapes.len()
    }

    /// Whether the occluder of that number is a sphere, which has a cone.
    #[inline(always)]
    pub(crate) fn is_sphere(&self, number: u32) -> bool {
        (number as usize) < self.spheres
    }

    /// The shape of the occluder of that number.
    #[inline(always)]
    pub(crate) fn shape(&self, number: u32) -> &Shape<S> {
        &self.shapes[number as usize]
    }

    /// Index of the primitive of that number.
    pub(crate) fn index(&self, number: u32) -> u32 {
        self.indices[number as usize]
    }

    /// Puts the numbers of those that can stand between a light and points within `radius` of
    /// `center`, a point of the scalar, on primitive `from` into `list`; how many.
    #[inline(always)]
    pub(crate) fn find<L: Lanes<Scalar = S>>(
        &self,
        light: DVec3,
        center: DVec3,
        radius: f64,
        from: u32,
        list: &mut [u32],
    ) -> usize {
        let mut len = 0;
        let mut number = 0;
        let to_light = light - center;
        let distance = to_light.length();
        let axis = to_light * (1.0 / distance);
        let q =
            Vec3 { x: L::constant(center.x), y: L::constant(center.y), z: L::constant(center.z) };
        let axis = Vec3 { x: L::constant(axis.x), y: L::constant(axis.y), z: L::constant(axis.z) };
        let (zero, distance) = (L::constant(0.0), L::constant(distance));
        // Spheres: those outside of the capsule around the ways to the light are left out.
        let (of_spheres, others) = self.indices.split_at(self.spheres);
        for ((c, r), of) in self.eights.iter().zip(of_spheres.chunks(LANES)) {
            let (w, r) = (Vec3::from_arrays(c) - q, L::from_array(*r));
            let along = w.dot(axis);
            let along = along.lt(zero).select(zero, along);
            let along = distance.lt(along).select(distance, along);
            let v = w - axis * along;
            let both = L::constant(radius) + r;
            let limit = both * both + L::constant(MARGIN) * (w.dot(w) + both * both);
            let mut rest = !v.dot(v).gt(limit).bits() & ((1 << of.len()) - 1);
            while rest != 0 {
                let lane = rest.trailing_zeros() as usize;
                rest &= rest - 1;
                list[len] = number + lane as u32;
                len += usize::from(of[lane] != from);
            }
            number += of.len() as u32;
        }
        // Large spheres: those that all ways leave at once.
        for (horizon, index) in self.horizons.iter().zip(others) {
            list[len] = number;
            number += 1;
            len += usize::from(*index != from && !horizon.is_left(light, center, radius));
        }
        // Nothing is known of the others.
        for _ in &others[self.horizons.len()..] {
            list[len] = number;
            number += 1;
            len += 1;
        }
        len
    }
}

impl<S: Scalar> Cone<S> {
    /// All directions.
    fn everywhere() -> Self {
        Self { axis: [S::ZERO; 3].into(), cos: S::ZERO }
    }

    /// The cone of a shape that is a sphere, and how far from the light it holds.
    fn new(shape: &Shape<S>, light: DVec3) -> (Self, f64) {
        let Some((center, radius)) = facts(shape).sphere() else {
            return (Self::everywhere(), f64::INFINITY);
        };
        let to_light = light - center;
        let distance = to_light.length();
        let sin = (radius + POINT * light.length()) / distance + SPREAD;
        if !(sin < 0.9 && SMALLEST < radius && distance < LARGEST) {
            return (Self::everywhere(), f64::INFINITY);
        }
        let cos = (1.0 - sin * sin).sqrt() - MARGIN;
        let axis = (to_light / distance).to_array().map(S::rounded);
        (Self { axis: axis.into(), cos: S::rounded(cos) }, REACH * distance)
    }
}

#[cfg(test)]
mod tests;
