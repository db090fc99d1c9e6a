//! What the engine asks of a form.

use catoptric_scene::Numerics;
use glam::DVec3;

use super::foot::Foot;
use super::horizon::Horizon;
use crate::ray::{Distance, Rays};
use crate::simd::{Lanes, Mask, Vec3};

/// The constants of a form, lane by lane, and its formulas on eight rays.
///
/// Each is the reference's, operation by operation. Idle lanes compute what is never read.
pub(crate) trait Shape<L: Lanes>: Copy {
    /// The formulas that it belongs to.
    const NUMERICS: Numerics;
    /// Whether rays that left it do not meet it next, whatever it is computed to be.
    const SKIPS_SELF: bool;

    /// Whether packets are tested in two passes: first the feet of all, then the distances of those
    /// that meet it.
    const TWO_PASSES: bool = false;

    /// The foot of the perpendicular on rays, of a form that is tested in two passes.
    #[inline(always)]
    fn foot(&self, _: &Rays<L>) -> Option<Foot<L>> {
        None
    }

    /// Distances to it, unless all lanes miss it. `on_self`: the lanes whose ray starts on it.
    /// `EYE`: all rays start at the eye.
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, on_self: Mask<L>) -> Option<Distance<L>>;

    /// The lanes for which it stands between the origin of a shadow ray and a light at `limit`.
    fn blocks(&self, rays: &Rays<L>, limit: L) -> Mask<L>;

    /// What its points are measured from: a sphere's centre, or else the eye.
    #[inline(always)]
    fn anchor(&self) -> Option<Vec3<L>> {
        None
    }

    /// Arms: the ways from the anchor to where rays meet it, at distances `t`.
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L>;

    /// Unit normals where rays in `direction` meet it.
    fn normal(&self, arm: Vec3<L>, direction: Vec3<L>) -> Vec3<L>;

    /// The points at the end of arms.
    #[inline(always)]
    fn point(&self, arm: Vec3<L>) -> Vec3<L> {
        match self.anchor() {
            Some(anchor) => anchor + arm,
            None => arm,
        }
    }

    /// A point, relative to the anchor. Less an arm it is the way to it from the arm's end:
    /// `reference::trace::Surface::to`.
    #[inline(always)]
    fn relative(&self, point: Vec3<L>) -> Vec3<L> {
        match self.anchor() {
            Some(anchor) => point - anchor,
            None => point,
        }
    }

    /// Starts of the rays that leave such points.
    #[inline(always)]
    fn start(&self, point: Vec3<L>, _normal: Vec3<L>) -> Vec3<L> {
        point
    }
}

/// A form that the eye is inside of.
#[derive(Clone, Copy)]
pub(crate) struct Inside<F>(pub(crate) F);

/// Code that is compiled for each form.
pub(crate) trait ShapeVisitor<L: Lanes> {
    type Output;

    /// Must be `#[inline(always)]`, with all that it calls.
    fn visit<F: Shape<L>>(self, shape: F) -> Self::Output;
}

/// What a plan and the cullers ask of a form, before anything is traced. All in f64, relative to
/// the eye.
///
/// What a form says nothing about is never culled: each answer has a safe default.
pub(crate) trait Facts {
    /// Whether it is a sphere or a plane, however computed.
    fn kind(&self) -> Kind;

    /// Whether the eye is inside of it.
    fn encloses_eye(&self) -> bool {
        false
    }

    /// Centre and radius, of a form whose points are within rounding of that sphere.
    fn sphere(&self) -> Option<(DVec3, f64)> {
        None
    }

    /// How far its farthest point is from the eye; `None` if there is no end.
    fn reach(&self) -> Option<f64> {
        None
    }

    /// The directions in which it may be seen.
    fn view(&self) -> View {
        View::Everywhere
    }

    /// How it may stand before a light.
    fn blocker(&self) -> Blocker {
        Blocker::Anywhere
    }
}

/// What users call a form.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(crate) enum Kind {
    /// A sphere by centre and radius.
    Sphere,
    /// A sphere by its height function.
    LargeSphere,
    Plane,
}

/// The directions in which the eye may see a form.
pub(crate) enum View {
    /// All directions: it is around the eye, close to it, or not bounded.
    Everywhere,
    /// A disc: the outline of the sphere of [`Facts::sphere`].
    Disc,
    /// Directions within a right angle of the axis, which need not be a unit vector.
    Half { axis: DVec3 },
}

/// The places in which a form may stand between a light and a point.
pub(crate) enum Blocker {
    /// Nowhere.
    Nowhere,
    /// The sphere of [`Facts::sphere`].
    Sphere,
    /// Beyond its horizon: the way to the light falls towards its surface first.
    Horizon(Horizon),
    /// Anywhere.
    Anywhere,
}
