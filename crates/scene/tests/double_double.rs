//! Double-double against arbitrary precision: the bounds that its head states.

use catoptric_scene::DoubleDouble;
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;
use proptest::prelude::*;

type Exact = FBig<HalfEven, 2>;

/// Enough bits for sums and products of the operands below to be exact.
const PRECISION: usize = 1000;

fn exact(x: f64) -> Exact {
    Exact::try_from(x).expect("finite").with_precision(PRECISION).value()
}

fn value(x: DoubleDouble) -> Exact {
    exact(x.to_f64()) + exact(x.low())
}

fn abs(x: Exact) -> Exact {
    if x < exact(0.0) { -x } else { x }
}

/// u^2 and u^3 for u = 2^-53.
const U2: f64 = 1.0 / ((1_u64 << 53) as f64 * (1_u64 << 53) as f64);
const U3: f64 = U2 / (1_u64 << 53) as f64;

/// |got - wanted| <= (squares u^2 + cubes u^3) |wanted|, and `got` is normalised.
fn assert_within(got: DoubleDouble, wanted: &Exact, [squares, cubes]: [f64; 2]) {
    let bound = exact(squares * U2) + exact(cubes * U3);
    let error = abs(value(got) - wanted);
    assert!(
        error <= bound * abs(wanted.clone()),
        "{got:?}: error {:e} u^2",
        (error / abs(wanted.clone())).to_f64().value() / U2
    );
    assert!((got.to_f64() + got.low()).to_bits() == got.to_f64().to_bits(), "{got:?}");
}

/// Sixteen orders of magnitude around 1, both signs, low part anywhere within half an ulp.
fn number() -> impl Strategy<Value = DoubleDouble> {
    (1.0..2.0_f64, -27..27_i32, any::<bool>(), -1.0..1.0_f64).prop_map(
        |(mantissa, exponent, negative, low)| {
            let hi = mantissa * f64::from(exponent).exp2() * if negative { -1.0 } else { 1.0 };
            DoubleDouble::difference(hi, -(hi * low * f64::EPSILON / 4.0))
        },
    )
}

#[expect(clippy::cast_precision_loss, reason = "at most 53 bits")]
fn in_f64(n: i64) -> f64 {
    n as f64
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(2000))]

    #[test]
    fn operations_keep_their_bounds(a in number(), b in number()) {
        let (x, y) = (value(a), value(b));
        assert_within(a + b, &(&x + &y), [3.0, 13.0]);
        assert_within(a - b, &(&x - &y), [3.0, 13.0]);
        assert_within(a * b, &(&x * &y), [7.0, 0.0]);
        assert_within(a / b, &(&x / &y), [15.0, 56.0]);
    }

    #[test]
    fn sums_keep_their_bound_where_high_parts_cancel(a in number(), b in number()) {
        // b is replaced by -a but for a few units of its last places.
        let near = -a + DoubleDouble::from(b.to_f64() * 1e-30);
        assert_within(a + near, &(value(a) + value(near)), [3.0, 13.0]);
    }

    #[test]
    fn roots_keep_their_bound(a in number()) {
        let a = if a.to_f64() < 0.0 { -a } else { a };
        let root = dashu_float::ops::SquareRoot::sqrt(&value(a));
        assert_within(a.sqrt(), &root, [4.0, 0.0]);
    }

    #[test]
    fn the_noise_of_a_turn_is_taken_out(short in -1i64 << 54..1 << 54, down in 0_i32..42, noise in -1.0..1.0_f64) {
        // Up to 54 bits, so middles between two f64 as well; a length of 2^54 or more.
        let short = DoubleDouble::difference(in_f64(short >> 1 << 1), -in_f64(short & 1));
        let short = short * DoubleDouble::from(f64::from(-down).exp2());
        let length = 1.5 * 54_f64.exp2();
        let near = short + DoubleDouble::from(noise * length * (-100_f64).exp2());
        let found = near.on_grid_of(length);
        prop_assert_eq!(found.to_f64().to_bits(), short.to_f64().to_bits());
        prop_assert_eq!(value(found), value(short));
    }

    #[test]
    fn differences_are_exact(a in number(), b in number()) {
        let (a, b) = (a.to_f64(), b.to_f64());
        prop_assert_eq!(value(DoubleDouble::difference(a, b)), exact(a) - exact(b));
    }

    #[test]
    fn rounding_to_f32_takes_the_nearest(a in number()) {
        assert_nearest(a);
    }

    #[test]
    fn low_parts_decide_ties(bits in 0..0x7f7f_ffff_u32, low in -1.0..1.0_f64) {
        // All finite f32 but the largest, subnormal ones too.
        let below = f32::from_bits(bits);
        let middle = (f64::from(below) + f64::from(below.next_up())) / 2.0;
        for low in [0.0, low * middle * f64::EPSILON / 4.0, 1e-200, -1e-200] {
            let tie = DoubleDouble::difference(middle, -low);
            assert_nearest(tie);
            assert_nearest(-tie);
        }
    }
}

/// No other f32 is nearer, and of two equally near the even one is taken.
fn assert_nearest(x: DoubleDouble) {
    let rounded = x.to_f32();
    let distance = |candidate: f32| abs(value(x) - exact(f64::from(candidate)));
    for other in [rounded.next_up(), rounded.next_down()] {
        assert!(distance(rounded) <= distance(other), "{x:?} became {rounded:e}");
        let even = rounded.to_bits().is_multiple_of(2);
        assert!(even || distance(rounded) < distance(other), "{x:?} became the odd {rounded:e}");
    }
}

#[test]
fn roots_of_zero_and_of_negative_numbers() {
    assert_eq!(DoubleDouble::from(0.0).sqrt().to_f64(), 0.0);
    assert!(DoubleDouble::from(-1.0).sqrt().to_f64().is_nan());
}

#[test]
fn order_looks_at_the_low_part() {
    let above = DoubleDouble::difference(1.0, -1e-20);
    let below = DoubleDouble::difference(1.0, 1e-20);
    assert!(below < DoubleDouble::from(1.0) && DoubleDouble::from(1.0) < above);
    assert_eq!(DoubleDouble::from(f64::NAN).partial_cmp(&above), None);
}
