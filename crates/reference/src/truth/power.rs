//! The highlight's power.

use super::real::Real;

/// `base` to the power `exponent`, for a base in [0, 1] and a finite exponent >= 0.
///
/// Error: a whole exponent e costs about e rounding errors of T, relative to the result; a
/// fraction adds about 1e-16 relative in either arithmetic, because its factor comes from
/// f64's `powf` (the machine's libm) corrected to first order for the low part of the base.
/// Only colours depend on it, never a path.
/// Edge: x^0 is 1, also for x = 0; results below the least f64 become 0.
pub(super) fn power<T: Real>(base: T, exponent: f64) -> T {
    if exponent == 0.0 {
        return T::from(1.0);
    }
    let high = base.to_f64();
    if high == 0.0 {
        return T::from(0.0);
    }
    let fraction = exponent.fract();
    let whole = whole_power(base, exponent.trunc());
    if fraction == 0.0 {
        return whole;
    }
    // (h + l)^q = h^q (1 + q l/h + ...), and (l/h)² is below 1e-32.
    let correction = T::from(1.0) + T::from(fraction * (base.low() / high));
    whole * T::from(high.powf(fraction)) * correction
}

/// Binary powering. The exponent stays an f64, in which halving and remainders of whole
/// numbers are exact up to the largest one.
fn whole_power<T: Real>(base: T, exponent: f64) -> T {
    let mut square = base;
    let mut left = exponent;
    let mut product = T::from(1.0);
    while left > 0.0 {
        if left % 2.0 == 1.0 {
            product = product * square;
        }
        square = square * square;
        left = (left / 2.0).trunc();
    }
    product
}
