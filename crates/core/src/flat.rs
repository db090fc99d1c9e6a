//! Eight rays against a plane or a large sphere: `reference::flat`, lane by lane.

use catoptric_scene::{Flat, Numerics, Scalar};

use crate::lanes::{Lane, Lanes, Mask};
use crate::nearest::{Around, Form};
use crate::packet::{Distance, Rays};
use crate::vec3::Vec3;

/// A surface that is not around the eye.
impl<S: Lane> Form<S> for Flat<S> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = true;

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>, const EYE: bool>(
        &self,
        rays: &Rays<L>,
        own: Mask<L>,
    ) -> Option<Distance<L>> {
        let gradient = gradient(self, rays.origin);
        let slope = gradient.dot(rays.direction);
        let met = slope.lt(L::constant(0.0)).without(own);
        if !met.any() {
            return None;
        }
        // Without a root the distance is NaN, which is never nearer.
        let height = height(self, gradient, rays.origin);
        let discriminant = if EYE {
            // From there |N|^2 is below 2, or its form would be another one.
            slope * slope - L::splat(self.curvature) * height
        } else {
            discriminant(self, gradient, slope, height, rays.direction)
        };
        Some(Distance { t: (height / (discriminant.sqrt() - slope)).not_behind(), met })
    }

    #[inline(always)]
    fn arm<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let mut point = rays.origin + rays.direction * t;
        if self.is_around() {
            let gradient = gradient(self, point);
            let height = height(self, gradient, point);
            point = point - gradient * (L::constant(0.5) * height);
        }
        point
    }

    #[inline(always)]
    fn normal<L: Lanes<Scalar = S>>(&self, point: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        gradient(self, point)
    }
}

impl<S: Lane> Form<S> for Around<Flat<S>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>, const EYE: bool>(
        &self,
        rays: &Rays<L>,
        own: Mask<L>,
    ) -> Option<Distance<L>> {
        let flat = &self.0;
        let zero = L::constant(0.0);
        let gradient = gradient(flat, rays.origin);
        let slope = gradient.dot(rays.direction);
        let height = own.drop(height(flat, gradient, rays.origin));
        let root = (slope * slope - L::splat(flat.curvature) * height).positive().sqrt();
        let near_wall = height / (root - slope);
        let far_wall = (root + slope) / L::splat(-flat.curvature);
        let t = slope.lt(zero).select(near_wall, far_wall).not_behind();
        Some(Distance { t, met: t.ge(zero) })
    }

    #[inline(always)]
    fn arm<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        self.0.arm(rays, t)
    }

    #[inline(always)]
    fn normal<L: Lanes<Scalar = S>>(&self, point: Vec3<L>, d: Vec3<L>) -> Vec3<L> {
        self.0.normal(point, d)
    }
}

/// The lanes for which it stands between `point` and a lamp at `distance` in direction `l`.
#[inline(always)]
pub(crate) fn occludes<L: Lanes>(
    flat: &Flat<L::Scalar>,
    point: Vec3<L>,
    l: Vec3<L>,
    distance: L,
) -> Mask<L> {
    let curvature = L::splat(flat.curvature);
    let gradient = gradient(flat, point);
    let slope = gradient.dot(l);
    let rises_again = (L::constant(0.0) - slope).lt(curvature * distance);
    let turns = slope.lt(L::constant(0.0)) & rises_again;
    if !turns.any() {
        return turns;
    }
    let height = height(flat, gradient, point);
    let discriminant = discriminant(flat, gradient, slope, height, l);
    turns & discriminant.ge(L::constant(0.0))
}

/// Not negative where rays meet the surface, which is not around the eye.
#[inline(always)]
fn discriminant<L: Lanes>(
    flat: &Flat<L::Scalar>,
    gradient: Vec3<L>,
    slope: L,
    height: L,
    direction: Vec3<L>,
) -> L {
    let one = L::constant(1.0);
    let bend = L::splat(flat.curvature) * height;
    let near = slope * slope - bend;
    if flat.curvature == L::Scalar::ZERO {
        return near;
    }
    let far = Mask::every().without(bend.lt(one));
    if !far.any() {
        return near;
    }
    let across = gradient - direction * slope;
    far.select(one - across.dot(across), near)
}

/// N(x).
#[inline(always)]
fn gradient<L: Lanes>(flat: &Flat<L::Scalar>, x: Vec3<L>) -> Vec3<L> {
    x * L::splat(flat.curvature) - Vec3::splat(flat.lean)
}

/// 2g(x), as (N(x) - lean)·x + offset.
#[inline(always)]
fn height<L: Lanes>(flat: &Flat<L::Scalar>, gradient: Vec3<L>, x: Vec3<L>) -> L {
    (gradient - Vec3::splat(flat.lean)).dot(x) + L::splat(flat.offset)
}
