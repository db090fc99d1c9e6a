//! Eight vectors beside one.

use super::compare;
use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, Mask, Packed, Vec3, run};

/// Two times eight vectors, a number and a mask for each.
struct Vectors<S> {
    u: Packed<S>,
    v: Packed<S>,
    s: [S; LANES],
    mask: [S; LANES],
}

/// Results of three components each, then of one.
type Answer<S> = ([(&'static str, Packed<S>); 11], [(&'static str, [S; LANES]); 2], [S; 3]);

impl<S: TestScalar> Kernel for &Vectors<S> {
    type Scalar = S;
    type Output = Answer<S>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Answer<S> {
        let (u, v) = (Vec3::<L>::from_arrays(&self.u), Vec3::from_arrays(&self.v));
        let (s, mask) = (L::from_array(self.s), Mask::from_array(self.mask));
        let [x, y, z] = self.u.map(|component| component[2]);
        let vectors = [
            ("+", (u + v).to_arrays()),
            ("-", (u - v).to_arrays()),
            ("*", (u * v).to_arrays()),
            ("* s", (u * s).to_arrays()),
            ("/ s", u.div(s).to_arrays()),
            ("min_or_second", u.min_or_second(v).to_arrays()),
            ("max_or_second", u.max_or_second(v).to_arrays()),
            ("select", Vec3::select(mask, u, v).to_arrays()),
            ("keep", u.keep(mask).to_arrays()),
            ("splat", Vec3::<L>::splat([x, y, z].into()).to_arrays()),
            ("all", Vec3::all(s).to_arrays()),
        ];
        let numbers = [("dot", u.dot(v).to_array()), ("length", u.length().to_array())];
        (vectors, numbers, u.first())
    }
}

/// The same on one component, and one lane.
fn plain<S: TestScalar>(of: &Vectors<S>, axis: usize, lane: usize) -> [(&'static str, S); 11] {
    let (a, b, s) = (of.u[axis][lane], of.v[axis][lane], of.s[lane]);
    let mask = of.mask[lane].pattern() != 0;
    [
        ("+", a + b),
        ("-", a - b),
        ("*", a * b),
        ("* s", a * s),
        ("/ s", a / s),
        ("min_or_second", if a < b { a } else { b }),
        ("max_or_second", if a > b { a } else { b }),
        ("select", if mask { a } else { b }),
        ("keep", if mask { a } else { S::ZERO }),
        ("splat", of.u[axis][2]),
        ("all", s),
    ]
}

fn check<S: TestScalar>() {
    let mut numbers = Numbers::new(6);
    for isa in isas() {
        for _ in 0..500 {
            let of = Vectors {
                u: std::array::from_fn(|_| numbers.eight::<S>()),
                v: std::array::from_fn(|_| numbers.eight()),
                s: numbers.eight(),
                mask: numbers.mask(),
            };
            let (vectors, sums, first) = run(isa, &of);
            let context = |lane: usize| {
                let [u, v] = [of.u, of.v].map(|v| v.map(|x| x[lane]));
                format!("{isa} {u:?} {v:?} {:?}", of.s[lane])
            };
            for axis in 0..3 {
                let component = vectors.map(|(name, v)| (name, v[axis]));
                compare(component, |lane| plain(&of, axis, lane), false, &context);
            }
            // (x + y) + z.
            let dot = |a: &Packed<S>, b: &Packed<S>, lane: usize| {
                a[0][lane] * b[0][lane] + a[1][lane] * b[1][lane] + a[2][lane] * b[2][lane]
            };
            let lengths = |lane: usize| {
                [("dot", dot(&of.u, &of.v, lane)), ("length", dot(&of.u, &of.u, lane).root())]
            };
            compare(sums, lengths, false, &context);
            assert_eq!(first.map(S::pattern), of.u.map(|x| x[0].pattern()), "first, {isa}");
        }
    }
}

#[test]
fn vectors_are_the_scalars_component_by_component() {
    check::<f32>();
    check::<f64>();
}
