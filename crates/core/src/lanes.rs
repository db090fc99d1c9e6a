//! Eight f32 side by side, on each instruction set.
//!
//! `wide` chooses its instructions when it is compiled, which for a plain build is SSE2. So
//! the kernels are written once over [`Lanes`] and compiled twice: over `wide`'s own
//! operations, and over 256-bit AVX2 operations behind one entry that enables them. FMA is
//! not enabled: a fused operation has other bits.
//!
//! Rule: everything between that entry and an operation is `#[inline(always)]`. A function
//! left out of line is compiled without AVX2 and passes its lanes through memory; a test
//! reads the compiled kernel and allows none.
//!
//! Every operation is rounded once and is the same in a lane as on a scalar. A comparison
//! with NaN is false.
#![expect(unsafe_code, reason = "intrinsics, and the one call into AVX2 code once detected")]

use std::ops::{Add, BitAnd, BitOr, Div, Mul, Not, Sub};

use wide::{f32x8, i32x8};

use crate::Isa;

/// How many rays a packet holds.
pub(crate) const LANES: usize = 8;

/// Eight f32. Lane i is element i of [`Lanes::to_array`].
pub(crate) trait Lanes:
    Copy + Add<Output = Self> + Sub<Output = Self> + Mul<Output = Self> + Div<Output = Self>
{
    fn splat(x: f32) -> Self;
    fn from_array(x: [f32; LANES]) -> Self;
    fn to_array(self) -> [f32; LANES];
    /// NaN for a negative lane.
    fn sqrt(self) -> Self;
    fn lt(self, other: Self) -> Mask<Self>;
    fn le(self, other: Self) -> Mask<Self>;
    fn gt(self, other: Self) -> Mask<Self>;
    fn ge(self, other: Self) -> Mask<Self>;
    /// Where the bits are the same; for lanes that hold indices.
    fn same_bits(self, other: Self) -> Mask<Self>;
    fn bit_and(self, other: Self) -> Self;
    fn bit_or(self, other: Self) -> Self;
    /// `self` where the bits of `mask` are 0.
    fn bit_clear(self, mask: Self) -> Self;
    /// `self` where `mask` is all ones, `other` where it is 0.
    fn choose(mask: Self, this: Self, other: Self) -> Self;
    /// The sign bit of lane i as bit i.
    fn signs(self) -> u32;

    /// Lanes that hold an index.
    #[inline(always)]
    fn index(i: u32) -> Self {
        Self::splat(f32::from_bits(i))
    }

    /// max(0, x), with +0 for NaN and for -0.
    #[inline(always)]
    fn positive(self) -> Self {
        self.gt(Self::splat(0.0)).keep(self)
    }

    /// max(0, x) with NaN and -0 kept.
    #[inline(always)]
    fn not_behind(self) -> Self {
        self.lt(Self::splat(0.0)).drop(self)
    }
}

/// Eight truth values, each all ones or all zeros.
#[derive(Clone, Copy)]
pub(crate) struct Mask<L>(L);

impl<L: Lanes> Mask<L> {
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self(L::splat(0.0))
    }

    /// True in the first `n` lanes.
    #[inline(always)]
    pub(crate) fn first(n: usize) -> Self {
        let mut lanes = [0.0; LANES];
        for (i, lane) in lanes.iter_mut().enumerate() {
            *lane = f32::from_bits(if i < n { u32::MAX } else { 0 });
        }
        Self(L::from_array(lanes))
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
    pub(crate) fn count(self) -> u64 {
        u64::from(self.bits().count_ones())
    }

    /// `this` where true, `other` elsewhere.
    #[inline(always)]
    pub(crate) fn select(self, this: L, other: L) -> L {
        L::choose(self.0, this, other)
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

/// Work that is written over [`Lanes`].
pub(crate) trait Kernel {
    type Output;
    /// Must be `#[inline(always)]`, with all that it calls.
    fn run<L: Lanes>(self) -> Self::Output;
}

/// Runs a kernel on an instruction set, lowered to what the processor has.
pub(crate) fn run<K: Kernel>(isa: Isa, kernel: K) -> K::Output {
    match isa.min(Isa::detected()) {
        Isa::Portable => run_portable(kernel),
        #[cfg(target_arch = "x86_64")]
        // SAFETY: `detected` found every feature that the function enables.
        Isa::Avx2 => unsafe { run_avx2(kernel) },
        #[cfg(not(target_arch = "x86_64"))]
        Isa::Avx2 => unreachable!("only detected on x86-64"),
    }
}

#[inline(never)]
fn run_portable<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<Portable>()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,bmi2,popcnt,lzcnt")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    kernel.run::<avx2::Avx2>()
}

/// `wide`'s own operations.
#[derive(Clone, Copy)]
struct Portable(f32x8);

/// One line an operation of two operands.
macro_rules! binary {
    ($lanes:ident: $($trait:ident $method:ident $op:expr),* $(,)?) => {$(
        impl $trait for $lanes {
            type Output = Self;
            #[inline(always)]
            fn $method(self, other: Self) -> Self {
                Self($op(self.0, other.0))
            }
        }
    )*};
}

binary!(Portable: Add add Add::add, Sub sub Sub::sub, Mul mul Mul::mul, Div div Div::div);

impl Lanes for Portable {
    #[inline(always)]
    fn splat(x: f32) -> Self {
        Self(f32x8::splat(x))
    }
    #[inline(always)]
    fn from_array(x: [f32; LANES]) -> Self {
        Self(f32x8::new(x))
    }
    #[inline(always)]
    fn to_array(self) -> [f32; LANES] {
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
        // SAFETY: both types are eight lanes of 32 bits, every bit pattern of which is valid.
        let equal = unsafe {
            let (a, b) = (
                std::mem::transmute::<f32x8, i32x8>(self.0),
                std::mem::transmute::<f32x8, i32x8>(other.0),
            );
            std::mem::transmute::<i32x8, f32x8>(a.simd_eq(b))
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
    fn signs(self) -> u32 {
        self.0.to_bitmask()
    }
}

/// The same in 256-bit operations. Only reached through `run_avx2`.
#[cfg(target_arch = "x86_64")]
mod avx2 {
    use std::arch::x86_64::*;
    use std::ops::{Add, Div, Mul, Sub};

    use super::{LANES, Lanes, Mask};

    #[derive(Clone, Copy)]
    pub(super) struct Avx2(__m256);

    macro_rules! op {
        ($intrinsic:expr) => {
            // SAFETY: values of `Avx2` are made and used under `run_avx2` alone.
            unsafe { $intrinsic }
        };
    }

    binary!(Avx2:
        Add add |a, b| op!(_mm256_add_ps(a, b)),
        Sub sub |a, b| op!(_mm256_sub_ps(a, b)),
        Mul mul |a, b| op!(_mm256_mul_ps(a, b)),
        Div div |a, b| op!(_mm256_div_ps(a, b)),
    );

    impl Lanes for Avx2 {
        #[inline(always)]
        fn splat(x: f32) -> Self {
            Self(op!(_mm256_set1_ps(x)))
        }
        #[inline(always)]
        fn from_array(x: [f32; LANES]) -> Self {
            Self(op!(_mm256_loadu_ps(x.as_ptr())))
        }
        #[inline(always)]
        fn to_array(self) -> [f32; LANES] {
            let mut array = [0.0; LANES];
            op!(_mm256_storeu_ps(array.as_mut_ptr(), self.0));
            array
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(op!(_mm256_sqrt_ps(self.0)))
        }
        #[inline(always)]
        fn lt(self, other: Self) -> Mask<Self> {
            Mask(Self(op!(_mm256_cmp_ps::<_CMP_LT_OQ>(self.0, other.0))))
        }
        #[inline(always)]
        fn le(self, other: Self) -> Mask<Self> {
            Mask(Self(op!(_mm256_cmp_ps::<_CMP_LE_OQ>(self.0, other.0))))
        }
        #[inline(always)]
        fn gt(self, other: Self) -> Mask<Self> {
            Mask(Self(op!(_mm256_cmp_ps::<_CMP_GT_OQ>(self.0, other.0))))
        }
        #[inline(always)]
        fn ge(self, other: Self) -> Mask<Self> {
            Mask(Self(op!(_mm256_cmp_ps::<_CMP_GE_OQ>(self.0, other.0))))
        }
        #[inline(always)]
        fn same_bits(self, other: Self) -> Mask<Self> {
            let (a, b) = op!((_mm256_castps_si256(self.0), _mm256_castps_si256(other.0)));
            Mask(Self(op!(_mm256_castsi256_ps(_mm256_cmpeq_epi32(a, b)))))
        }
        #[inline(always)]
        fn bit_and(self, other: Self) -> Self {
            Self(op!(_mm256_and_ps(self.0, other.0)))
        }
        #[inline(always)]
        fn bit_or(self, other: Self) -> Self {
            Self(op!(_mm256_or_ps(self.0, other.0)))
        }
        #[inline(always)]
        fn bit_clear(self, mask: Self) -> Self {
            Self(op!(_mm256_andnot_ps(mask.0, self.0)))
        }
        #[inline(always)]
        fn choose(mask: Self, this: Self, other: Self) -> Self {
            Self(op!(_mm256_blendv_ps(other.0, this.0, mask.0)))
        }
        #[inline(always)]
        fn signs(self) -> u32 {
            op!(_mm256_movemask_ps(self.0)).cast_unsigned()
        }
    }
}
