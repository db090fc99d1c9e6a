//! Eight rays against a ball: `reference::ball`, lane by lane.

use catoptric_scene::Numerics;

use crate::lanes::{Lanes, Mask};
use crate::nearest::{Around, Form};
use crate::packet::{Distance, Rays};
use crate::vec3::Vec3;

/// The constants of `catoptric_scene::Ball`, in every lane.
#[derive(Clone, Copy)]
pub(crate) struct Ball<L> {
    center: Vec3<L>,
    radius: L,
    radius_squared: L,
    /// What an arm is multiplied by to be the normal: side / radius.
    normal_scale: L,
    around: bool,
}

impl<L: Lanes> Ball<L> {
    #[inline(always)]
    pub(crate) fn splat(ball: &catoptric_scene::Ball<L::Scalar>) -> Self {
        Self {
            center: Vec3::splat(ball.center),
            radius: L::splat(ball.radius),
            radius_squared: L::splat(ball.radius_squared),
            normal_scale: L::splat(ball.side) / L::splat(ball.radius),
            around: ball.is_around(),
        }
    }

    /// The foot of the perpendicular from the centre on rays.
    #[inline(always)]
    pub(crate) fn foot(&self, rays: &Rays<L>) -> Foot<L> {
        let f = self.center - rays.origin;
        let b = f.dot(rays.direction);
        let x = rays.direction * b - f;
        let from_center = x.dot(x);
        Foot { b, discriminant: self.radius_squared - from_center }
    }

    /// The lanes for which it, not around the eye, stands between `point` and a lamp at `distance` in
    /// direction `l`.
    #[inline(always)]
    pub(crate) fn occludes(&self, point: Vec3<L>, l: Vec3<L>, distance: L) -> Mask<L> {
        let f = self.center - point;
        let b = f.dot(l);
        let x = l * b - f;
        b.gt(L::constant(0.0)) & b.lt(distance) & x.dot(x).le(self.radius_squared)
    }
}

/// A ball that is not around the eye.
impl<L: Lanes> Form<L> for Ball<L> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = true;

    #[inline(always)]
    fn ball(&self) -> Option<&Ball<L>> {
        Some(self)
    }

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
        let foot = self.foot(rays).without(own);
        if !foot.met().any() {
            return None;
        }
        Some(foot.near())
    }

    #[inline(always)]
    fn anchor(&self) -> Option<Vec3<L>> {
        Some(self.center)
    }

    /// Arms from the centre; the engine shades a ball around the eye by this too.
    #[inline(always)]
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let x = rays.direction * t - (self.center - rays.origin);
        if self.around {
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

impl<L: Lanes> Form<L> for Around<Ball<L>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
        let Foot { b, discriminant } = self.0.foot(rays);
        // Of a packet that left it whole, no root.
        let s = if own.all() { b } else { own.select(b, discriminant.positive().sqrt()) };
        let t = (b + s).not_behind();
        Some(Distance { t, met: t.ge(L::constant(0.0)) })
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

/// The foot of the perpendicular from the centre on eight rays.
#[derive(Clone, Copy)]
pub(crate) struct Foot<L> {
    /// How far along the ray it is.
    pub(crate) b: L,
    /// r^2 less the square of its distance from the centre.
    pub(crate) discriminant: L,
}

impl<L: Lanes> Foot<L> {
    /// The lanes `own` meet nothing: their discriminant is NaN.
    #[inline(always)]
    pub(crate) fn without(self, own: Mask<L>) -> Self {
        Self { discriminant: own.or_nan(self.discriminant), ..self }
    }

    /// The lanes that meet the ball, not around the eye.
    #[inline(always)]
    pub(crate) fn met(self) -> Mask<L> {
        let zero = L::constant(0.0);
        self.b.gt(zero) & self.discriminant.ge(zero)
    }

    /// Where they do.
    #[inline(always)]
    pub(crate) fn near(self) -> Distance<L> {
        let t = (self.b - self.discriminant.sqrt()).not_behind();
        Distance { t, met: self.met() }
    }
}
