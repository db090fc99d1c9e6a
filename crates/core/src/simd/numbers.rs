//! Numbers for tests: a small sequence that is the same on every machine, with the edges of a
//! scalar always among them.

use std::ops::{Add, Div, Sub};

use super::isa::Isa;
use super::lanes::{LANES, Lane};

/// The instruction sets that this processor has.
pub(crate) fn isas() -> impl Iterator<Item = Isa> {
    Isa::ALL.into_iter().filter(|&isa| isa <= Isa::detected())
}

/// A scalar's own operations, beside which those of lanes are held.
pub(crate) trait TestScalar:
    Lane + Add<Output = Self> + Sub<Output = Self> + Div<Output = Self>
{
    /// Zeros, neighbours of 1, subnormals, infinities, NaN, and the edges of u32 as an index.
    fn edges() -> Vec<Self>;
    /// The number of these bits; in f32 the lower half counts.
    fn from_pattern(bits: u64) -> Self;
    fn pattern(self) -> u64;
    fn root(self) -> Self;
    fn next_above(self) -> Self;
    fn next_below(self) -> Self;

    /// All ones or all zeros: a lane of a mask.
    fn truth(truth: bool) -> Self {
        Self::from_pattern(if truth { u64::MAX } else { 0 })
    }

    /// Whether two results are one: the same bits, or both NaN, whose bits Rust does not promise.
    fn is(self, other: Self) -> bool {
        let both_nan = self.to_f64().is_nan() && other.to_f64().is_nan();
        both_nan || self.pattern() == other.pattern()
    }
}

macro_rules! test_scalar {
    ($scalar:ident, $bits:ident) => {
        impl TestScalar for $scalar {
            fn edges() -> Vec<Self> {
                let least_normal = $scalar::MIN_POSITIVE;
                let positive = [
                    0.0,
                    1.0,
                    $scalar::next_up(1.0),
                    $scalar::next_down(1.0),
                    0.5,
                    255.0,
                    $scalar::next_down(256.0),
                    4_294_967_295.0,
                    4_294_967_296.0,
                    1.0 / $scalar::EPSILON,
                    1.5 / $scalar::EPSILON,
                    least_normal,
                    least_normal.next_up(),
                    least_normal.next_down(),
                    $scalar::from_bits(1),
                    $scalar::MAX,
                    $scalar::INFINITY,
                    $scalar::NAN,
                ];
                let indices = [1, 511, 512, i32::MAX as u32, 1 << 31, u32::MAX - 1, u32::MAX];
                let negative = positive.map(|x| -x);
                let indices = indices.map(Lane::from_index);
                positive.into_iter().chain(negative).chain(indices).collect()
            }
            #[expect(clippy::allow_attributes, reason = "the cast is one in f32 alone")]
            #[allow(clippy::cast_possible_truncation, reason = "the lower half counts")]
            fn from_pattern(bits: u64) -> Self {
                Self::from_bits(bits as $bits)
            }
            fn pattern(self) -> u64 {
                self.to_bits().into()
            }
            fn root(self) -> Self {
                self.sqrt()
            }
            fn next_above(self) -> Self {
                self.next_up()
            }
            fn next_below(self) -> Self {
                self.next_down()
            }
        }
    };
}

test_scalar!(f32, u32);
test_scalar!(f64, u64);

/// A sequence of numbers: SplitMix64 (Steele, Lea, Flood 2014).
pub(crate) struct Numbers(u64);

impl Numbers {
    pub(crate) fn new(seed: u64) -> Self {
        Self(seed)
    }

    pub(crate) fn next(&mut self) -> u64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let z = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        z ^ (z >> 31)
    }

    /// A whole number below `end`.
    pub(crate) fn below(&mut self, end: usize) -> usize {
        (self.next() % end as u64) as usize
    }

    /// Whether one of `n` equal chances came.
    pub(crate) fn one_in(&mut self, n: usize) -> bool {
        self.below(n) == 0
    }

    /// A number from `start` to `end`.
    pub(crate) fn between(&mut self, start: f64, end: f64) -> f64 {
        start + (end - start) * ((self.next() >> 11) as f64 / (1u64 << 53) as f64)
    }

    /// A number whose logarithm is evenly spread.
    pub(crate) fn magnitude(&mut self, start: f64, end: f64) -> f64 {
        self.between(start.ln(), end.ln()).exp()
    }

    /// Any number: an edge, any bits, or one of usual size.
    pub(crate) fn any<S: TestScalar>(&mut self) -> S {
        match self.below(4) {
            0 => {
                let edges = S::edges();
                edges[self.below(edges.len())]
            }
            1 => S::from_pattern(self.next()),
            2 => S::rounded(self.magnitude(1e-6, 1e6)),
            _ => S::rounded(self.between(-4.0, 4.0)),
        }
    }

    /// Eight of any numbers.
    pub(crate) fn eight<S: TestScalar>(&mut self) -> [S; LANES] {
        std::array::from_fn(|_| self.any())
    }

    /// Eight lanes of a mask.
    pub(crate) fn mask<S: TestScalar>(&mut self) -> [S; LANES] {
        std::array::from_fn(|_| S::truth(self.one_in(2)))
    }
}
