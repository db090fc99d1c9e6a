//! Eight rays against a plane or a large sphere: `reference::flat`, lane by lane.

use catoptric_scene::Flat;

use crate::lanes::{Lanes, Mask};
use crate::packet::{Distance, Rays, Surface};
use crate::vec3::Vec3;

/// Distances to the surface; `own`: the lanes whose ray starts on it.
#[inline(always)]
pub(crate) fn distance<L: Lanes>(flat: &Flat, rays: &Rays<L>, own: Mask<L>) -> Distance<L> {
    let zero = L::splat(0.0);
    let curvature = L::splat(flat.curvature);
    let (gradient, height) = gradient_and_height(flat, rays.origin);
    let slope = gradient.dot(rays.direction);
    let falling = slope.lt(zero);
    if flat.is_around() {
        let height = own.drop(height);
        let root = (slope * slope - curvature * height).positive().sqrt();
        let near_wall = height / (root - slope);
        let far_wall = (root + slope) / L::splat(-flat.curvature);
        let t = falling.select(near_wall, far_wall).not_behind();
        return Distance { t, met: t.ge(zero) };
    }
    let discriminant = slope * slope - curvature * height;
    let t = (height / (discriminant.sqrt() - slope)).not_behind();
    Distance { t, met: falling.without(own) }
}

/// Where the rays meet it at distances `t`.
#[inline(always)]
pub(crate) fn surface<L: Lanes>(flat: &Flat, rays: &Rays<L>, t: L) -> Surface<L> {
    let point = rays.origin + rays.direction * t;
    let normal = point * L::splat(flat.curvature) - Vec3::splat(flat.lean);
    Surface { point, normal, start: point }
}

/// The lanes for which it stands between `point` and a lamp at `distance` in direction `l`.
#[inline(always)]
pub(crate) fn occludes<L: Lanes>(flat: &Flat, point: Vec3<L>, l: Vec3<L>, distance: L) -> Mask<L> {
    let zero = L::splat(0.0);
    let curvature = L::splat(flat.curvature);
    let (gradient, height) = gradient_and_height(flat, point);
    let slope = gradient.dot(l);
    let discriminant = slope * slope - curvature * height;
    let rises_again = (zero - slope).lt(curvature * distance);
    slope.lt(zero) & rises_again & discriminant.ge(zero)
}

/// N(x) and 2g(x), the latter as (N(x) - lean)·x + offset.
#[inline(always)]
fn gradient_and_height<L: Lanes>(flat: &Flat, x: Vec3<L>) -> (Vec3<L>, L) {
    let lean = Vec3::splat(flat.lean);
    let gradient = x * L::splat(flat.curvature) - lean;
    (gradient, (gradient - lean).dot(x) + L::splat(flat.offset))
}
