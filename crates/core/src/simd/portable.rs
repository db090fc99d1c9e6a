//! Lanes of `wide`, with the instructions that the build targets: on x86-64 SSE2.
#![expect(unsafe_code, reason = "lanes compared as whole numbers")]

use std::ops::{Add, Div, Mul, Not, Sub};

use wide::{f32x8, f64x8, i32x8, i64x8};

use super::lanes::{LANES, Lanes, Mask, binary};

/// Eight lanes by `wide`'s own operations.
#[derive(Clone, Copy)]
pub(crate) struct Portable<V>(V);

macro_rules! portable {
    ($scalar:ident, $floats:ident, $ints:ident) => {
        binary!(Portable<$floats>:
            Add add |a, b| a + b, Sub sub |a, b| a - b, Mul mul |a, b| a * b, Div div |a, b| a / b);

        impl Lanes for Portable<$floats> {
            type Scalar = $scalar;

            #[inline(always)]
            fn splat(x: $scalar) -> Self {
                Self($floats::splat(x))
            }
            #[inline(always)]
            fn from_array(x: [$scalar; LANES]) -> Self {
                Self($floats::new(x))
            }
            #[inline(always)]
            fn to_array(self) -> [$scalar; LANES] {
                self.0.to_array()
            }
            #[inline(always)]
            fn sqrt(self) -> Self {
                Self(self.0.sqrt())
            }
            #[inline(always)]
            fn lt(self, other: Self) -> Mask<Self> {
                Mask(Self(self.0.simd_lt(other.0)))
            }
            #[inline(always)]
            fn le(self, other: Self) -> Mask<Self> {
                Mask(Self(self.0.simd_le(other.0)))
            }
            #[inline(always)]
            fn gt(self, other: Self) -> Mask<Self> {
                Mask(Self(self.0.simd_gt(other.0)))
            }
            #[inline(always)]
            fn ge(self, other: Self) -> Mask<Self> {
                Mask(Self(self.0.simd_ge(other.0)))
            }
            #[inline(always)]
            fn same_bits(self, other: Self) -> Mask<Self> {
                // SAFETY: both types are eight lanes of as many bits, every bit pattern of which is
                // valid.
                let equal = unsafe {
                    let (a, b) = (
                        std::mem::transmute::<$floats, $ints>(self.0),
                        std::mem::transmute::<$floats, $ints>(other.0),
                    );
                    std::mem::transmute::<$ints, $floats>(a.simd_eq(b))
                };
                Mask(Self(equal))
            }
            #[inline(always)]
            fn bit_and(self, other: Self) -> Self {
                Self(self.0 & other.0)
            }
            #[inline(always)]
            fn bit_or(self, other: Self) -> Self {
                Self(self.0 | other.0)
            }
            #[inline(always)]
            fn bit_clear(self, mask: Self) -> Self {
                Self(self.0 & mask.0.not())
            }
            #[inline(always)]
            fn choose(mask: Self, this: Self, other: Self) -> Self {
                Self(mask.0.bitselect(this.0, other.0))
            }
            #[inline(always)]
            fn replace(mask: Self, this: Self, other: Self) -> Self {
                Self::choose(mask, this, other)
            }
            #[inline(always)]
            fn signs(self) -> u32 {
                self.0.to_bitmask()
            }
        }
    };
}

portable!(f32, f32x8, i32x8);
portable!(f64, f64x8, i64x8);
