//! The workshop's formulas on eight rays: `reference::textbook`, lane by lane.

use catoptric_scene::{Numerics, Scalar};

use super::form::{Facts, Kind, Shape};
use crate::ray::{Distance, Rays};
use crate::simd::{Lanes, Mask, Vec3};

/// The workshop's offset.
const OFFSET: f64 = 1e-4;

/// The constants of `catoptric_scene::TextbookSphere`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct TextbookSphere<L> {
    center: Vec3<L>,
    radius_squared: L,
}

/// The constants of `catoptric_scene::TextbookPlane`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct TextbookPlane<L> {
    normal: Vec3<L>,
    turned: Vec3<L>,
    offset: L,
}

impl<L: Lanes> TextbookSphere<L> {
    #[inline(always)]
    pub(crate) fn splat(sphere: &catoptric_scene::TextbookSphere<L::Scalar>) -> Self {
        let radius_squared = L::splat(sphere.radius * sphere.radius);
        Self { center: Vec3::splat(sphere.center), radius_squared }
    }

    /// The nearer positive root of a t^2 + b t + c0 = 0. Without a root both are NaN.
    #[inline(always)]
    fn met_by(&self, rays: &Rays<L>) -> Distance<L> {
        let zero = L::constant(0.0);
        let from_center = rays.origin - self.center;
        let a = rays.direction.dot(rays.direction);
        let b = L::constant(2.0) * rays.direction.dot(from_center);
        let c0 = from_center.dot(from_center) - self.radius_squared;
        let root = (b * b - L::constant(4.0) * a * c0).sqrt();
        let double_a = L::constant(2.0) * a;
        let minus_b = zero - b;
        let near = (minus_b - root) / double_a;
        let far = (minus_b + root) / double_a;
        let t = near.gt(zero).select(near, far);
        Distance { t, met: t.gt(zero) }
    }
}

impl<L: Lanes> TextbookPlane<L> {
    #[inline(always)]
    pub(crate) fn splat(plane: &catoptric_scene::TextbookPlane<L::Scalar>) -> Self {
        Self {
            normal: Vec3::splat(plane.normal),
            turned: Vec3::splat(-plane.normal),
            offset: L::splat(plane.offset),
        }
    }

    /// t = (n·point - n·o)/(n·d), where positive.
    #[inline(always)]
    fn met_by(&self, rays: &Rays<L>) -> Distance<L> {
        let t = (self.offset - self.normal.dot(rays.origin)) / self.normal.dot(rays.direction);
        Distance { t, met: t.gt(L::constant(0.0)) }
    }
}

impl<L: Lanes> Shape<L> for TextbookSphere<L> {
    const NUMERICS: Numerics = Numerics::Textbook;
    const SKIPS_SELF: bool = false;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, _: Mask<L>) -> Option<Distance<L>> {
        Some(self.met_by(rays))
    }

    #[inline(always)]
    fn blocks(&self, rays: &Rays<L>, limit: L) -> Mask<L> {
        let root = self.met_by(rays);
        root.met & root.t.lt(limit)
    }

    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        rays.origin + rays.direction * t
    }

    /// n = (p - c)/|p - c|.
    #[inline(always)]
    fn normal(&self, point: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        let from_center = point - self.center;
        from_center * (L::constant(1.0) / from_center.length())
    }

    /// p + (p - c)·1e-4.
    #[inline(always)]
    fn start(&self, point: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        point + (point - self.center) * L::constant(OFFSET)
    }
}

impl<L: Lanes> Shape<L> for TextbookPlane<L> {
    const NUMERICS: Numerics = Numerics::Textbook;
    const SKIPS_SELF: bool = false;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, _: Mask<L>) -> Option<Distance<L>> {
        Some(self.met_by(rays))
    }

    #[inline(always)]
    fn blocks(&self, rays: &Rays<L>, limit: L) -> Mask<L> {
        let root = self.met_by(rays);
        root.met & root.t.lt(limit)
    }

    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        rays.origin + rays.direction * t
    }

    /// The normal faces the ray.
    #[inline(always)]
    fn normal(&self, _: Vec3<L>, direction: Vec3<L>) -> Vec3<L> {
        let away = self.normal.dot(direction).gt(L::constant(0.0));
        Vec3::select(away, self.turned, self.normal)
    }

    /// p + n·1e-4.
    #[inline(always)]
    fn start(&self, point: Vec3<L>, normal: Vec3<L>) -> Vec3<L> {
        point + normal * L::constant(OFFSET)
    }
}

impl<S: Scalar> Facts for catoptric_scene::TextbookSphere<S> {
    fn kind(&self) -> Kind {
        Kind::Sphere
    }
}

impl<S: Scalar> Facts for catoptric_scene::TextbookPlane<S> {
    fn kind(&self) -> Kind {
        Kind::Plane
    }
}
