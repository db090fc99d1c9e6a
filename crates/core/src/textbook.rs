//! The workshop's formulas on eight rays: `reference::textbook`, lane by lane.

use catoptric_scene::{TextbookPlane, TextbookSphere};

use crate::lanes::Lanes;
use crate::packet::{Distance, Rays, Surface};
use crate::vec3::Vec3;

/// The workshop's offset.
const OFFSET: f32 = 1e-4;

/// The nearer positive root of a t^2 + b t + c0 = 0. Without a root both are NaN.
#[inline(always)]
pub(crate) fn sphere_distance<L: Lanes>(sphere: &TextbookSphere, rays: &Rays<L>) -> Distance<L> {
    let zero = L::splat(0.0);
    let from_center = rays.origin - Vec3::splat(sphere.center);
    let a = rays.direction.dot(rays.direction);
    let b = L::splat(2.0) * rays.direction.dot(from_center);
    let c0 = from_center.dot(from_center) - L::splat(sphere.radius * sphere.radius);
    let root = (b * b - L::splat(4.0) * a * c0).sqrt();
    let double_a = L::splat(2.0) * a;
    let minus_b = zero - b;
    let near = (minus_b - root) / double_a;
    let far = (minus_b + root) / double_a;
    let t = near.gt(zero).select(near, far);
    Distance { t, met: t.gt(zero) }
}

/// n = (p - c)/|p - c|; rays start at p + (p - c)·1e-4.
#[inline(always)]
pub(crate) fn sphere_surface<L: Lanes>(
    sphere: &TextbookSphere,
    rays: &Rays<L>,
    t: L,
) -> Surface<L> {
    let point = rays.origin + rays.direction * t;
    let from_center = point - Vec3::splat(sphere.center);
    let normal = from_center * (L::splat(1.0) / from_center.length());
    Surface { point, normal, start: point + from_center * L::splat(OFFSET) }
}

/// t = (n·point - n·o)/(n·d), where positive.
#[inline(always)]
pub(crate) fn plane_distance<L: Lanes>(plane: &TextbookPlane, rays: &Rays<L>) -> Distance<L> {
    let normal = Vec3::splat(plane.normal);
    let t = (L::splat(plane.offset) - normal.dot(rays.origin)) / normal.dot(rays.direction);
    Distance { t, met: t.gt(L::splat(0.0)) }
}

/// The normal faces the ray; rays start at p + n·1e-4.
#[inline(always)]
pub(crate) fn plane_surface<L: Lanes>(plane: &TextbookPlane, rays: &Rays<L>, t: L) -> Surface<L> {
    let point = rays.origin + rays.direction * t;
    let away = Vec3::splat(plane.normal).dot(rays.direction).gt(L::splat(0.0));
    let turned = Vec3::splat(-plane.normal);
    let normal = Vec3::select(away, turned, Vec3::splat(plane.normal));
    Surface { point, normal, start: point + normal * L::splat(OFFSET) }
}
