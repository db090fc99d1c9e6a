//! The workshop's formulas on eight rays: `reference::textbook`, lane by lane.

use catoptric_scene::{Numerics, TextbookPlane, TextbookSphere};

use crate::lanes::{Lane, Lanes, Mask};
use crate::nearest::Form;
use crate::packet::{Distance, Rays};
use crate::vec3::Vec3;

/// The workshop's offset.
const OFFSET: f64 = 1e-4;

/// The nearer positive root of a t^2 + b t + c0 = 0. Without a root both are NaN.
#[inline(always)]
pub(crate) fn sphere_distance<L: Lanes>(
    sphere: &TextbookSphere<L::Scalar>,
    rays: &Rays<L>,
) -> Distance<L> {
    let zero = L::constant(0.0);
    let from_center = rays.origin - Vec3::splat(sphere.center);
    let a = rays.direction.dot(rays.direction);
    let b = L::constant(2.0) * rays.direction.dot(from_center);
    let c0 = from_center.dot(from_center) - L::splat(sphere.radius * sphere.radius);
    let root = (b * b - L::constant(4.0) * a * c0).sqrt();
    let double_a = L::constant(2.0) * a;
    let minus_b = zero - b;
    let near = (minus_b - root) / double_a;
    let far = (minus_b + root) / double_a;
    let t = near.gt(zero).select(near, far);
    Distance { t, met: t.gt(zero) }
}

impl<S: Lane> Form<S> for TextbookSphere<S> {
    const NUMERICS: Numerics = Numerics::Textbook;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>, const EYE: bool>(
        &self,
        rays: &Rays<L>,
        _: Mask<L>,
    ) -> Option<Distance<L>> {
        Some(sphere_distance(self, rays))
    }

    #[inline(always)]
    fn arm<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        rays.origin + rays.direction * t
    }

    /// n = (p - c)/|p - c|.
    #[inline(always)]
    fn normal<L: Lanes<Scalar = S>>(&self, point: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        let from_center = point - Vec3::splat(self.center);
        from_center * (L::constant(1.0) / from_center.length())
    }

    /// p + (p - c)·1e-4.
    #[inline(always)]
    fn start<L: Lanes<Scalar = S>>(&self, point: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        point + (point - Vec3::splat(self.center)) * L::constant(OFFSET)
    }
}

impl<S: Lane> Form<S> for TextbookPlane<S> {
    const NUMERICS: Numerics = Numerics::Textbook;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>, const EYE: bool>(
        &self,
        rays: &Rays<L>,
        _: Mask<L>,
    ) -> Option<Distance<L>> {
        Some(plane_distance(self, rays))
    }

    #[inline(always)]
    fn arm<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        rays.origin + rays.direction * t
    }

    /// The normal faces the ray.
    #[inline(always)]
    fn normal<L: Lanes<Scalar = S>>(&self, _: Vec3<L>, direction: Vec3<L>) -> Vec3<L> {
        let away = Vec3::splat(self.normal).dot(direction).gt(L::constant(0.0));
        let turned = Vec3::splat(-self.normal);
        Vec3::select(away, turned, Vec3::splat(self.normal))
    }

    /// p + n·1e-4.
    #[inline(always)]
    fn start<L: Lanes<Scalar = S>>(&self, point: Vec3<L>, normal: Vec3<L>) -> Vec3<L> {
        point + normal * L::constant(OFFSET)
    }
}

/// t = (n·point - n·o)/(n·d), where positive.
#[inline(always)]
pub(crate) fn plane_distance<L: Lanes>(
    plane: &TextbookPlane<L::Scalar>,
    rays: &Rays<L>,
) -> Distance<L> {
    let normal = Vec3::splat(plane.normal);
    let t = (L::splat(plane.offset) - normal.dot(rays.origin)) / normal.dot(rays.direction);
    Distance { t, met: t.gt(L::constant(0.0)) }
}
