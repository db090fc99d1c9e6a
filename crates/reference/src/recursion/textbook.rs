//! The workshop's formulas to the letter: the plain quadratic, and an offset of the start of
//! shadow and mirrored rays in place of knowing which primitive they left.
//!
//! The formulas lose half their digits on a large sphere and shift its shadows: that is what the
//! reports show. The normal of a sphere is not turned, so the inside of a sphere is wrong.

use catoptric_scene::{TextbookPlane, TextbookSphere};

use super::ray::{Ray, Surface};
use super::real::{Real, Vec3};

/// The workshop's offset, in units of the vector that it multiplies.
const OFFSET: Real = 1e-4;

/// Distance to a sphere: the nearer positive root of a t^2 + b t + c0 = 0.
pub(crate) fn sphere_distance(sphere: &TextbookSphere<Real>, ray: Ray) -> Option<Real> {
    let from_center = ray.origin - sphere.center;
    let a = ray.direction.dot(ray.direction);
    let b = 2.0 * ray.direction.dot(from_center);
    let c0 = from_center.dot(from_center) - sphere.radius * sphere.radius;
    let discriminant = b * b - 4.0 * a * c0;
    if discriminant >= 0.0 {
        let root = discriminant.sqrt();
        let near = (-b - root) / (2.0 * a);
        let far = (-b + root) / (2.0 * a);
        [near, far].into_iter().find(|&t| t > 0.0)
    } else {
        None
    }
}

/// The surface of a sphere: n = (p - c)/|p - c|; rays start at p + (p - c)·1e-4.
pub(crate) fn sphere_surface(sphere: &TextbookSphere<Real>, ray: Ray, t: Real) -> Surface {
    let point = ray.origin + ray.direction * t;
    let from_center = point - sphere.center;
    let normal = from_center * (1.0 / from_center.length());
    Surface {
        point,
        anchor: point,
        arm: Vec3::ZERO,
        normal,
        start: point + from_center * OFFSET,
        left: None,
    }
}

/// Distance to a plane: t = (n·point - n·o)/(n·d), where positive.
pub(crate) fn plane_distance(plane: &TextbookPlane<Real>, ray: Ray) -> Option<Real> {
    let t = (plane.offset - plane.normal.dot(ray.origin)) / plane.normal.dot(ray.direction);
    (t > 0.0).then_some(t)
}

/// The surface of a plane: the normal faces the ray; rays start at p + n·1e-4.
pub(crate) fn plane_surface(plane: &TextbookPlane<Real>, ray: Ray, t: Real) -> Surface {
    let point = ray.origin + ray.direction * t;
    let away = plane.normal.dot(ray.direction) > 0.0;
    let normal = if away { -plane.normal } else { plane.normal };
    Surface {
        point,
        anchor: point,
        arm: Vec3::ZERO,
        normal,
        start: point + normal * OFFSET,
        left: None,
    }
}
