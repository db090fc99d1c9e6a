//! Masks: every set of lanes, beside the bits of a number.

use super::{Named, compare};
use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, Mask, run};

/// Two sets of lanes, lane i as bit i, and numbers to choose from.
struct Masks<S> {
    this: u32,
    other: u32,
    x: [S; LANES],
    y: [S; LANES],
}

/// A set as a mask's array.
fn lanes_of<S: TestScalar>(set: u32) -> [S; LANES] {
    std::array::from_fn(|lane| S::truth(set >> lane & 1 != 0))
}

/// The set's bits; the numbers chosen; and `bits`, `any` and `all` of the first.
type Answer<S> = ([u32; 8], [Named<S>; 7], (bool, bool));

impl<S: TestScalar> Kernel for &Masks<S> {
    type Scalar = S;
    type Output = Answer<S>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Answer<S> {
        let this = Mask::<L>::from_array(lanes_of(self.this));
        let other = Mask::<L>::from_array(lanes_of(self.other));
        let (x, y) = (L::from_array(self.x), L::from_array(self.y));
        let sets = [
            this.bits(),
            other.bits(),
            (this & other).bits(),
            (this | other).bits(),
            this.without(other).bits(),
            Mask::<L>::none().bits(),
            Mask::<L>::every().bits(),
            x.signs(),
        ];
        let chosen = [
            ("to_array", this.to_array()),
            ("select", this.select(x, y).to_array()),
            ("replace", this.replace(x, y).to_array()),
            ("keep", this.keep(x).to_array()),
            ("drop", this.drop(x).to_array()),
            ("without", this.without(other).to_array()),
            ("every", Mask::<L>::every().to_array()),
        ];
        (sets, chosen, (this.any(), this.all()))
    }
}

/// The same by the bits of a number.
fn plain<S: TestScalar>(of: &Masks<S>) -> ([u32; 8], (bool, bool)) {
    let Masks { this, other, x, .. } = of;
    let sign = |lane: usize| x[lane].pattern() >> (8 * size_of::<S>() - 1);
    let signs = (0..LANES).map(|lane| (sign(lane) as u32) << lane).sum();
    let sets = [*this, *other, this & other, this | other, this & !other, 0, 0xff, signs];
    (sets, (*this != 0, *this == 0xff))
}

fn check<S: TestScalar>() {
    let mut numbers = Numbers::new(3);
    for isa in isas() {
        for this in 0..1 << LANES {
            for other in [0, 0xff, this, !this & 0xff, numbers.below(256) as u32] {
                let of = Masks { this, other, x: numbers.eight::<S>(), y: numbers.eight() };
                let (sets, chosen, some) = run(isa, &of);
                assert_eq!((sets, some), plain(&of), "{isa} {this:#b} {other:#b}");
                let lane_of = |lane: usize| {
                    let (x, y, set) = (of.x[lane], of.y[lane], this >> lane & 1 != 0);
                    [
                        ("to_array", S::truth(set)),
                        ("select", if set { x } else { y }),
                        ("replace", if set { x } else { y }),
                        ("keep", if set { x } else { S::ZERO }),
                        ("drop", if set { S::ZERO } else { x }),
                        ("without", S::truth(set && other >> lane & 1 == 0)),
                        ("every", S::truth(true)),
                    ]
                };
                compare(chosen, lane_of, true, &|_| format!("{isa} {this:#b} {other:#b}"));
            }
        }
    }
}

#[test]
fn masks_are_sets_of_lanes() {
    check::<f32>();
    check::<f64>();
}

/// The first `n` lanes, and NaN there.
struct First<S>(u32, [S; LANES]);

impl<S: TestScalar> Kernel for First<S> {
    type Scalar = S;
    type Output = (u32, [S; LANES]);

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        let first = Mask::<L>::first(self.0);
        (first.bits(), first.or_nan(L::from_array(self.1)).to_array())
    }
}

#[test]
fn the_first_lanes_are_so_many() {
    fn check<S: TestScalar>() {
        let mut numbers = Numbers::new(4);
        for isa in isas() {
            for n in (0..=8).chain([9, 255, u32::MAX]) {
                let x = numbers.eight::<S>();
                let (bits, with_nan) = run(isa, First(n, x));
                let n = n.clamp(0, 8);
                assert_eq!(bits, (1 << n) - 1, "{isa}, {n} lanes");
                for lane in 0..LANES {
                    let (found, x) = (with_nan[lane], x[lane]);
                    let is_nan = found.to_f64().is_nan();
                    let kept = found.pattern() == x.pattern();
                    assert!(if lane < n as usize { is_nan } else { kept }, "{isa}, lane {lane}");
                }
            }
        }
    }
    check::<f32>();
    check::<f64>();
}
