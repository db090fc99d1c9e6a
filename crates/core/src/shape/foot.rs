//! How eight rays pass a sphere, before it is known where they meet it.

use crate::ray::Distance;
use crate::simd::{Lanes, Mask};

/// The foot of the perpendicular from the centre on eight rays.
#[derive(Clone, Copy)]
pub(crate) struct Foot<L> {
    /// How far along the ray it is.
    pub(crate) b: L,
    /// r^2 less the square of its distance from the centre.
    pub(crate) discriminant: L,
}

impl<L: Lanes> Foot<L> {
    /// Lets the lanes `on_self` meet nothing: their discriminant becomes NaN.
    #[inline(always)]
    pub(crate) fn without(self, on_self: Mask<L>) -> Self {
        Self { discriminant: on_self.or_nan(self.discriminant), ..self }
    }

    /// The lanes that meet the sphere, which is not around the eye.
    #[inline(always)]
    pub(crate) fn met(self) -> Mask<L> {
        let zero = L::constant(0.0);
        self.b.gt(zero) & self.discriminant.ge(zero)
    }

    /// Distances at which they meet it.
    #[inline(always)]
    pub(crate) fn near(self) -> Distance<L> {
        let t = (self.b - self.discriminant.sqrt()).not_behind();
        Distance { t, met: self.met() }
    }
}
