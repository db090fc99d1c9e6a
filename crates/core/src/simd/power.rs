//! The highlight's power: `reference::power`, lane by lane.

use catoptric_scene::{Power, Scalar};

use super::bits::Bits;
use super::lanes::{LANES, Lanes};

/// max(0, x)^p for x at most 1; 0^0 is 1. The exponent is the same in all lanes.
///
/// Lanes below the cut would become subnormal, which costs a hundred cycles: they compute
/// with 1 and are dropped.
#[inline(always)]
pub(crate) fn power<L: Lanes>(x: L, p: Power<L::Scalar>) -> L {
    let one = L::constant(1.0);
    let x = x.positive().min_or_second(one);
    match p {
        Power::Whole { exponent, cut } => {
            let low = x.le(L::splat(cut));
            low.drop(whole(low.select(one, x), exponent))
        }
        Power::Real { exponent, cut } => {
            let low = x.le(L::splat(cut));
            low.drop(exp2(L::splat(exponent) * log2(low.select(one, x))))
        }
    }
}

/// Repeated squaring, from the lowest bit of p.
#[inline(always)]
fn whole<L: Lanes>(x: L, p: u32) -> L {
    let mut result = L::constant(1.0);
    let mut square = x;
    let mut rest = p;
    loop {
        if rest & 1 == 1 {
            result = result * square;
        }
        rest >>= 1;
        if rest == 0 {
            return result;
        }
        square = square * square;
    }
}

/// log2 of normal positive lanes; other lanes hold nonsense.
#[inline(always)]
fn log2<L: Lanes>(x: L) -> L {
    let mut m = x.to_array();
    let mut e = [L::Scalar::ZERO; LANES];
    for i in 0..LANES {
        (e[i], m[i]) = m[i].exponent_and_mantissa();
    }
    let (m, e) = (L::from_array(m), L::from_array(e));
    let one = L::constant(1.0);
    let s = (m - one) / (m + one);
    let s2 = s * s;
    e + s * horner(L::Scalar::LOG2_SERIES, s2)
}

/// 2^y for lanes in [-126, 0], in f64 [-1022, 0]; other lanes hold nonsense.
#[inline(always)]
fn exp2<L: Lanes>(y: L) -> L {
    let shift = L::splat(L::Scalar::ROUNDING_SHIFT);
    let shifted = y + shift;
    let f = y - (shifted - shift);
    let mut two_to_n = shifted.to_array();
    for lane in &mut two_to_n {
        *lane = lane.two_to_shifted();
    }
    horner(L::Scalar::EXP2_SERIES, f) * L::from_array(two_to_n)
}

/// c0 + c1 x + c2 x^2 + ..., from the highest power down.
#[inline(always)]
fn horner<L: Lanes>(series: &[L::Scalar], x: L) -> L {
    let [rest @ .., last] = series else { return L::constant(0.0) };
    let mut sum = L::splat(*last);
    for &c in rest.iter().rev() {
        sum = sum * x + L::splat(c);
    }
    sum
}
