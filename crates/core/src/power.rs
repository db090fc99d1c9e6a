//! The highlight's power: `reference::power`, lane by lane.

use catoptric_scene::Power;

use crate::lanes::{LANES, Lanes};

/// max(0, x)^p for x at most 1; 0^0 is 1. The exponent is the same in all lanes.
///
/// Lanes below the cut would become subnormal, which costs a hundred cycles: they compute
/// with 1 and are dropped.
#[inline(always)]
pub(crate) fn power<L: Lanes>(x: L, p: Power) -> L {
    let one = L::splat(1.0);
    let x = x.positive();
    let x = x.lt(one).select(x, one);
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
    let mut result = L::splat(1.0);
    let mut square = x;
    let mut rest = p;
    while rest > 0 {
        if rest & 1 == 1 {
            result = result * square;
        }
        square = square * square;
        rest >>= 1;
    }
    result
}

/// log2 of normal positive lanes; other lanes hold nonsense.
#[inline(always)]
fn log2<L: Lanes>(x: L) -> L {
    let mut m = x.to_array();
    let mut e = [0.0; LANES];
    for i in 0..LANES {
        let bits = m[i].to_bits();
        let exponent = bits.wrapping_sub(SQRT_HALF_BITS).cast_signed() >> 23;
        m[i] = f32::from_bits(bits.wrapping_sub((exponent << 23).cast_unsigned()));
        e[i] = exponent as f32;
    }
    let (m, e) = (L::from_array(m), L::from_array(e));
    let one = L::splat(1.0);
    let s = (m - one) / (m + one);
    let s2 = s * s;
    let [c1, c3, c5, c7, c9] = Power::LOG2_SERIES;
    let series = L::splat(c9) * s2 + L::splat(c7);
    let series = series * s2 + L::splat(c5);
    let series = series * s2 + L::splat(c3);
    let series = series * s2 + L::splat(c1);
    e + s * series
}

/// 2^y for lanes in [-126, 0]; other lanes hold nonsense.
#[inline(always)]
fn exp2<L: Lanes>(y: L) -> L {
    let shift = L::splat(ROUNDING_SHIFT);
    let shifted = y + shift;
    let f = y - (shifted - shift);
    let mut series = L::splat(Power::EXP2_SERIES[7]);
    for j in (0..7).rev() {
        series = series * f + L::splat(Power::EXP2_SERIES[j]);
    }
    let mut two_to_n = shifted.to_array();
    for lane in &mut two_to_n {
        *lane = f32::from_bits((lane.to_bits() << 23).wrapping_add(1.0f32.to_bits()));
    }
    series * L::from_array(two_to_n)
}

/// sqrt(1/2) as bits: where m starts.
const SQRT_HALF_BITS: u32 = 0x3f35_04f3;

/// 1.5·2^23.
const ROUNDING_SHIFT: f32 = 12_582_912.0;
