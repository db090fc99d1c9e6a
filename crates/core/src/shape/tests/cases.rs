//! Shapes of every form, and rays that meet them, pass them, start on them, or are no rays at all.

use catoptric_scene::{GeneralSphere, RobustSphere, Shape, TextbookPlane, TextbookSphere};

use super::Eight;
use crate::shape::facts;
use crate::simd::LANES;
use crate::simd::numbers::{Numbers, TestScalar};

/// One of each form: a sphere before the eye and one around it, large ones, a plane, and the
/// textbook's.
pub(super) fn shapes<S: TestScalar>(numbers: &mut Numbers) -> Vec<Shape<S>> {
    let mut all = Vec::new();
    for side in [1.0, -1.0] {
        let [center, scaled_center] = [4.0, 1.0].map(|size| vector(size, numbers));
        let radius = numbers.magnitude(1e-3, if side < 0.0 { 1e3 } else { 2.0 });
        all.push(Shape::RobustSphere(RobustSphere {
            center: center.map(S::rounded).into(),
            radius: S::rounded(radius),
            radius_squared: S::rounded(radius * radius),
            side: S::rounded(side),
        }));
        for curvature in [side * numbers.magnitude(1e-6, 1.0), 0.0] {
            all.push(Shape::GeneralSphere(GeneralSphere {
                curvature: S::rounded(curvature),
                scaled_center: scaled_center.map(S::rounded).into(),
                cocurvature: S::rounded(numbers.magnitude(1e-3, 1e3)),
            }));
        }
        all.push(Shape::TextbookSphere(TextbookSphere {
            center: center.map(S::rounded).into(),
            radius: S::rounded(radius),
        }));
        all.push(Shape::TextbookPlane(TextbookPlane {
            normal: scaled_center.map(S::rounded).into(),
            offset: S::rounded(numbers.between(-4.0, 4.0)),
        }));
    }
    all
}

/// Rays towards a sphere's center, or anywhere; some components are any number.
pub(super) fn rays<S: TestScalar>(shape: &Shape<S>, numbers: &mut Numbers) -> Eight<S> {
    let target = facts(shape).sphere().map_or([0.0, 0.0, -1.0], |(center, _)| center.to_array());
    let edges = numbers.one_in(4);
    let mut rays = Eight {
        origin: [[S::ZERO; LANES]; 3],
        direction: [[S::ZERO; LANES]; 3],
        on_self: [S::ZERO; LANES],
        limit: [S::ZERO; LANES],
    };
    // Now and then all of them left it, or miss it.
    let (left, away) = (numbers.below(3), numbers.one_in(4));
    for lane in 0..LANES {
        let (origin, beside) = (vector(2.0, numbers), vector(1.0, numbers));
        let turned = if away { -1.0 } else { 1.0 };
        let way: [f64; 3] = std::array::from_fn(|i| turned * (target[i] - origin[i]) + beside[i]);
        let length = way.iter().map(|x| x * x).sum::<f64>().sqrt();
        for axis in 0..3 {
            let number = |x: f64, numbers: &mut Numbers| {
                if edges && numbers.one_in(6) { numbers.any() } else { S::rounded(x) }
            };
            rays.origin[axis][lane] = number(origin[axis], numbers);
            rays.direction[axis][lane] = number(way[axis] / length, numbers);
        }
        rays.on_self[lane] = S::truth(left == 0 || left == 1 && numbers.one_in(2));
        rays.limit[lane] = S::rounded(length * numbers.between(0.0, 2.0));
    }
    rays
}

fn vector(size: f64, numbers: &mut Numbers) -> [f64; 3] {
    std::array::from_fn(|_| numbers.between(-size, size))
}
