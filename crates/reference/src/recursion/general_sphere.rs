//! A plane, or a sphere so large that it looks like one, robust numerics.
//!
//! Twice the height of x over the surface is
//! 2g(x) = curvature·|x|^2 - 2 scaled_center·x + cocurvature. Its gradient at the ray's origin is
//! N = curvature·o - scaled_center. The ray o + t d meets the surface where
//! curvature·t^2 + 2 (N·d) t + 2g(o) = 0. All coefficients are of the size of the scene around the
//! eye, however large the sphere. A plane is the case of curvature 0.
//!
//! A quarter of the equation's discriminant has two forms:
//!
//! - (N·d)^2 - curvature·2g(o), exact where the ray starts close to the surface and passes it at a
//!   small angle;
//! - 1 - |N - (N·d) d|^2, which is r^2 less the square of the distance at which the ray passes the
//!   centre, over r^2; the same, since |N|^2 is 1 + curvature·2g(o). A sphere that is small against
//!   its distance needs this form: |N| is the distance over the radius, and the first form would
//!   lose |N|^2.

use catoptric_scene::GeneralSphere;

use super::ray::{Ray, Surface, not_behind, positive};
use super::real::{Real, Vec3};

/// Distance to the surface, if the ray meets it. `own`: the ray starts on this surface.
///
/// Edge: as for a sphere. The root is formed from whichever of its two expressions does not
/// cancel.
pub(crate) fn distance(general: &GeneralSphere<Real>, ray: Ray, own: bool) -> Option<Real> {
    let (gradient, height) = gradient_and_height(general, ray.origin);
    let slope = gradient.dot(ray.direction);
    if general.encloses_eye() {
        let height = if own { 0.0 } else { height };
        let root = positive(slope * slope - general.curvature * height).sqrt();
        let t =
            if slope < 0.0 { height / (root - slope) } else { (root + slope) / -general.curvature };
        return Some(not_behind(t));
    }
    let discriminant = discriminant(general, gradient, height, ray.direction);
    (!own && slope < 0.0 && discriminant >= 0.0)
        .then(|| not_behind(height / (discriminant.sqrt() - slope)))
}

/// The surface where a ray meets the shape at distance `t`.
///
/// Inside a sphere rays meet it again and again, and the rounding of their points would add up
/// until they have left it. There the point is put back, by one Newton step down its height.
pub(crate) fn surface(general: &GeneralSphere<Real>, ray: Ray, t: Real, id: usize) -> Surface {
    let mut point = ray.origin + ray.direction * t;
    if general.encloses_eye() {
        let (gradient, height) = gradient_and_height(general, point);
        point -= gradient * (0.5 * height);
    }
    let normal = point * general.curvature - general.scaled_center;
    Surface { point, anchor: point, arm: Vec3::ZERO, normal, start: point, left: Some(id) }
}

/// Whether the shape stands between a point on the eye's side and a light on that side, at
/// `distance` in direction `ray.direction`.
///
/// Needs no root: the shape hides the light exactly if the height falls at the point, rises at the
/// light, and is not positive at its least between. A plane hides no light, since its slope never
/// changes; neither does a sphere around the eye.
pub(crate) fn occludes(general: &GeneralSphere<Real>, ray: Ray, distance: Real) -> bool {
    let (gradient, height) = gradient_and_height(general, ray.origin);
    let slope = gradient.dot(ray.direction);
    let discriminant = discriminant(general, gradient, height, ray.direction);
    slope < 0.0 && -slope < general.curvature * distance && discriminant >= 0.0
}

/// A quarter of the discriminant, in the form that keeps its digits: not negative where a ray in
/// `direction` meets the surface. `gradient` and `height` are N and 2g at the ray's origin; for
/// surfaces that are not around the eye.
fn discriminant(
    general: &GeneralSphere<Real>,
    gradient: Vec3,
    height: Real,
    direction: Vec3,
) -> Real {
    let slope = gradient.dot(direction);
    let bend = general.curvature * height;
    if bend < 1.0 {
        return slope * slope - bend;
    }
    let across = gradient - direction * slope;
    1.0 - across.dot(across)
}

/// The gradient N(x) and twice the height, 2g(x), the latter as (N(x) - scaled_center)·x +
/// cocurvature.
fn gradient_and_height(general: &GeneralSphere<Real>, x: Vec3) -> (Vec3, Real) {
    let gradient = x * general.curvature - general.scaled_center;
    (gradient, (gradient - general.scaled_center).dot(x) + general.cocurvature)
}
