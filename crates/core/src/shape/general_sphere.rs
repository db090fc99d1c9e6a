//! Planes and large spheres by their height function: `reference::general_sphere` on eight rays,
//! lane by lane.

use catoptric_scene::{self as scene, Numerics, Scalar};

use super::form::{Blocker, Facts, Inside, Kind, Shape, View};
use super::horizon::Horizon;
use crate::ray::{Distance, Rays};
use crate::simd::{Lanes, Mask, Vec3, in_f64};

/// The constants of `catoptric_scene::GeneralSphere`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct GeneralSphere<L> {
    curvature: L,
    scaled_center: Vec3<L>,
    cocurvature: L,
    /// Whether the eye is inside.
    inside: bool,
    /// Whether it is a plane.
    plane: bool,
}

impl<L: Lanes> GeneralSphere<L> {
    #[inline(always)]
    pub(crate) fn splat(general: &scene::GeneralSphere<L::Scalar>) -> Self {
        Self {
            curvature: L::splat(general.curvature),
            scaled_center: Vec3::splat(general.scaled_center),
            cocurvature: L::splat(general.cocurvature),
            inside: general.encloses_eye(),
            plane: general.curvature == L::Scalar::ZERO,
        }
    }

    /// N(x).
    #[inline(always)]
    fn gradient(&self, x: Vec3<L>) -> Vec3<L> {
        x * self.curvature - self.scaled_center
    }

    /// 2g(x), as (N(x) - scaled_center)·x + cocurvature.
    #[inline(always)]
    fn height(&self, gradient: Vec3<L>, x: Vec3<L>) -> L {
        (gradient - self.scaled_center).dot(x) + self.cocurvature
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
        let general = &self.0;
        let zero = L::constant(0.0);
        let gradient = general.gradient(rays.origin);
        let slope = gradient.dot(rays.direction);
        let height = on_self.drop(general.height(gradient, rays.origin));
        let root = (slope * slope - general.curvature * height).positive().sqrt();
        let near_wall = height / (root - slope);
        let far_wall = (root + slope) / (zero - general.curvature);
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

impl<S: Scalar> Facts for scene::GeneralSphere<S> {
    fn kind(&self) -> Kind {
        if self.curvature == S::ZERO { Kind::Plane } else { Kind::LargeSphere }
    }

    fn encloses_eye(&self) -> bool {
        self.encloses_eye()
    }

    fn reach(&self) -> Option<f64> {
        let curvature = self.curvature.to_f64().abs();
        (curvature != 0.0).then(|| (in_f64::<S>(self.scaled_center).length() + 1.0) / curvature)
    }

    /// Only a ray that falls towards it meets it.
    fn view(&self) -> View {
        if self.encloses_eye() {
            View::Everywhere
        } else {
            View::Half { axis: in_f64::<S>(self.scaled_center) }
        }
    }

    fn blocker(&self) -> Blocker {
        if self.curvature > S::ZERO {
            let (scaled_center, curvature) =
                (in_f64::<S>(self.scaled_center), self.curvature.to_f64());
            Blocker::Horizon(Horizon { scaled_center, curvature })
        } else {
            Blocker::Nowhere
        }
    }
}
