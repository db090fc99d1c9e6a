//! Eight rays against a ball: `reference::ball`, lane by lane.

use catoptric_scene::Ball;

use crate::lanes::{Lanes, Mask};
use crate::packet::{Distance, Rays, Surface};
use crate::vec3::Vec3;

/// Distances to the ball, unless all lanes miss it; `own`: the lanes whose ray starts on it.
///
/// Idle lanes compute what is never read.
#[inline(always)]
pub(crate) fn distance<L: Lanes>(ball: &Ball, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
    let zero = L::splat(0.0);
    let f = Vec3::splat(ball.center) - rays.origin;
    let b = f.dot(rays.direction);
    let x = rays.direction * b - f;
    let discriminant = L::splat(ball.radius_squared) - x.dot(x);
    if ball.is_around() {
        let s = own.select(b, discriminant.positive().sqrt());
        let t = (b + s).not_behind();
        return Some(Distance { t, met: t.ge(zero) });
    }
    let met = (b.gt(zero) & discriminant.ge(zero)).without(own);
    // Most packets miss most balls: the root is worth a branch.
    if !met.any() {
        return None;
    }
    Some(Distance { t: (b - discriminant.sqrt()).not_behind(), met })
}

/// Where the rays meet it at distances `t`.
#[inline(always)]
pub(crate) fn surface<L: Lanes>(ball: &Ball, rays: &Rays<L>, t: L) -> Surface<L> {
    let f = Vec3::splat(ball.center) - rays.origin;
    let x = rays.direction * t - f;
    let outward = x * (L::splat(1.0) / x.length());
    let point = Vec3::splat(ball.center) + outward * L::splat(ball.radius);
    Surface { point, normal: outward * L::splat(ball.side), start: point }
}

/// The lanes for which it stands between `point` and a lamp at `distance` in direction `l`.
#[inline(always)]
pub(crate) fn occludes<L: Lanes>(ball: &Ball, point: Vec3<L>, l: Vec3<L>, distance: L) -> Mask<L> {
    if ball.is_around() {
        return Mask::none();
    }
    let f = Vec3::splat(ball.center) - point;
    let b = f.dot(l);
    let x = l * b - f;
    b.gt(L::splat(0.0)) & b.lt(distance) & x.dot(x).le(L::splat(ball.radius_squared))
}
