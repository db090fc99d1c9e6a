//! The highlight's power.

use super::real::Real;

/// `base` to the power `exponent`, for a base in [0, 1] and a finite exponent >= 0.
///
/// Method: squarings for the whole part and square roots for the fraction, one for each bit of
/// the exponent. An f64 is a finite sum of powers of two, so no logarithm is needed, no
/// libm decides, and double-double keeps its digits.
/// Error, relative: about as many rounding errors of T as the larger of the exponent and
/// its number of bits.
/// Edge: x^0 is 1, also for x = 0; results below the least f64 become 0.
pub(super) fn power<T: Real>(base: T, exponent: f64) -> T {
    let mut product = T::from(1.0);

    // base, base², base⁴ ... for the bits of the whole part. It stays an f64, in which
    // halving and remainders of whole numbers are exact up to the largest one.
    let mut square = base;
    let mut whole = exponent.trunc();
    while whole > 0.0 {
        if whole % 2.0 == 1.0 {
            product = product * square;
        }
        square = square * square;
        whole = (whole / 2.0).trunc();
    }

    // base^(1/2), base^(1/4) ... for the bits of the fraction.
    let mut root = base;
    let mut fraction = exponent.fract();
    while fraction > 0.0 {
        root = root.sqrt();
        fraction *= 2.0;
        if fraction >= 1.0 {
            product = product * root;
            fraction -= 1.0;
        }
    }
    product
}
