//! The two places that tell forms apart: one for kernels, one for what comes before tracing.

use catoptric_scene::{Scalar, Shape};

use super::form::{Facts, Inside, ShapeVisitor};
use super::general_sphere::GeneralSphere;
use super::robust_sphere::RobustSphere;
use super::textbook::{TextbookPlane, TextbookSphere};
use crate::simd::Lanes;

/// Calls a visitor with the constants of a shape in all lanes.
///
/// `APART`: a sphere around the eye comes as [`Inside`], whose distance has another formula. Where
/// it was met, it is shaded by one formula from either side.
#[inline(always)]
pub(crate) fn dispatch<L: Lanes, V: ShapeVisitor<L>, const APART: bool>(
    shape: &Shape<L::Scalar>,
    visitor: V,
) -> V::Output {
    match shape {
        Shape::RobustSphere(sphere) if APART && sphere.encloses_eye() => {
            visitor.visit(Inside(RobustSphere::splat(sphere)))
        }
        Shape::RobustSphere(sphere) => visitor.visit(RobustSphere::splat(sphere)),
        Shape::GeneralSphere(general) if APART && general.encloses_eye() => {
            visitor.visit(Inside(GeneralSphere::splat(general)))
        }
        Shape::GeneralSphere(general) => visitor.visit(GeneralSphere::splat(general)),
        Shape::TextbookSphere(sphere) => visitor.visit(TextbookSphere::splat(sphere)),
        Shape::TextbookPlane(plane) => visitor.visit(TextbookPlane::splat(plane)),
    }
}

/// The facts of a shape.
pub(crate) fn facts<S: Scalar>(shape: &Shape<S>) -> &dyn Facts {
    match shape {
        Shape::RobustSphere(sphere) => sphere,
        Shape::GeneralSphere(general) => general,
        Shape::TextbookSphere(sphere) => sphere,
        Shape::TextbookPlane(plane) => plane,
    }
}
