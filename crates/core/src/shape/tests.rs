//! The formulas of every form: the same on every instruction set, and in a lane whatever the others
//! hold.

mod cases;

use catoptric_scene::{Scalar, Shape as AnyShape};

use super::{Foot, Shape, ShapeVisitor, dispatch};
use crate::ray::{Distance, Rays};
use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, Mask, Packed, Vec3, run};

/// Eight rays, and which of them left the shape.
#[derive(Clone, Copy, Debug)]
struct Eight<S> {
    origin: Packed<S>,
    direction: Packed<S>,
    on_self: [S; LANES],
    /// Limit of the shadow rays.
    limit: [S; LANES],
}

/// What a form answers, by name. Where a distance is not met it is not told.
type Answers<S> = Vec<(&'static str, [S; LANES])>;

/// All questions of one form. `APART`: as rays are tested; else as points are shaded.
struct Ask<'a, S: Scalar, const APART: bool>(&'a AnyShape<S>, Eight<S>);

impl<S: TestScalar, const APART: bool> Kernel for Ask<'_, S, APART> {
    type Scalar = S;
    type Output = Answers<S>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Answers<S> {
        dispatch::<L, _, APART>(self.0, Questions(self.1))
    }
}

struct Questions<S>(Eight<S>);

impl<S: TestScalar, L: Lanes<Scalar = S>> ShapeVisitor<L> for Questions<S> {
    type Output = Answers<S>;

    #[inline(always)]
    fn visit<F: Shape<L>>(self, shape: F) -> Answers<S> {
        let Eight { origin, direction, on_self, limit } = self.0;
        let (direction, limit) = (Vec3::from_arrays(&direction), L::from_array(limit));
        let rays = Rays { origin: Vec3::from_arrays(&origin), direction };
        let of_eye = Rays { origin: Vec3::zero(), direction };
        let on_self = Mask::from_array(on_self);
        let mut answers = Vec::new();

        // Distances: of reflected rays, of eye rays, and in two passes.
        tell("distance", shape.distance::<false>(&rays, on_self), &mut answers);
        let of_self = if F::SKIPS_SELF { Mask::none() } else { on_self };
        tell("distance from the eye", shape.distance::<true>(&of_eye, of_self), &mut answers);
        let foot = shape.foot(&rays).map(|foot| foot.without(on_self).near());
        assert_eq!(foot.is_some(), F::TWO_PASSES);
        tell("near of the foot", foot, &mut answers);
        answers.push(("blocks", shape.blocks(&rays, limit).to_array()));

        // Points and normals, at the distances of shadow rays' lights: as good as any.
        let arm = shape.arm(&rays, limit);
        let normal = shape.normal(arm, direction);
        let point = shape.point(arm);
        let vectors = [
            ["arm x", "arm y", "arm z"],
            ["normal x", "normal y", "normal z"],
            ["point x", "point y", "point z"],
            ["start x", "start y", "start z"],
            ["relative x", "relative y", "relative z"],
        ];
        let found = [arm, normal, point, shape.start(point, normal), shape.relative(point)];
        for (names, vector) in vectors.into_iter().zip(found) {
            answers.extend(names.into_iter().zip(vector.to_arrays()));
        }
        answers
    }
}

/// Adds a distance, and whether it is met.
#[inline(always)]
fn tell<L: Lanes>(
    name: &'static str,
    found: Option<Distance<L>>,
    answers: &mut Answers<L::Scalar>,
) {
    let none = Distance { t: L::constant(0.0), met: Mask::none() };
    let Distance { t, met } = found.unwrap_or(none);
    answers.push((name, met.keep(t).to_array()));
    answers.push((name, met.to_array()));
}

/// Compares two answers in the lanes `same` names: of the first, of the second.
fn compare<S: TestScalar>(
    a: &Answers<S>,
    b: &Answers<S>,
    lane: usize,
    context: &dyn Fn() -> String,
) {
    assert_eq!(a.len(), b.len());
    for ((name, a), (_, b)) in a.iter().zip(b) {
        let (a, b) = (a[lane], b[lane]);
        assert!(a.is(b), "{name}, lane {lane}: {a:?} and {b:?}, {}", context());
    }
}

fn check<S: TestScalar, const APART: bool>(shape: &AnyShape<S>, rays: Eight<S>) {
    let first = run(crate::Isa::Portable, Ask::<_, APART>(shape, rays));
    for isa in isas() {
        let context = || format!("{isa}, {shape:?}, {rays:?}");
        let found = run(isa, Ask::<_, APART>(shape, rays));
        for lane in 0..LANES {
            compare(&found, &first, lane, &context);
            // The same ray in all lanes.
            let all = |x: [S; LANES]| [x[lane]; LANES];
            let alone = Eight {
                origin: rays.origin.map(all),
                direction: rays.direction.map(all),
                on_self: all(rays.on_self),
                limit: all(rays.limit),
            };
            let alone = run(isa, Ask::<_, APART>(shape, alone));
            compare(&found, &alone, lane, &context);
        }
    }
}

fn check_all<S: TestScalar>(rounds: usize) {
    let mut numbers = Numbers::new(51);
    for _ in 0..rounds {
        for shape in cases::shapes::<S>(&mut numbers) {
            let rays = cases::rays(&shape, &mut numbers);
            check::<S, true>(&shape, rays);
            check::<S, false>(&shape, rays);
        }
    }
}

#[test]
fn a_form_is_the_same_in_every_lane_and_on_every_instruction_set() {
    check_all::<f32>(500);
    check_all::<f64>(500);
}

/// A foot of the perpendicular of which nothing is met.
struct NoFoot<S>([S; LANES]);

impl<S: TestScalar> Kernel for NoFoot<S> {
    type Scalar = S;
    type Output = u32;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> u32 {
        let one = L::constant(1.0);
        let on_self = Mask::from_array(self.0);
        Foot { b: one, discriminant: one }.without(on_self).met().bits()
    }
}

#[test]
fn rays_do_not_meet_the_sphere_that_they_left() {
    for isa in isas() {
        for set in 0..1 << LANES {
            let lanes = std::array::from_fn(|lane| f32::truth(set >> lane & 1 != 0));
            assert_eq!(run(isa, NoFoot(lanes)), !set & 0xff, "{isa}");
        }
    }
}
