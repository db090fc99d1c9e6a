//! A plane, or a sphere so large that it looks like one, robust numerics.
//!
//! With 2g(x) = curvature·|x|^2 - 2 lean·x + offset, twice the height over the surface, and
//! N = curvature·o - lean its gradient at the ray's origin, the ray o + t d meets it where
//! curvature·t^2 + 2 (N·d) t + 2g(o) = 0. All coefficients are of the size of the scene
//! around the eye, however large the sphere. A plane is the case of curvature 0.

use catoptric_scene::Flat;

use super::real::{Real, Vec3};
use super::trace::{Ray, Surface, not_behind, positive};

/// Distance to the surface, if the ray meets it. `own`: the ray starts on this surface.
///
/// Edge: as for a ball. The root is formed from whichever of its two expressions does not
/// cancel.
pub(crate) fn distance(flat: &Flat<Real>, ray: Ray, own: bool) -> Option<Real> {
    let (gradient, height) = gradient_and_height(flat, ray.origin);
    let slope = gradient.dot(ray.direction);
    if flat.is_around() {
        let height = if own { 0.0 } else { height };
        let root = positive(slope * slope - flat.curvature * height).sqrt();
        let t =
            if slope < 0.0 { height / (root - slope) } else { (root + slope) / -flat.curvature };
        return Some(not_behind(t));
    }
    let discriminant = slope * slope - flat.curvature * height;
    (!own && slope < 0.0 && discriminant >= 0.0)
        .then(|| not_behind(height / (discriminant.sqrt() - slope)))
}

/// Where a ray meets it at distance `t`.
///
/// Inside a sphere rays meet it again and again, and the rounding of their points would add up
/// until they have left it: there the point is put back, by one Newton step down its height.
pub(crate) fn surface(flat: &Flat<Real>, ray: Ray, t: Real, id: usize) -> Surface {
    let mut point = ray.origin + ray.direction * t;
    if flat.is_around() {
        let (gradient, height) = gradient_and_height(flat, point);
        point -= gradient * (0.5 * height);
    }
    let normal = point * flat.curvature - flat.lean;
    Surface { point, normal, start: point, left: Some(id) }
}

/// Whether it stands between a point on the eye's side and a lamp on that side, at
/// `distance` in direction `ray.direction`.
///
/// As for a ball, without a root: the height falls at the point, rises at the lamp, and is
/// not positive at its least between. For a plane the slope never changes, so it hides none;
/// neither does a sphere around the eye.
pub(crate) fn occludes(flat: &Flat<Real>, ray: Ray, distance: Real) -> bool {
    let (gradient, height) = gradient_and_height(flat, ray.origin);
    let slope = gradient.dot(ray.direction);
    let discriminant = slope * slope - flat.curvature * height;
    slope < 0.0 && -slope < flat.curvature * distance && discriminant >= 0.0
}

/// N(x) and 2g(x), the latter as (N(x) - lean)·x + offset.
fn gradient_and_height(flat: &Flat<Real>, x: Vec3) -> (Vec3, Real) {
    let gradient = x * flat.curvature - flat.lean;
    (gradient, (gradient - flat.lean).dot(x) + flat.offset)
}
