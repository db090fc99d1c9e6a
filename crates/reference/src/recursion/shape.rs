//! The shapes that a ray may meet, told apart: each has formulas of its own in a file of its own.

use catoptric_scene::Shape;

use super::ray::{Ray, Surface};
use super::real::Real;
use super::{general_sphere, robust_sphere, textbook};

/// Distance to the shape, if the ray meets it. `own`: the ray starts on this shape.
#[inline(always)]
pub(crate) fn distance(shape: &Shape<Real>, ray: Ray, own: bool) -> Option<Real> {
    match shape {
        Shape::RobustSphere(sphere) => robust_sphere::distance(sphere, ray, own),
        Shape::GeneralSphere(general) => general_sphere::distance(general, ray, own),
        Shape::TextbookSphere(sphere) => textbook::sphere_distance(sphere, ray),
        Shape::TextbookPlane(plane) => textbook::plane_distance(plane, ray),
    }
}

/// Whether the shape stands between the start of a shadow ray and a light at `distance`.
#[inline(always)]
pub(crate) fn occludes(shape: &Shape<Real>, ray: Ray, distance: Real) -> bool {
    match shape {
        Shape::RobustSphere(sphere) => robust_sphere::occludes(sphere, ray, distance),
        Shape::GeneralSphere(general) => general_sphere::occludes(general, ray, distance),
        Shape::TextbookSphere(sphere) => {
            textbook::sphere_distance(sphere, ray).is_some_and(|t| t < distance)
        }
        Shape::TextbookPlane(plane) => {
            textbook::plane_distance(plane, ray).is_some_and(|t| t < distance)
        }
    }
}

/// The surface where a ray meets the shape; `id` is the index of the primitive.
#[inline(always)]
pub(crate) fn surface(shape: &Shape<Real>, ray: Ray, distance: Real, id: usize) -> Surface {
    match shape {
        Shape::RobustSphere(sphere) => robust_sphere::surface(sphere, ray, distance, id),
        Shape::GeneralSphere(general) => general_sphere::surface(general, ray, distance, id),
        Shape::TextbookSphere(sphere) => textbook::sphere_surface(sphere, ray, distance),
        Shape::TextbookPlane(plane) => textbook::plane_surface(plane, ray, distance),
    }
}
