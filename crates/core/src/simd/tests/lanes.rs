//! Arithmetic, comparisons and bits of lanes.

use super::{Named, Operands, compare, operands};
use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, Mask, run};

/// Operations that round, or tell NaN from numbers.
struct Arithmetic<'a, S>(&'a Operands<S>);

impl<S: TestScalar> Kernel for Arithmetic<'_, S> {
    type Scalar = S;
    type Output = [Named<S>; 5];

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        let (a, b) = (L::from_array(self.0.a), L::from_array(self.0.b));
        [
            ("+", (a + b).to_array()),
            ("-", (a - b).to_array()),
            ("*", (a * b).to_array()),
            ("/", (a / b).to_array()),
            ("sqrt", a.sqrt().to_array()),
        ]
    }
}

#[test]
fn arithmetic_is_the_scalars() {
    fn check<S: TestScalar>() {
        for isa in isas() {
            for of in operands::<S>() {
                let plain = |lane: usize| {
                    let (a, b) = (of.a[lane], of.b[lane]);
                    [("+", a + b), ("-", a - b), ("*", a * b), ("/", a / b), ("sqrt", a.root())]
                };
                let context = |lane: usize| format!("{isa} {:?} {:?}", of.a[lane], of.b[lane]);
                compare(run(isa, Arithmetic(&of)), plain, false, &context);
            }
        }
    }
    check::<f32>();
    check::<f64>();
}

/// Operations that compare numbers, or move their bits.
struct Choice<'a, S>(&'a Operands<S>);

impl<S: TestScalar> Kernel for Choice<'_, S> {
    type Scalar = S;
    type Output = [Named<S>; 18];

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        let (a, b) = (L::from_array(self.0.a), L::from_array(self.0.b));
        let mask = L::from_array(self.0.mask);
        [
            ("array", a.to_array()),
            ("splat", L::splat(self.0.a[3]).to_array()),
            ("gather", L::gather(|lane| self.0.a[LANES - 1 - lane]).to_array()),
            ("lt", a.lt(b).to_array()),
            ("le", a.le(b).to_array()),
            ("gt", a.gt(b).to_array()),
            ("ge", a.ge(b).to_array()),
            ("same_bits", a.same_bits(b).to_array()),
            ("same_bits of itself", a.same_bits(a).to_array()),
            ("bit_and", a.bit_and(b).to_array()),
            ("bit_or", a.bit_or(b).to_array()),
            ("bit_clear", a.bit_clear(b).to_array()),
            ("choose", L::choose(mask, a, b).to_array()),
            ("replace", L::replace(mask, a, b).to_array()),
            ("min_or_second", a.min_or_second(b).to_array()),
            ("max_or_second", a.max_or_second(b).to_array()),
            ("positive", a.positive().to_array()),
            ("not_behind", a.not_behind().to_array()),
        ]
    }
}

/// The same on the scalars of a lane.
fn choice<S: TestScalar>(of: &Operands<S>, lane: usize) -> [(&'static str, S); 18] {
    let (a, b) = (of.a[lane], of.b[lane]);
    let (x, y) = (a.pattern(), b.pattern());
    let mask = of.mask[lane].pattern() != 0;
    let is_nan = a.to_f64().is_nan();
    [
        ("array", a),
        ("splat", of.a[3]),
        ("gather", of.a[LANES - 1 - lane]),
        ("lt", S::truth(a < b)),
        ("le", S::truth(a <= b)),
        ("gt", S::truth(a > b)),
        ("ge", S::truth(a >= b)),
        ("same_bits", S::truth(x == y)),
        ("same_bits of itself", S::truth(true)),
        ("bit_and", S::from_pattern(x & y)),
        ("bit_or", S::from_pattern(x | y)),
        ("bit_clear", S::from_pattern(x & !y)),
        ("choose", if mask { a } else { b }),
        ("replace", if mask { a } else { b }),
        // The second of two zeros, and wherever one is NaN.
        ("min_or_second", if a < b { a } else { b }),
        ("max_or_second", if a > b { a } else { b }),
        // NaN and -0 become +0 here, and are kept there.
        ("positive", if a > S::ZERO { a } else { S::ZERO }),
        ("not_behind", if is_nan || a >= S::ZERO { a } else { S::ZERO }),
    ]
}

#[test]
fn comparisons_and_choices_are_the_scalars() {
    fn check<S: TestScalar>() {
        for isa in isas() {
            for of in operands::<S>() {
                let context = |lane: usize| format!("{isa} {:?} {:?}", of.a[lane], of.b[lane]);
                compare(run(isa, Choice(&of)), |lane| choice(&of, lane), true, &context);
            }
        }
    }
    check::<f32>();
    check::<f64>();
}

/// An index in every lane, a number of the formulas, and where two indices are the same.
struct Indices<S>(u32, u32, std::marker::PhantomData<S>);

impl<S: TestScalar> Kernel for Indices<S> {
    type Scalar = S;
    type Output = ([S; LANES], [S; LANES], u32);

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        let constant = L::constant(f64::from(self.0));
        let same: Mask<L> = L::index(self.0).same_bits(L::index(self.1));
        (L::index(self.0).to_array(), constant.to_array(), same.bits())
    }
}

#[test]
fn an_index_comes_back_and_differs_from_others() {
    fn check<S: TestScalar>() {
        let mut numbers = Numbers::new(2);
        let mut all = vec![0, 1, 2, 511, 512, (1 << 31) - 1, 1 << 31, u32::MAX - 1, u32::MAX];
        all.extend((0..64).map(|_| numbers.next() as u32));
        for isa in isas() {
            for &i in &all {
                for &j in &all {
                    let kernel = Indices::<S>(i, j, std::marker::PhantomData);
                    let (indices, constant, same) = run(isa, kernel);
                    assert!(indices.iter().all(|lane| lane.to_index() == i), "{isa} {i}");
                    let rounded = S::rounded(f64::from(i)).pattern();
                    assert!(constant.iter().all(|lane| lane.pattern() == rounded), "{isa} {i}");
                    assert_eq!(same, if i == j { 0xff } else { 0 }, "{isa} {i} {j}");
                }
            }
            let ones = run(isa, Indices::<S>(u32::MAX, 0, std::marker::PhantomData)).0;
            assert!(ones.iter().all(|lane| lane.pattern() == S::truth(true).pattern()));
        }
    }
    check::<f32>();
    check::<f64>();
}
