//! Rays, and what they find: the words that the recursion and its shapes share.

use super::real::{Real, Vec3};

/// A ray. Units: |direction| is 1, up to rounding.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Where it starts, relative to the eye.
    pub origin: Vec3,
    /// Where it goes.
    pub direction: Vec3,
    /// The primitive that it just left, which it does not meet again; robust only.
    pub left: Option<usize>,
}

/// The place where a ray meets a primitive.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The point that is lit.
    pub point: Vec3,
    /// The point before it was rounded, as a sum: from a sphere's centre, along the radius. Elsewhere
    /// it is the point itself and 0. Lights are seen from there: see [`Surface::to`].
    pub anchor: Vec3,
    /// See `anchor`.
    pub arm: Vec3,
    /// The unit normal there.
    pub normal: Vec3,
    /// Where shadow and mirrored rays start: the point itself, or the workshop's offset.
    pub start: Vec3,
    /// Which primitive those rays leave: this one, or none where an offset is used.
    pub left: Option<usize>,
}

impl Surface {
    /// The way from the point to a light.
    ///
    /// Far from the eye the rounding of a point may be no less than the sphere that it is on, and a
    /// light beside it would seem to stand elsewhere. The difference of two places that are close
    /// together is exact, so the light is seen from the centre, and the radius is taken off.
    #[inline(always)]
    #[must_use]
    pub fn to(&self, light: Vec3) -> Vec3 {
        (light - self.anchor) - self.arm
    }
}

/// What a ray finds where it meets a primitive.
#[derive(Clone, Copy, Debug)]
pub struct Hit {
    /// Index of the primitive.
    pub primitive: usize,
    /// From the ray's origin, in multiples of |direction|.
    pub distance: Real,
    /// The place.
    pub surface: Surface,
    /// The light that lights send from there towards the ray's origin.
    pub local: Vec3,
    /// The mirror factor.
    pub k: Real,
    /// The ray that the mirror sends on, whether or not it is followed.
    pub mirrored: Ray,
}

/// max(0, x), with 0 for NaN and for -0.
pub(crate) fn positive(x: Real) -> Real {
    if x > 0.0 { x } else { 0.0 }
}

/// max(0, t) of a distance, NaN kept: a start that rounding put behind a surface meets it
/// at once.
pub(crate) fn not_behind(t: Real) -> Real {
    if t < 0.0 { 0.0 } else { t }
}
