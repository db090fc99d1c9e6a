//! The highlight's power beside one on a scalar, by loops in place of bits.

use catoptric_scene::{Power, Scalar};

use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, power, run};

struct Powers<S: Scalar>([S; LANES], Power<S>);

impl<S: TestScalar> Kernel for Powers<S> {
    type Scalar = S;
    type Output = [S; LANES];

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        power(L::from_array(self.0), self.1).to_array()
    }
}

/// x^p as [`Power`] says it: 0 at the cut and below, and x taken into [0, 1] first.
fn plain<S: TestScalar>(x: S, p: Power<S>) -> S {
    let one = S::rounded(1.0);
    let x = if x > S::ZERO { x } else { S::ZERO };
    let x = if x < one { x } else { one };
    match p {
        Power::Whole { cut, .. } | Power::Real { cut, .. } if x <= cut => S::ZERO,
        Power::Whole { exponent, .. } => {
            let mut squares = vec![x];
            for bit in 1..32 {
                squares.push(squares[bit - 1] * squares[bit - 1]);
            }
            let of_bits = (0..32).filter(|bit| exponent >> bit & 1 != 0);
            of_bits.fold(one, |product, bit| product * squares[bit])
        }
        Power::Real { exponent, .. } => two_to(exponent * log2(x)),
    }
}

/// x = 2^e m with m in [sqrt(1/2), sqrt 2), then the series of m.
fn log2<S: TestScalar>(x: S) -> S {
    let (one, two) = (S::rounded(1.0), S::rounded(2.0));
    let start = S::rounded(std::f64::consts::FRAC_1_SQRT_2);
    let (mut e, mut m) = (S::ZERO, x);
    while m < start {
        (e, m) = (e - one, m * two);
    }
    while m / two >= start {
        (e, m) = (e + one, m / two);
    }
    let s = (m - one) / (m + one);
    let square = s * s;
    e + s * sum(S::LOG2_SERIES, square)
}

/// y is rounded to a whole number, of two the even one; the rest goes into the series.
fn two_to<S: TestScalar>(y: S) -> S {
    let whole = y.to_f64().round_ties_even();
    let series = sum(S::EXP2_SERIES, y - S::rounded(whole));
    let half = S::rounded(0.5);
    let mut power = S::rounded(1.0);
    for _ in 0..-whole as i32 {
        power = power * half;
    }
    series * power
}

fn sum<S: TestScalar>(series: &[S], x: S) -> S {
    let (last, rest) = series.split_last().expect("a series");
    rest.iter().rev().fold(*last, |sum, &c| sum * x + c)
}

/// An exponent as a scene compiles it.
fn compiled<S: Scalar>(p: f64, whole: bool) -> Power<S> {
    if p == 0.0 {
        return Power::Whole { exponent: 0, cut: S::rounded(-1.0) };
    }
    let cut = S::rounded((S::FAINTEST / p).exp2());
    let cut = if cut < S::MIN_POSITIVE { S::MIN_POSITIVE } else { cut };
    if whole {
        Power::Whole { exponent: p as u32, cut }
    } else {
        Power::Real { exponent: S::rounded(p), cut }
    }
}

fn check<S: TestScalar>(p: Power<S>, numbers: &mut Numbers) {
    let (Power::Whole { cut, .. } | Power::Real { cut, .. }) = p;
    let around_cut = [cut, cut.next_above(), cut.next_below()];
    let mut bases = S::edges();
    bases.extend(around_cut);
    bases.extend((0..128).map(|_| S::rounded(numbers.between(0.0, 1.0))));
    bases.extend((0..32).map(|_| S::rounded(1.0 - numbers.magnitude(1e-16, 0.1))));
    bases.extend((0..32).map(|_| numbers.any::<S>()));
    for isa in isas() {
        for start in 0..bases.len() {
            let x = std::array::from_fn(|lane| bases[(start + 37 * lane) % bases.len()]);
            for (x, found) in x.into_iter().zip(run(isa, Powers(x, p))) {
                let expected = plain(x, p);
                let same = found.pattern() == expected.pattern();
                assert!(same, "{isa} {x:?}^{p:?} is {found:?}, not {expected:?}");
            }
        }
    }
}

#[test]
fn power_is_the_scalars() {
    let mut numbers = Numbers::new(7);
    for p in (0..=40).chain([63, 64, 65, 127, 255, 256, 1000, 1023, 1024]) {
        check(compiled::<f32>(p.into(), true), &mut numbers);
        check(compiled::<f64>(p.into(), true), &mut numbers);
    }
    let real = [1e-300, 1e-9, 0.25, 0.5, 0.999, 1.5, 3.25, 50.5, 1024.5, 1025.0, 1e5, 1e12];
    for p in real {
        check(compiled::<f32>(p, false), &mut numbers);
        check(compiled::<f64>(p, false), &mut numbers);
    }
}
