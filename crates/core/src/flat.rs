//! Eight rays against a plane or a large sphere: `reference::flat`, lane by lane.

use catoptric_scene::{Numerics, Scalar};

use crate::lanes::{Lanes, Mask};
use crate::nearest::{Around, Form};
use crate::packet::{Distance, Rays};
use crate::vec3::Vec3;

/// The constants of `catoptric_scene::Flat`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct Flat<L> {
    curvature: L,
    lean: Vec3<L>,
    offset: L,
    around: bool,
    /// Whether it is a plane.
    plane: bool,
}

impl<L: Lanes> Flat<L> {
    #[inline(always)]
    pub(crate) fn splat(flat: &catoptric_scene::Flat<L::Scalar>) -> Self {
        Self {
            curvature: L::splat(flat.curvature),
            lean: Vec3::splat(flat.lean),
            offset: L::splat(flat.offset),
            around: flat.is_around(),
            plane: flat.curvature == L::Scalar::ZERO,
        }
    }

    /// N(x).
    #[inline(always)]
    fn gradient(&self, x: Vec3<L>) -> Vec3<L> {
        x * self.curvature - self.lean
    }

    /// 2g(x), as (N(x) - lean)·x + offset.
    #[inline(always)]
    fn height(&self, gradient: Vec3<L>, x: Vec3<L>) -> L {
        (gradient - self.lean).dot(x) + self.offset
    }

    /// Not negative where rays meet the surface, which is not around the eye.
    #[inline(always)]
    fn discriminant(&self, gradient: Vec3<L>, slope: L, height: L, direction: Vec3<L>) -> L {
        let one = L::constant(1.0);
        let bend = self.curvature * height;
        let near = slope * slope - bend;
        if self.plane {
            return near;
        }
        let far = Mask::every().without(bend.lt(one));
        if !far.any() {
            return near;
        }
        let across = gradient - direction * slope;
        far.select(one - across.dot(across), near)
    }

    /// The lanes for which it stands between `point` and a lamp at `distance` in direction `l`.
    #[inline(always)]
    pub(crate) fn occludes(&self, point: Vec3<L>, l: Vec3<L>, distance: L) -> Mask<L> {
        let gradient = self.gradient(point);
        let slope = gradient.dot(l);
        let rises_again = (L::constant(0.0) - slope).lt(self.curvature * distance);
        let turns = slope.lt(L::constant(0.0)) & rises_again;
        if !turns.any() {
            return turns;
        }
        let height = self.height(gradient, point);
        let discriminant = self.discriminant(gradient, slope, height, l);
        turns & discriminant.ge(L::constant(0.0))
    }
}

/// A surface that is not around the eye.
impl<L: Lanes> Form<L> for Flat<L> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = true;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
        let gradient = self.gradient(rays.origin);
        let slope = gradient.dot(rays.direction);
        let met = slope.lt(L::constant(0.0)).without(own);
        if !met.any() {
            return None;
        }
        // Without a root the distance is NaN, which is never nearer.
        let height = self.height(gradient, rays.origin);
        let discriminant = if EYE {
            // From there |N|^2 is below 2, or its form would be another one.
            slope * slope - self.curvature * height
        } else {
            self.discriminant(gradient, slope, height, rays.direction)
        };
        Some(Distance { t: (height / (discriminant.sqrt() - slope)).not_behind(), met })
    }

    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let mut point = rays.origin + rays.direction * t;
        if self.around {
            let gradient = self.gradient(point);
            let height = self.height(gradient, point);
            point = point - gradient * (L::constant(0.5) * height);
        }
        point
    }

    #[inline(always)]
    fn normal(&self, point: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        self.gradient(point)
    }
}

impl<L: Lanes> Form<L> for Around<Flat<L>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
        let flat = &self.0;
        let zero = L::constant(0.0);
        let gradient = flat.gradient(rays.origin);
        let slope = gradient.dot(rays.direction);
        let height = own.drop(flat.height(gradient, rays.origin));
        let root = (slope * slope - flat.curvature * height).positive().sqrt();
        let near_wall = height / (root - slope);
        let far_wall = (root + slope) / (zero - flat.curvature);
        let t = slope.lt(zero).select(near_wall, far_wall).not_behind();
        Some(Distance { t, met: t.ge(zero) })
    }

    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        self.0.arm(rays, t)
    }

    #[inline(always)]
    fn normal(&self, point: Vec3<L>, d: Vec3<L>) -> Vec3<L> {
        self.0.normal(point, d)
    }
}
