//! Rays, and what they find: the types that the recursion and its shapes share.

use super::real::{Real, Vec3};

/// A ray. Units: |direction| is 1, up to rounding.
#[derive(Clone, Copy, Debug)]
pub struct Ray {
    /// Start, relative to the eye.
    pub origin: Vec3,
    /// Direction of unit length.
    pub direction: Vec3,
    /// The primitive that the ray just left, which it does not meet again; robust only.
    pub left: Option<usize>,
}

/// The place where a ray meets a primitive.
#[derive(Clone, Copy, Debug)]
pub struct Surface {
    /// The point that is lit.
    pub point: Vec3,
    /// The point before it was rounded is `anchor + arm`, from which lights are seen: see
    /// [`Surface::to`]. On a robust sphere this is the centre; elsewhere the point itself.
    pub anchor: Vec3,
    /// The other part of that sum: on a robust sphere along the radius; elsewhere 0.
    pub arm: Vec3,
    /// The unit normal at the point.
    pub normal: Vec3,
    /// Start of shadow and mirrored rays: the point itself, or the workshop's offset point.
    pub start: Vec3,
    /// Primitive that shadow and mirrored rays leave: this one, or none where an offset is used.
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
    /// Distance from the ray's origin, in multiples of |direction|.
    pub distance: Real,
    /// The surface at the hit.
    pub surface: Surface,
    /// The ambient light and the light of lights that the hit sends back along the ray.
    pub local: Vec3,
    /// The mirror factor.
    pub k: Real,
    /// The ray that the mirror sends on, whether or not it is followed.
    pub mirrored: Ray,
}

/// The larger of 0 and x; 0 for NaN and for -0.
pub(crate) fn positive(x: Real) -> Real {
    if x > 0.0 { x } else { 0.0 }
}

/// The larger of 0 and a distance; NaN is kept. A ray that starts behind a surface by rounding
/// meets it at once.
pub(crate) fn not_behind(t: Real) -> Real {
    if t < 0.0 { 0.0 } else { t }
}
