//! Eight rays against a plane or a large sphere: `reference::flat`, lane by lane.

use catoptric_scene::Flat;

use crate::lanes::{Lanes, Mask};
use crate::packet::{Distance, Rays, Surface};
use crate::vec3::Vec3;

/// Distances to the surface, unless all lanes miss it; `own`: the lanes whose ray starts on it.
#[inline(always)]
pub(crate) fn distance<L: Lanes>(flat: &Flat, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
    let zero = L::splat(0.0);
    let curvature = L::splat(flat.curvature);
    let gradient = gradient(flat, rays.origin);
    let slope = gradient.dot(rays.direction);
    let falling = slope.lt(zero);
    if flat.is_around() {
        let height = own.drop(height(flat, gradient, rays.origin));
        let root = (slope * slope - curvature * height).positive().sqrt();
        let near_wall = height / (root - slope);
        let far_wall = (root + slope) / L::splat(-flat.curvature);
        let t = falling.select(near_wall, far_wall).not_behind();
        return Some(Distance { t, met: t.ge(zero) });
    }
    let falling = falling.without(own);
    if !falling.any() {
        return None;
    }
    // Without a root the distance is NaN, which is never nearer.
    let height = height(flat, gradient, rays.origin);
    let discriminant = slope * slope - curvature * height;
    let t = (height / (discriminant.sqrt() - slope)).not_behind();
    Some(Distance { t, met: falling })
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
    let curvature = L::splat(flat.curvature);
    let gradient = gradient(flat, point);
    let slope = gradient.dot(l);
    let rises_again = (L::splat(0.0) - slope).lt(curvature * distance);
    let turns = slope.lt(L::splat(0.0)) & rises_again;
    if !turns.any() {
        return turns;
    }
    let discriminant = slope * slope - curvature * height(flat, gradient, point);
    turns & discriminant.ge(L::splat(0.0))
}

/// N(x).
#[inline(always)]
fn gradient<L: Lanes>(flat: &Flat, x: Vec3<L>) -> Vec3<L> {
    x * L::splat(flat.curvature) - Vec3::splat(flat.lean)
}

/// 2g(x), as (N(x) - lean)·x + offset.
#[inline(always)]
fn height<L: Lanes>(flat: &Flat, gradient: Vec3<L>, x: Vec3<L>) -> L {
    (gradient - Vec3::splat(flat.lean)).dot(x) + L::splat(flat.offset)
}
