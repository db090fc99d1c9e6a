//! Which primitives can stand between a lamp and what it lights.
//!
//! The points of a level that are on one primitive lie in a ball of radius R around a point q.
//! All their ways to a lamp then lie within R of the segment from q to the lamp. A ball further
//! than R + r from that segment hides the lamp from none of them, and need not be tried.
//!
//! The reference decides on the foot of the perpendicular: between the ends, and within r of
//! the centre. In exact arithmetic that is no closer than the way itself. Its error is that of
//! the foot, at most 20u (|w| + R) with w from q to the centre, and of r^2, 4u relative; u is
//! half an ulp of 1, 6e-8 in f32. Here the square of the distance has to pass (R + r)^2 by 1e-5
//! of |w|^2 + (R + r)^2, so the distance itself passes R + r by more than 50u (|w| + R + r),
//! after the few u that are lost here.
//!
//! Where points are all over a primitive, that leaves little out. So there is a second bound, for
//! eight points at a time. Seen from the lamp a ball at distance D, centre to lamp, fills a cone
//! of sine r/D around its centre. A way that comes no closer to the centre than rho < D is outside
//! the cone of sine rho/D: l·axis is below sqrt(1 - (rho/D)^2), l being the unit vector to the lamp
//! and axis the one from the centre to the lamp. As said above, the reference finds x dark only
//! where rho is at most r(1 + 2u) + 20u |f|, f from x to the centre, and |f| is at most D more than
//! x's distance from the lamp. Within 1000 D of the lamp, rho/D is below r/D + 20 040u, which is r/D +
//! 1.2e-3 in f32. Here it is 1.4e-3 more. l, axis and their product are off by 12u; here the cosine
//! is 1e-5 less. Points further away are tried, and a ball that nearly touches the lamp, or is too
//! small or large for its squares to be rounded relative to their size, has no cone. A point so
//! near the lamp that the square of its distance is not rounded so, and l perhaps no unit vector,
//! is lit whether tried or not: its foot is within twice its distance, which the ball is far from.
//!
//! Both bounds take a way for one that ends in the lamp. From a ball it starts at the rounded point
//! and goes where the point would lead before it was rounded (`reference::trace::Surface::to`): it
//! passes the lamp by what the point was rounded by, at most 2u of the way from the eye to the point.
//! The first bound's R is so much larger than the points ask for. For the second, a point within
//! 1000 D of the lamp is at most 1000 D further from the eye: the sine is 2u of the lamp's distance
//! from the eye, over D, more; and 2000u, which fits in what it is widened by.
//!
//! A large sphere hides nothing where its height rises along the whole way, for the reference
//! asks for a height that falls at the start. Balls around the eye and planes hide nothing at
//! all. About textbook forms nothing is known. A comparison with NaN keeps the primitive.

use catoptric_scene::{Ball, Compiled, Flat, PointLight, Scalar, Shape};
use glam::DVec3;

use crate::lanes::{LANES, Lane, Lanes};
use crate::sight::in_f64;
use crate::vec3::{Packed, Vec3};

/// What bounds are widened by, relative; see above.
const MARGIN: f64 = 1e-5;

/// How far away a cone holds, in distances of its ball from the lamp.
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

/// And so many a ball and lamp.
const CONES_EACH: usize = 4;

/// The primitives that can stand before a lamp at all.
pub(crate) struct Occluders<S: Scalar> {
    /// Balls, eight at a time, and their indices; the last eight are filled up with nothing.
    eights: Vec<(Packed<S>, [S; LANES])>,
    balls: Vec<Ball<S>>,
    of_balls: Vec<u32>,
    flats: Vec<Flat<S>>,
    of_flats: Vec<u32>,
    /// Those that are always kept.
    textbook: Vec<u32>,
    /// Cones of the first lamps, one for each ball: 16 bytes in f32.
    cones: Vec<Cone<S>>,
    /// How far the cones of each such lamp hold.
    reaches: Vec<S>,
}

/// The directions to a lamp on which a ball may hide it, as unit vectors l: l·axis is not below cos.
#[derive(Clone, Copy)]
pub(crate) struct Cone<S: Scalar> {
    pub(crate) axis: S::Vec3,
    pub(crate) cos: S,
}

/// What is known of a lamp.
#[derive(Clone, Copy)]
pub(crate) struct Toward<'a, S: Scalar> {
    /// Of balls, by their number.
    pub(crate) cones: &'a [Cone<S>],
    /// How far away the cones hold.
    pub(crate) reach: S,
}

/// A primitive that can stand before a lamp.
pub(crate) enum Occluder<'a, S: Scalar> {
    /// Not around the eye.
    Ball(&'a Ball<S>),
    Flat(&'a Flat<S>),
    /// The primitive of that index.
    Textbook(u32),
}

/// Number of lamps that have cones: the first ones, as far as [`CONES`] or [`CONES_EACH`] allow, or none
/// in a picture that has no more packets of eye rays than there are balls.
///
/// A cone takes some 80 instructions before the first ray, and saves 13 of a packet's shadow test. So
/// cones take at most 10 instructions an eye ray and lamp, far less than 5 % of what lighting takes.
fn lamps_with_cones(balls: usize, lamps: usize, samples: usize) -> usize {
    if balls > samples / LANES {
        return 0;
    }
    lamps.min(most_cones(balls, lamps) / balls.max(1))
}

/// Cones that so many balls and lamps may have.
fn most_cones(balls: usize, lamps: usize) -> usize {
    CONES.max(CONES_EACH * (balls + lamps))
}

/// Bytes that the shadow cones of a scene take, at most, in f32.
#[must_use]
pub fn cone_bytes(balls: usize, lamps: usize) -> usize {
    balls.saturating_mul(lamps).min(most_cones(balls, lamps)) * size_of::<Cone<f32>>()
}

impl<S: Lane> Occluders<S> {
    /// Of the primitives of these indices, without cones.
    pub(crate) fn new(scene: &Compiled<S>, tried: &[u32]) -> Self {
        let mut these = Self {
            eights: Vec::new(),
            balls: Vec::new(),
            of_balls: Vec::new(),
            flats: Vec::new(),
            of_flats: Vec::new(),
            textbook: Vec::new(),
            cones: Vec::new(),
            reaches: Vec::new(),
        };
        for &index in tried {
            match &scene.primitives[index as usize].shape {
                Shape::Ball(ball) if ball.is_around() => {}
                Shape::Ball(ball) => {
                    let lane = these.of_balls.len() % LANES;
                    if lane == 0 {
                        these.eights.push(([[S::ZERO; LANES]; 3], [S::ZERO; LANES]));
                    }
                    let (center, radius) = these.eights.last_mut().expect("just made");
                    for (axis, x) in ball.center.into().into_iter().enumerate() {
                        center[axis][lane] = x;
                    }
                    radius[lane] = ball.radius;
                    these.balls.push(*ball);
                    these.of_balls.push(index);
                }
                Shape::Flat(flat) if flat.curvature > S::ZERO => {
                    these.flats.push(*flat);
                    these.of_flats.push(index);
                }
                Shape::Flat(_) => {}
                Shape::TextbookSphere(_) | Shape::TextbookPlane(_) => these.textbook.push(index),
            }
        }
        these
    }

    /// With cones, as shadows are found by, for a picture of so many samples. See [`lamps_with_cones`].
    pub(crate) fn with_cones(mut self, lights: &[PointLight<S>], samples: usize) -> Self {
        let with_cones = lamps_with_cones(self.balls.len(), lights.len(), samples);
        for lamp in lights.iter().take(with_cones) {
            let position = in_f64::<S>(lamp.position);
            let mut reach = f64::INFINITY;
            for ball in &self.balls {
                let (cone, held) = Cone::of(ball, position);
                self.cones.push(cone);
                reach = reach.min(held);
            }
            self.reaches.push(S::rounded(reach));
        }
        self
    }

    /// What is known of the lamp of that number. One without cones has none within its reach.
    #[inline(always)]
    pub(crate) fn toward(&self, lamp: usize) -> Toward<'_, S> {
        match self.reaches.get(lamp) {
            Some(&reach) => {
                let cones = &self.cones[lamp * self.balls.len()..][..self.balls.len()];
                Toward { cones, reach }
            }
            None => Toward { cones: &[], reach: S::ZERO },
        }
    }

    /// How many there can be for one lamp.
    pub(crate) fn len(&self) -> usize {
        self.balls.len() + self.flats.len() + self.textbook.len()
    }

    /// The one of that number: of balls, flats and textbook forms, one after another.
    #[inline(always)]
    pub(crate) fn get(&self, number: u32) -> Occluder<'_, S> {
        let number = number as usize;
        if let Some(ball) = self.balls.get(number) {
            Occluder::Ball(ball)
        } else if let Some(flat) = self.flats.get(number - self.balls.len()) {
            Occluder::Flat(flat)
        } else {
            Occluder::Textbook(self.textbook[number - self.balls.len() - self.flats.len()])
        }
    }

    /// Index of the primitive of that number.
    pub(crate) fn index(&self, number: u32) -> u32 {
        let mut all = self.of_balls.iter().chain(&self.of_flats).chain(&self.textbook);
        *all.nth(number as usize).expect("a number that was found")
    }

    /// Puts the numbers of those that can stand between a lamp and points within `radius` of
    /// `center`, a point of the scalar, on primitive `left` into `list`; how many.
    #[inline(always)]
    pub(crate) fn find<L: Lanes<Scalar = S>>(
        &self,
        lamp: DVec3,
        center: DVec3,
        radius: f64,
        left: u32,
        list: &mut [u32],
    ) -> usize {
        let mut len = 0;
        let mut number = 0;
        let to_lamp = lamp - center;
        let distance = to_lamp.length();
        let axis = to_lamp * (1.0 / distance);
        let q =
            Vec3 { x: L::constant(center.x), y: L::constant(center.y), z: L::constant(center.z) };
        let axis = Vec3 { x: L::constant(axis.x), y: L::constant(axis.y), z: L::constant(axis.z) };
        let (zero, distance) = (L::constant(0.0), L::constant(distance));
        for ((c, r), of) in self.eights.iter().zip(self.of_balls.chunks(LANES)) {
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
                len += usize::from(of[lane] != left);
            }
            number += of.len() as u32;
        }
        for (flat, index) in self.flats.iter().zip(&self.of_flats) {
            list[len] = number;
            number += 1;
            len += usize::from(*index != left && !rises(flat, lamp, center, radius));
        }
        for _ in &self.textbook {
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

    /// That of a ball, and how far from the lamp it holds.
    fn of(ball: &Ball<S>, lamp: DVec3) -> (Self, f64) {
        let to_lamp = lamp - in_f64::<S>(ball.center);
        let (distance, radius) = (to_lamp.length(), ball.radius.to_f64());
        let sin = (radius + POINT * lamp.length()) / distance + SPREAD;
        if !(sin < 0.9 && SMALLEST < radius && distance < LARGEST) {
            return (Self::everywhere(), f64::INFINITY);
        }
        let cos = (1.0 - sin * sin).sqrt() - MARGIN;
        let axis = (to_lamp / distance).to_array().map(S::rounded);
        (Self { axis: axis.into(), cos: S::rounded(cos) }, REACH * distance)
    }
}

/// Whether the height over a flat rises on every way to the lamp, from its start.
///
/// At q + e it rises with (N(q) + curvature·e)·(lamp - q - e), |e| at most the radius. The
/// reference's slope is off by 20u of the lengths of its terms.
#[inline(always)]
fn rises<S: Scalar>(flat: &Flat<S>, lamp: DVec3, q: DVec3, radius: f64) -> bool {
    let (lean, curvature) = (in_f64::<S>(flat.lean), flat.curvature.to_f64());
    let gradient: DVec3 = q * curvature - lean;
    let to_lamp = lamp - q;
    let far = to_lamp.length() + radius;
    let least = gradient.dot(to_lamp) - radius * (gradient.length() + curvature * far);
    least > MARGIN * far * (curvature * (q.length() + radius) + lean.length())
}

#[cfg(test)]
mod tests {
    use super::{CONES, CONES_EACH, lamps_with_cones};

    /// Lamps, balls and samples of scenes small and large.
    #[test]
    fn cones_take_memory_by_lamps_and_balls_and_not_by_both() {
        for lamps in [0, 1, 2, 10, 1000, 100_000] {
            for balls in [0, 1, 5, 100, 20_000, 1_000_000] {
                for samples in [1, 512, 640 * 480, 1 << 30] {
                    let with_cones = lamps_with_cones(balls, lamps, samples);
                    let most = CONES + CONES_EACH * (lamps + balls);
                    assert!(with_cones <= lamps && with_cones * balls <= most);
                    let few_samples = balls > samples / 8;
                    assert!(!few_samples || with_cones == 0, "{balls} balls, {samples} samples");
                    let few = lamps * balls <= CONES && !few_samples;
                    assert!(!few || with_cones == lamps, "{lamps} lamps, {balls} balls");
                }
            }
        }
        assert_eq!(lamps_with_cones(1_000_000, 3, 1 << 30), 3, "usual scenes have all");
    }
}
