//! The packet loop.
//!
//! The plain algorithm is `reference::trace`:
//!
//! ```text
//! trace(ray, weight, depth):
//!     if ray meets nothing: return background
//!     local = ambient + lamps
//!     if mirror is followed: return local + k · trace(mirrored ray, weight · k, depth + 1)
//!     return local
//! ```
//!
//! This file departs from it as follows, and no bit changes:
//!
//! 1. Eight rays go side by side. Each lane does what the recursion does for its ray, in the
//!    same order; operations are the same in a lane as on a scalar (`lanes`). A lane whose ray
//!    has ended computes on, and nothing reads it.
//! 2. The call becomes a loop. On the way down every level leaves behind what it owes on the
//!    return, (local, k), in a stack of its own (`stack`); the ray in flight overwrites the one
//!    before, for nothing needs that any more.
//! 3. The return becomes a second loop that folds back, colour = local + k · colour, from the
//!    deepest level up: the sum that the recursion forms, in its order. Adding weight · local on
//!    the way down would be the same sum only in the reals.
//! 4. Lanes that ended above add 0 + 0 · 0 below, and local + 0 · 0 at their last level, which
//!    is local: no local colour is -0.
//! 5. Lanes that met the same primitive are shaded together, so all that depends on the
//!    primitive is a scalar, as it is in the recursion.

use catoptric_scene::{Compiled, Shape};

use crate::lanes::{Lanes, Mask};
use crate::shade::{self, Shaded};
use crate::stack::{PendingBounce, Stack};
use crate::vec3::Vec3;
use crate::{ball, flat, textbook};

/// Eight rays in flight. Units: directions have length 1, up to rounding.
#[derive(Clone, Copy)]
pub(crate) struct Rays<L> {
    pub(crate) origin: Vec3<L>,
    pub(crate) direction: Vec3<L>,
    /// Index of the primitive just left, which is not met again, or [`NONE`].
    pub(crate) left: L,
}

/// The primitives that are tried, in ascending order; a ray would miss all others.
#[derive(Clone, Copy)]
pub(crate) struct Candidates<'a> {
    /// By the eye rays of these pixels.
    pub(crate) eye: &'a [u32],
    /// By mirrored rays.
    pub(crate) mirrors: &'a [u32],
}

/// No primitive.
pub(crate) const NONE: u32 = u32::MAX;

/// How far eight rays are from one primitive.
pub(crate) struct Distance<L> {
    /// NaN where there is no root.
    pub(crate) t: L,
    /// False where the primitive does not count: met from behind, or just left.
    pub(crate) met: Mask<L>,
}

/// Where eight rays meet one primitive.
pub(crate) struct Surface<L> {
    /// The points that are lit.
    pub(crate) point: Vec3<L>,
    /// Unit normals.
    pub(crate) normal: Vec3<L>,
    /// Where shadow and mirrored rays start.
    pub(crate) start: Vec3<L>,
}

/// A path went deeper than the memory limit allows.
pub(crate) struct TooDeep;

/// The light that comes back along eight eye rays; lanes outside `live` are black.
///
/// Memory: what `stack` holds; it is left empty.
#[inline(always)]
pub(crate) fn trace<L: Lanes>(
    scene: &Compiled,
    candidates: Candidates,
    mut rays: Rays<L>,
    mut live: Mask<L>,
    stack: &mut Stack,
) -> Result<Vec3<L>, TooDeep> {
    let mut weight = L::splat(1.0);
    let mut depth = 0;
    let mut tried = candidates.eye;
    loop {
        if !stack.make_room() {
            stack.clear();
            return Err(TooDeep);
        }
        let (nearest, distance) = nearest(scene, tried, &rays);
        let met = live.without(nearest.same_bits(L::index(NONE)));
        stack.count().rays += live.count();
        stack.count().hits += met.count();

        let mut bounce = PendingBounce::none();
        bounce.local = Vec3::splat(scene.background).keep(live.without(met));
        let mut next = rays;
        live = Mask::none();
        let followed = depth < scene.max_depth;

        let indices = nearest.to_array().map(f32::to_bits);
        let mut waiting = met.bits();
        while waiting != 0 {
            let index = indices[waiting.trailing_zeros() as usize % indices.len()];
            let lanes = met & nearest.same_bits(L::index(index));
            waiting &= !lanes.bits();

            let Shaded { local, k, surface, mirrored, left } =
                shade::shade(scene, index, &rays, distance, lanes, stack.count());
            bounce.local = Vec3::select(lanes, local, bounce.local);
            if k > 0.0 && followed {
                let k = L::splat(k);
                let product = weight * k;
                let goes_on = lanes & product.ge(L::splat(scene.min_weight));
                bounce.k = goes_on.select(k, bounce.k);
                weight = goes_on.select(product, weight);
                next.origin = Vec3::select(goes_on, surface.start, next.origin);
                next.direction = Vec3::select(goes_on, mirrored, next.direction);
                next.left = goes_on.select(L::index(left), next.left);
                live = live | goes_on;
            }
        }
        stack.push(bounce);
        if !live.any() {
            break;
        }
        rays = next;
        depth += 1;
        tried = candidates.mirrors;
    }

    let mut colour = Vec3::zero();
    while let Some(bounce) = stack.pop() {
        colour = bounce.fold(colour);
    }
    Ok(colour)
}

/// Index of the primitive that each ray meets first, or [`NONE`], and its distance.
///
/// Primitives are tried in the order of their index and only a smaller distance replaces:
/// the first of equals wins. A distance of NaN is not smaller.
#[inline(always)]
fn nearest<L: Lanes>(scene: &Compiled, tried: &[u32], rays: &Rays<L>) -> (L, L) {
    let mut nearest = L::index(NONE);
    let mut best = L::splat(f32::INFINITY);
    for &index in tried {
        let own = rays.left.same_bits(L::index(index));
        let distance = match &scene.primitives[index as usize].shape {
            Shape::Ball(ball) => ball::distance(ball, rays, own),
            Shape::Flat(flat) => flat::distance(flat, rays, own),
            Shape::TextbookSphere(sphere) => Some(textbook::sphere_distance(sphere, rays)),
            Shape::TextbookPlane(plane) => Some(textbook::plane_distance(plane, rays)),
        };
        let Some(distance) = distance else {
            continue;
        };
        let closer = distance.met & distance.t.lt(best);
        best = closer.select(distance.t, best);
        nearest = closer.select(L::index(index), nearest);
    }
    (nearest, best)
}
