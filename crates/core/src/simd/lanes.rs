//! Eight f32 or f64 side by side: what every instruction set offers, and masks.
//!
//! Every operation is rounded once and is the same in a lane as on a scalar. A comparison with NaN
//! is false.

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Sub};

use catoptric_scene::Scalar;

use super::bits::Bits;

/// How many rays a packet holds.
pub(crate) const LANES: usize = 8;

/// A scalar that lanes hold, and on which lanes it runs.
pub(crate) trait Lane: Scalar + Bits {
    type Portable: Lanes<Scalar = Self>;
    #[cfg(target_arch = "x86_64")]
    type Avx2: Lanes<Scalar = Self>;

    /// An index as bits. In f64 the upper half repeats the sign, so that `u32::MAX` is all ones.
    fn from_index(i: u32) -> Self;
    fn to_index(self) -> u32;
}

/// Eight scalars. Lane i is element i of [`Lanes::to_array`].
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    type Scalar: Lane;

    fn splat(x: Self::Scalar) -> Self;
    fn from_array(x: [Self::Scalar; LANES]) -> Self;
    fn to_array(self) -> [Self::Scalar; LANES];
    /// NaN for a negative lane.
    fn sqrt(self) -> Self;
    fn lt(self, other: Self) -> Mask<Self>;
    fn le(self, other: Self) -> Mask<Self>;
    fn gt(self, other: Self) -> Mask<Self>;
    fn ge(self, other: Self) -> Mask<Self>;
    /// True where the bits are the same; for lanes that hold indices.
    fn same_bits(self, other: Self) -> Mask<Self>;
    fn bit_and(self, other: Self) -> Self;
    fn bit_or(self, other: Self) -> Self;
    /// `self` where the bits of `mask` are 0.
    fn bit_clear(self, mask: Self) -> Self;
    /// `self` where `mask` is all ones, `other` where it is 0.
    fn choose(mask: Self, this: Self, other: Self) -> Self;
    /// [`Lanes::choose`], for what was just read from memory and goes back there. The compiler
    /// would make one store under a mask of it, which takes AMD's processors 40 steps.
    fn replace(mask: Self, this: Self, other: Self) -> Self;
    /// The sign bit of lane i as bit i.
    fn signs(self) -> u32;

    /// Lane i is `lane(i)`. Not put together in memory, where a processor would wait for it.
    #[inline(always)]
    fn gather(lane: impl Fn(usize) -> Self::Scalar) -> Self {
        Self::from_array([lane(0), lane(1), lane(2), lane(3), lane(4), lane(5), lane(6), lane(7)])
    }

    /// A number of the formulas.
    #[inline(always)]
    fn constant(x: f64) -> Self {
        Self::splat(Scalar::rounded(x))
    }

    /// `self` where it is less, `other` elsewhere, so too where one of them is NaN.
    #[inline(always)]
    fn min_or_second(self, other: Self) -> Self {
        self.lt(other).select(self, other)
    }

    /// `self` where it is greater, `other` elsewhere, so too where one of them is NaN.
    #[inline(always)]
    fn max_or_second(self, other: Self) -> Self {
        self.gt(other).select(self, other)
    }

    /// Lane i of the three as element i.
    #[inline(always)]
    fn interleave(x: Self, y: Self, z: Self, to: &mut [[Self::Scalar; 3]; LANES]) {
        let (x, y, z) = (x.to_array(), y.to_array(), z.to_array());
        for i in 0..LANES {
            to[i] = [x[i], y[i], z[i]];
        }
    }

    /// The whole parts of lane i of the three, which are 0 to below 256, as element i.
    #[inline(always)]
    fn bytes(x: Self, y: Self, z: Self, to: &mut [[u8; 3]; LANES]) {
        let shift = Self::splat(Self::Scalar::ROUNDING_SHIFT);
        for (channel, x) in [x, y, z].into_iter().enumerate() {
            // Rounded to a whole number, which stands in the lowest bits; one less where that
            // went up.
            let rounded = x + shift;
            let up = (rounded - shift).gt(x);
            let whole = (rounded - up.keep(Self::constant(1.0))).to_array();
            for (to, whole) in to.iter_mut().zip(whole) {
                to[channel] = whole.to_index().to_le_bytes()[0];
            }
        }
    }

    /// Lanes that hold an index.
    #[inline(always)]
    fn index(i: u32) -> Self {
        Self::splat(Lane::from_index(i))
    }

    /// max(0, x), with +0 for NaN and for -0.
    #[inline(always)]
    fn positive(self) -> Self {
        self.gt(Self::constant(0.0)).keep(self)
    }

    /// max(0, x) with NaN and -0 kept.
    #[inline(always)]
    fn not_behind(self) -> Self {
        self.lt(Self::constant(0.0)).drop(self)
    }
}

/// Eight truth values, each all ones or all zeros.
#[derive(Clone, Copy)]
pub(crate) struct Mask<L>(pub(super) L);

impl<L: Lanes> Mask<L> {
    /// [`Mask::bits`] of all lanes.
    pub(crate) const ALL: u32 = (1 << LANES) - 1;

    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self(L::constant(0.0))
    }

    #[inline(always)]
    pub(crate) fn every() -> Self {
        Self(L::index(u32::MAX))
    }

    /// Makes a mask of lanes that are all ones or all zeros.
    #[inline(always)]
    pub(crate) fn from_array(lanes: [L::Scalar; LANES]) -> Self {
        Self(L::from_array(lanes))
    }

    #[inline(always)]
    pub(crate) fn to_array(self) -> [L::Scalar; LANES] {
        self.0.to_array()
    }

    /// True in the first `n` lanes.
    #[inline(always)]
    pub(crate) fn first(n: u32) -> Self {
        let mut numbers = [L::Scalar::ZERO; LANES];
        for (i, number) in numbers.iter_mut().enumerate() {
            *number = Scalar::rounded(i as f64);
        }
        L::from_array(numbers).lt(L::constant(n.into()))
    }

    /// Lane i as bit i.
    #[inline(always)]
    pub(crate) fn bits(self) -> u32 {
        self.0.signs()
    }

    #[inline(always)]
    pub(crate) fn any(self) -> bool {
        self.bits() != 0
    }

    #[inline(always)]
    pub(crate) fn all(self) -> bool {
        self.bits() == Self::ALL
    }

    /// `this` where true, `other` elsewhere.
    #[inline(always)]
    pub(crate) fn select(self, this: L, other: L) -> L {
        L::choose(self.0, this, other)
    }

    /// Selects as [`Mask::select`]; see [`Lanes::replace`].
    #[inline(always)]
    pub(crate) fn replace(self, this: L, other: L) -> L {
        L::replace(self.0, this, other)
    }

    /// `x` where true, +0 elsewhere.
    #[inline(always)]
    pub(crate) fn keep(self, x: L) -> L {
        x.bit_and(self.0)
    }

    /// `x` where false, +0 elsewhere.
    #[inline(always)]
    pub(crate) fn drop(self, x: L) -> L {
        x.bit_clear(self.0)
    }

    /// NaN where true, `x` elsewhere.
    #[inline(always)]
    pub(crate) fn or_nan(self, x: L) -> L {
        x.bit_or(self.0)
    }

    /// True here and not there.
    #[inline(always)]
    pub(crate) fn without(self, other: Self) -> Self {
        Self(self.0.bit_clear(other.0))
    }
}

impl<L: Lanes> BitAnd for Mask<L> {
    type Output = Self;
    #[inline(always)]
    fn bitand(self, other: Self) -> Self {
        Self(self.0.bit_and(other.0))
    }
}

impl<L: Lanes> BitOr for Mask<L> {
    type Output = Self;
    #[inline(always)]
    fn bitor(self, other: Self) -> Self {
        Self(self.0.bit_or(other.0))
    }
}

/// One line an operation of two operands.
macro_rules! binary {
    ($lanes:ty: $($trait:ident $method:ident |$a:ident, $b:ident| $op:expr),* $(,)?) => {$(
        impl $trait for $lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                let ($a, $b) = (self.0, other.0);
                Self($op)
            }
        }
    )*};
}

pub(super) use binary;
