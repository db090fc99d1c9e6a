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
    fn distance<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
        let zero = L::constant(0.0);
        let (b, discriminant) = foot(self, rays);
        let met = (b.gt(zero) & discriminant.ge(zero)).without(own);
        // Most packets miss most balls: the root is worth a branch.
        if !met.any() {
            return None;
        }
        Some(Distance { t: (b - discriminant.sqrt()).not_behind(), met })
    }

    #[inline(always)]
    fn place<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        let f = Vec3::splat(self.center) - rays.origin;
        let x = rays.direction * t - f;
        x * (L::constant(1.0) / x.length())
    }

    /// Of the unit vector from the centre.
    #[inline(always)]
    fn surface<L: Lanes<Scalar = S>>(&self, outward: Vec3<L>, _: Vec3<L>) -> (Vec3<L>, Vec3<L>) {
        let point = Vec3::splat(self.center) + outward * L::splat(self.radius);
        (point, outward * L::splat(self.side))
    }
}

impl<S: Lane> Form<S> for Around<Ball<S>> {
    const NUMERICS: Numerics = Numerics::Robust;
    const LEFT_BEHIND: bool = false;

    #[inline(always)]
    fn distance<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>> {
        let (b, discriminant) = foot(&self.0, rays);
        let s = own.select(b, discriminant.positive().sqrt());
        let t = (b + s).not_behind();
        Some(Distance { t, met: t.ge(L::constant(0.0)) })
    }

    #[inline(always)]
    fn place<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L> {
        self.0.place(rays, t)
    }

    #[inline(always)]
    fn surface<L: Lanes<Scalar = S>>(&self, outward: Vec3<L>, d: Vec3<L>) -> (Vec3<L>, Vec3<L>) {
        self.0.surface(outward, d)
    }
}

/// The distance of the foot of the perpendicular from the centre, and r^2 - its square.
#[inline(always)]
fn foot<L: Lanes>(ball: &Ball<L::Scalar>, rays: &Rays<L>) -> (L, L) {
    let f = Vec3::splat(ball.center) - rays.origin;
    let b = f.dot(rays.direction);
    let x = rays.direction * b - f;
    (b, L::splat(ball.radius_squared) - x.dot(x))
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
