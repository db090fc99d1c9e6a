//! Planes and large spheres by their height function: `reference::flat` on eight rays, lane by lane.

use catoptric_scene::{Flat, Numerics, Scalar};

use super::form::{Blocker, Facts, Inside, Kind, Shape, View};
use super::horizon::Horizon;
use crate::ray::{Distance, Rays};
use crate::simd::{Lanes, Mask, Vec3, in_f64};

/// The constants of `catoptric_scene::Flat`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct GeneralSphere<L> {
    curvature: L,
    lean: Vec3<L>,
    offset: L,
    /// Whether the eye is inside.
    inside: bool,
    /// Whether it is a plane.
    plane: bool,
}

impl<L: Lanes> GeneralSphere<L> {
    #[inline(always)]
    pub(crate) fn splat(flat: &Flat<L::Scalar>) -> Self {
        Self {
            curvature: L::splat(flat.curvature),
            lean: Vec3::splat(flat.lean),
            offset: L::splat(flat.offset),
            inside: flat.is_around(),
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
}

/// A plane, or a sphere seen from outside.
impl<L: Lanes> Shape<L> for GeneralSphere<L> {
    const NUMERICS: Numerics = Numerics::Robust;
    const SKIPS_SELF: bool = true;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, on_self: Mask<L>) -> Option<Distance<L>> {
        let gradient = self.gradient(rays.origin);
        let slope = gradient.dot(rays.direction);
        let met = slope.lt(L::constant(0.0)).without(on_self);
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

    /// Planes hide nothing: their height never rises again.
    #[inline(always)]
    fn blocks(&self, rays: &Rays<L>, limit: L) -> Mask<L> {
        let (point, l) = (rays.origin, rays.direction);
        let gradient = self.gradient(point);
        let slope = gradient.dot(l);
        let rises_again = (L::constant(0.0) - slope).lt(self.curvature * limit);
        let turns = slope.lt(L::constant(0.0)) & rises_again;
        if !turns.any() {
            return turns;
        }
        let height = self.height(gradient, point);
        let discriminant = self.discriminant(gradient, slope, height, l);
        turns & discriminant.ge(L::constant(0.0))
    }

    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let mut point = rays.origin + rays.direction * t;
        if self.inside {
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

/// A sphere around the eye.
impl<L: Lanes> Shape<L> for Inside<GeneralSphere<L>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const SKIPS_SELF: bool = false;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, on_self: Mask<L>) -> Option<Distance<L>> {
        let flat = &self.0;
        let zero = L::constant(0.0);
        let gradient = flat.gradient(rays.origin);
        let slope = gradient.dot(rays.direction);
        let height = on_self.drop(flat.height(gradient, rays.origin));
        let root = (slope * slope - flat.curvature * height).positive().sqrt();
        let near_wall = height / (root - slope);
        let far_wall = (root + slope) / (zero - flat.curvature);
        let t = slope.lt(zero).select(near_wall, far_wall).not_behind();
        Some(Distance { t, met: t.ge(zero) })
    }

    /// Nothing is outside that light could be hidden from.
    #[inline(always)]
    fn blocks(&self, _: &Rays<L>, _: L) -> Mask<L> {
        Mask::none()
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

impl<S: Scalar> Facts for Flat<S> {
    fn kind(&self) -> Kind {
        if self.curvature == S::ZERO { Kind::Plane } else { Kind::LargeSphere }
    }

    fn encloses_eye(&self) -> bool {
        self.is_around()
    }

    fn reach(&self) -> Option<f64> {
        let curvature = self.curvature.to_f64().abs();
        (curvature != 0.0).then(|| (in_f64::<S>(self.lean).length() + 1.0) / curvature)
    }

    /// Only a ray that falls towards it meets it.
    fn view(&self) -> View {
        if self.is_around() {
            View::Everywhere
        } else {
            View::Half { axis: in_f64::<S>(self.lean) }
        }
    }

    fn blocker(&self) -> Blocker {
        if self.curvature > S::ZERO {
            let (lean, curvature) = (in_f64::<S>(self.lean), self.curvature.to_f64());
            Blocker::Horizon(Horizon { lean, curvature })
        } else {
            Blocker::Nowhere
        }
    }
}
