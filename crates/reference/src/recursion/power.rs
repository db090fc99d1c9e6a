//! The highlight's power, in operations that are the same on every machine.

use catoptric_scene::{Power, Scalar};

use super::ray::positive;
use super::real::{Bits, Real, consts};

/// The power max(0, x)^p for x at most 1 (rounding above it is cut); 0^0 is 1.
///
/// Error: whole p, about p/2 ulp; other p, 1.5e-6 relative where the result is above 1e-3,
/// growing to 5e-6 at 1e-15. Results below 1e-15 are 0. In f64 the error for other p is 2e-15,
/// growing to 1.5e-14 at 1e-18, and results below 1e-18 are 0.
#[inline(always)]
#[must_use]
pub fn power(x: Real, p: Power<Real>) -> Real {
    let x = positive(x);
    let x = if x < 1.0 { x } else { 1.0 };
    match p {
        Power::Whole { exponent, cut } => {
            if x <= cut {
                0.0
            } else {
                whole(x, exponent)
            }
        }
        Power::Real { exponent, cut } => {
            if x <= cut {
                0.0
            } else {
                exp2(exponent * log2(x))
            }
        }
    }
}

/// x^p by repeated squaring, from the lowest bit of p (Knuth, TAOCP 2, 4.6.3, algorithm A).
fn whole(x: Real, p: u32) -> Real {
    let mut result = 1.0;
    let mut square = x;
    let mut rest = p;
    while rest > 0 {
        if rest & 1 == 1 {
            result *= square;
        }
        square *= square;
        rest >>= 1;
    }
    result
}

/// log2 of a normal positive number: x = 2^e m, m in [sqrt(1/2), sqrt 2), and
/// log2 m = (2/ln 2) atanh(s), s = (m - 1)/(m + 1), by its series up to s^9 (next term 2e-9), in
/// f64 up to s^21 (6e-19).
fn log2(x: Real) -> Real {
    let bits = x.to_bits();
    let exponent = bits.wrapping_sub(SQRT_HALF_BITS).cast_signed() >> FRACTION_BITS;
    let m = Real::from_bits(bits.wrapping_sub((exponent << FRACTION_BITS).cast_unsigned()));
    let s = (m - 1.0) / (m + 1.0);
    let s2 = s * s;
    let series = horner(Real::LOG2_SERIES, s2);
    exponent as Real + s * series
}

/// 2^y for y in [-126, 0], in f64 [-1022, 0]: y = n + f, |f| <= 1/2, and the exponential series of
/// f ln 2 up to the seventh power (next term 5e-9), in f64 up to the 13th (4e-18).
fn exp2(y: Real) -> Real {
    // Adding 1.5·2^23 (f64: 1.5·2^52) rounds to a whole number, which then stands in the low
    // bits.
    let shifted = y + ROUNDING_SHIFT;
    let f = y - (shifted - ROUNDING_SHIFT);
    let one = (1.0 as Real).to_bits();
    let two_to_n = Real::from_bits((shifted.to_bits() << FRACTION_BITS).wrapping_add(one));
    horner(Real::EXP2_SERIES, f) * two_to_n
}

/// The polynomial c0 + c1 x + c2 x^2 + ..., from the highest power down.
fn horner(series: &[Real], x: Real) -> Real {
    series.iter().rev().fold(0.0, |sum, c| sum * x + c)
}

/// Bits of sqrt(1/2), the least m.
const SQRT_HALF_BITS: Bits = consts::FRAC_1_SQRT_2.to_bits();

/// Bits below a number's exponent.
const FRACTION_BITS: u32 = Real::MANTISSA_DIGITS - 1;

/// Number that rounds a sum to a whole number: 1.5·2^23, in f64 1.5·2^52.
const ROUNDING_SHIFT: Real = 1.5 / Real::EPSILON;
