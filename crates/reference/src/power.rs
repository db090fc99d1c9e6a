//! The highlight's power, in operations that are the same on every machine.

use catoptric_scene::Power;

use crate::trace::positive;

/// max(0, x)^p for x at most 1 (rounding above it is cut); 0^0 is 1.
///
/// Error: whole p, about p/2 ulp; other p, 1.5e-6 relative where the result is above 1e-3,
/// growing to 5e-6 at 1e-15. Results below 1e-15 are 0.
#[must_use]
pub fn power(x: f32, p: Power) -> f32 {
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

/// Repeated squaring, from the lowest bit of p (Knuth, TAOCP 2, 4.6.3, algorithm A).
fn whole(x: f32, p: u32) -> f32 {
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
/// log2 m = (2/ln 2) atanh(s), s = (m - 1)/(m + 1), by its series up to s^9 (next term 2e-9).
fn log2(x: f32) -> f32 {
    let bits = x.to_bits();
    let exponent = bits.wrapping_sub(SQRT_HALF_BITS).cast_signed() >> 23;
    let m = f32::from_bits(bits.wrapping_sub((exponent << 23).cast_unsigned()));
    let s = (m - 1.0) / (m + 1.0);
    let s2 = s * s;
    let [c1, c3, c5, c7, c9] = Power::LOG2_SERIES;
    let series = (((c9 * s2 + c7) * s2 + c5) * s2 + c3) * s2 + c1;
    exponent as f32 + s * series
}

/// 2^y for y in [-126, 0]: y = n + f, |f| <= 1/2, and the exponential series of f ln 2 up to
/// the seventh power (next term 5e-9).
fn exp2(y: f32) -> f32 {
    // Adding 1.5·2^23 rounds to a whole number, which then stands in the low bits.
    let shifted = y + ROUNDING_SHIFT;
    let f = y - (shifted - ROUNDING_SHIFT);
    let [c0, c1, c2, c3, c4, c5, c6, c7] = Power::EXP2_SERIES;
    let series = ((((((c7 * f + c6) * f + c5) * f + c4) * f + c3) * f + c2) * f + c1) * f + c0;
    let two_to_n = f32::from_bits((shifted.to_bits() << 23).wrapping_add(1.0f32.to_bits()));
    series * two_to_n
}

/// sqrt(1/2) as bits: where m starts.
const SQRT_HALF_BITS: u32 = 0x3f35_04f3;

/// 1.5·2^23.
const ROUNDING_SHIFT: f32 = 12_582_912.0;
