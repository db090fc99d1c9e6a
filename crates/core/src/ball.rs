//! Eight rays against a ball: `reference::ball`, lane by lane.

use catoptric_scene::{Ball, Numerics};

use crate::lanes::{Lane, Lanes, Mask};
use crate::nearest::{Around, Form};
use crate::packet::{Distance, Rays};
use crate::vec3::Vec3;

/// A ball that is not around the eye.
impl<S: Lane> Form<S> for Ball<S> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = true;

    #[inline(always)]
    fn ball(&self) -> Option<&Ball<S>> {
        Some(self)
    }

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>, const EYE: bool>(
        &self,
        rays: &Rays<L>,
        own: Mask<L>,
    ) -> Option<Distance<L>> {
        let foot = foot(self, rays).without(own);
        if !foot.met().any() {
            return None;
        }
        Some(foot.near())
    }

    #[inline(always)]
    fn anchor(&self) -> Option<S::Vec3> {
        Some(self.center)
    }

    /// Arms from the centre; the engine shades a ball around the eye by this too.
    #[inline(always)]
    fn arm<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let x = rays.direction * t - (Vec3::splat(self.center) - rays.origin);
        if self.is_around() {
            return x * (L::splat(self.radius) / x.length());
        }
        let g = x.dot(rays.direction);
        let s = (L::splat(self.radius_squared) - x.dot(x) + g * g).positive().sqrt();
        x - rays.direction * (g + s)
    }

    #[inline(always)]
    fn normal<L: Lanes<Scalar = S>>(&self, arm: Vec3<L>, _: Vec3<L>) -> Vec3<L> {
        arm * (L::splat(self.side) / L::splat(self.radius))
    }
}

impl<S: Lane> Form<S> for Around<Ball<S>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>, const EYE: bool>(
        &self,
        rays: &Rays<L>,
        own: Mask<L>,
    ) -> Option<Distance<L>> {
        let Foot { b, discriminant } = foot(&self.0, rays);
        // Of a packet that left it whole, no root.
        let s = if own.all() { b } else { own.select(b, discriminant.positive().sqrt()) };
        let t = (b + s).not_behind();
        Some(Distance { t, met: t.ge(L::constant(0.0)) })
    }

    #[inline(always)]
    fn anchor(&self) -> Option<S::Vec3> {
        self.0.anchor()
    }

    #[inline(always)]
    fn arm<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        self.0.arm(rays, t)
    }

    #[inline(always)]
    fn normal<L: Lanes<Scalar = S>>(&self, arm: Vec3<L>, d: Vec3<L>) -> Vec3<L> {
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

#[inline(always)]
pub(crate) fn foot<L: Lanes>(ball: &Ball<L::Scalar>, rays: &Rays<L>) -> Foot<L> {
    let f = Vec3::splat(ball.center) - rays.origin;
    let b = f.dot(rays.direction);
    let x = rays.direction * b - f;
    Foot { b, discriminant: L::splat(ball.radius_squared) - x.dot(x) }
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

/// The lanes for which it, not around the eye, stands between `point` and a lamp at `distance` in
/// direction `l`.
#[inline(always)]
pub(crate) fn occludes<L: Lanes>(
    ball: &Ball<L::Scalar>,
    point: Vec3<L>,
    l: Vec3<L>,
    distance: L,
) -> Mask<L> {
    let f = Vec3::splat(ball.center) - point;
    let b = f.dot(l);
    let x = l * b - f;
    b.gt(L::constant(0.0)) & b.lt(distance) & x.dot(x).le(L::splat(ball.radius_squared))
}
