//! The two kinds of number that truth computes in.

use std::ops::{Add, Div, Mul, Neg, Sub};

use catoptric_scene::DoubleDouble;

/// A number of truth: f64 (53 bits) or double-double (about 106 bits).
///
/// Every f64 converts exactly, so the difference of two f64, formed in this arithmetic, is
/// rounded once in f64 and exact in double-double.
pub(super) trait Real:
    Copy
    + Send
    + Sync
    + PartialOrd
    + From<f64>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// The square root; NaN for a negative number.
    fn sqrt(self) -> Self;

    /// The nearest f64.
    fn to_f64(self) -> f64;

    /// This number, or 0 if it is negative.
    fn at_least_zero(self) -> Self {
        let zero = Self::from(0.0);
        if self < zero { zero } else { self }
    }
}

impl Real for f64 {
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }

    fn to_f64(self) -> f64 {
        self
    }
}

impl Real for DoubleDouble {
    fn sqrt(self) -> Self {
        DoubleDouble::sqrt(self)
    }

    fn to_f64(self) -> f64 {
        DoubleDouble::to_f64(self)
    }
}
