//! Spheres by centre and radius: `reference::robust_sphere` on eight rays, lane by lane.

use catoptric_scene::{self as scene, Numerics, Scalar};
use glam::DVec3;

use super::foot::Foot;
use super::form::{Blocker, Facts, Inside, Kind, Shape, View};
use crate::ray::{Distance, Rays};
use crate::simd::{Lanes, Mask, Vec3, in_f64};

/// The constants of `catoptric_scene::RobustSphere`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct RobustSphere<L> {
    center: Vec3<L>,
    radius: L,
    radius_squared: L,
    /// What an arm is multiplied by to be the normal: side / radius.
    normal_scale: L,
    /// Whether the eye is inside.
    inside: bool,
}

impl<L: Lanes> RobustSphere<L> {
    #[inline(always)]
    pub(crate) fn splat(sphere: &scene::RobustSphere<L::Scalar>) -> Self {
        Self {
            center: Vec3::splat(sphere.center),
            radius: L::splat(sphere.radius),
            radius_squared: L::splat(sphere.radius_squared),
            normal_scale: L::splat(sphere.side) / L::splat(sphere.radius),
            inside: sphere.encloses_eye(),
        }
    }

    /// The foot of the perpendicular from the centre on rays.
    #[inline(always)]
    fn perpendicular(&self, rays: &Rays<L>) -> Foot<L> {
        let f = self.center - rays.origin;
        let b = f.dot(rays.direction);
        let x = rays.direction * b - f;
        let from_center = x.dot(x);
        Foot { b, discriminant: self.radius_squared - from_center }
    }
}

/// A sphere seen from outside.
impl<L: Lanes> Shape<L> for RobustSphere<L> {
    const NUMERICS: Numerics = Numerics::Robust;
    const SKIPS_SELF: bool = true;
    const TWO_PASSES: bool = true;

    #[inline(always)]
    fn foot(&self, rays: &Rays<L>) -> Option<Foot<L>> {
        Some(self.perpendicular(rays))
    }

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, on_self: Mask<L>) -> Option<Distance<L>> {
        let foot = self.perpendicular(rays).without(on_self);
        if !foot.met().any() {
            return None;
        }
        Some(foot.near())
    }

    #[inline(always)]
    fn blocks(&self, rays: &Rays<L>, limit: L) -> Mask<L> {
        let f = self.center - rays.origin;
        let b = f.dot(rays.direction);
        let x = rays.direction * b - f;
        b.gt(L::constant(0.0)) & b.lt(limit) & x.dot(x).le(self.radius_squared)
    }

    #[inline(always)]
    fn anchor(&self) -> Option<Vec3<L>> {
        Some(self.center)
    }

    /// Arms from the centre; a sphere around the eye is shaded by this too.
    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let x = rays.direction * t - (self.center - rays.origin);
        if self.inside {
            return x * (self.radius / x.length());
        }
        let g = x.dot(rays.direction);
        let s = (self.radius_squared - x.dot(x) + g * g).positive().sqrt();
        x - rays.direction * (g + s)
    }

    #[inline(always)]
    fn normal(&self, arm: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        arm * self.normal_scale
    }
}

/// A sphere around the eye.
impl<L: Lanes> Shape<L> for Inside<RobustSphere<L>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const SKIPS_SELF: bool = false;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, on_self: Mask<L>) -> Option<Distance<L>> {
        let Foot { b, discriminant } = self.0.perpendicular(rays);
        // A packet that left it whole needs no root.
        let s = if on_self.all() { b } else { on_self.select(b, discriminant.positive().sqrt()) };
        let t = (b + s).not_behind();
        Some(Distance { t, met: t.ge(L::constant(0.0)) })
    }

    /// Nothing is outside that light could be hidden from.
    #[inline(always)]
    fn blocks(&self, _: &Rays<L>, _: L) -> Mask<L> {
        Mask::none()
    }

    #[inline(always)]
    fn anchor(&self) -> Option<Vec3<L>> {
        self.0.anchor()
    }

    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        self.0.arm(rays, t)
    }

    #[inline(always)]
    fn normal(&self, arm: Vec3<L>, d: Vec3<L>) -> Vec3<L> {
        self.0.normal(arm, d)
    }
}

impl<S: Scalar> Facts for scene::RobustSphere<S> {
    fn kind(&self) -> Kind {
        Kind::Sphere
    }

    fn encloses_eye(&self) -> bool {
        self.encloses_eye()
    }

    fn sphere(&self) -> Option<(DVec3, f64)> {
        Some((in_f64::<S>(self.center), self.radius.to_f64()))
    }

    fn reach(&self) -> Option<f64> {
        Some(in_f64::<S>(self.center).length() + self.radius.to_f64())
    }

    fn view(&self) -> View {
        if self.encloses_eye() { View::Everywhere } else { View::Disc }
    }

    /// Paths stay inside of a sphere around the eye, so it stands before nothing.
    fn blocker(&self) -> Blocker {
        if self.encloses_eye() { Blocker::Nowhere } else { Blocker::Sphere }
    }
}
