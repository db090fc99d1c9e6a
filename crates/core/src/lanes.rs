//! Eight f32 or f64 side by side, on each instruction set.
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

use catoptric_scene::Scalar;
use wide::{f32x8, f64x8, i32x8, i64x8};

use crate::Isa;
use crate::power::Bits;

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
    /// Where the bits are the same; for lanes that hold indices.
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
    fn least(self, other: Self) -> Self {
        self.lt(other).select(self, other)
    }

    /// `self` where it is greater, `other` elsewhere, so too where one of them is NaN.
    #[inline(always)]
    fn most(self, other: Self) -> Self {
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
pub(crate) struct Mask<L>(L);

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

    /// Of lanes that are all ones or all zeros.
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

    /// As [`Mask::select`]; see [`Lanes::replace`].
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

/// Work that is written over [`Lanes`].
pub(crate) trait Kernel {
    type Scalar: Lane;
    type Output;
    /// Must be `#[inline(always)]`, with all that it calls.
    fn run<L: Lanes<Scalar = Self::Scalar>>(self) -> Self::Output;
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
    kernel.run::<<K::Scalar as Lane>::Portable>()
}

#[cfg(target_arch = "x86_64")]
#[inline(never)]
#[target_feature(enable = "avx2,bmi1,bmi2,popcnt,lzcnt")]
fn run_avx2<K: Kernel>(kernel: K) -> K::Output {
    // Makes the compiler align the stack. It keeps lanes there that find no register, and left
    // alone would put some across two cache lines: a fifth of the time, by luck.
    #[repr(align(64))]
    struct Aligned([u8; 64]);
    let mut aligned = Aligned([0; 64]);
    std::hint::black_box(&mut aligned.0);
    kernel.run::<<K::Scalar as Lane>::Avx2>()
}

impl Lane for f32 {
    type Portable = Portable<f32x8>;
    #[cfg(target_arch = "x86_64")]
    type Avx2 = avx2::Avx2<std::arch::x86_64::__m256>;

    #[inline(always)]
    fn from_index(i: u32) -> Self {
        Self::from_bits(i)
    }
    #[inline(always)]
    fn to_index(self) -> u32 {
        self.to_bits()
    }
}

impl Lane for f64 {
    type Portable = Portable<f64x8>;
    #[cfg(target_arch = "x86_64")]
    type Avx2 = avx2::Avx2<[std::arch::x86_64::__m256d; 2]>;

    #[inline(always)]
    fn from_index(i: u32) -> Self {
        Self::from_bits(i64::from(i.cast_signed()).cast_unsigned())
    }
    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "the upper half repeats the sign")]
    fn to_index(self) -> u32 {
        self.to_bits() as u32
    }
}

/// `wide`'s own operations.
#[derive(Clone, Copy)]
pub(crate) struct Portable<V>(V);

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
                // SAFETY: both types are eight lanes of as many bits, every bit pattern of which is valid.
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

/// The same in 256-bit operations. Only reached through `run_avx2`.
#[cfg(target_arch = "x86_64")]
mod avx2 {
    use std::arch::x86_64::*;
    use std::ops::{Add, Div, Mul, Sub};

    use super::{LANES, Lanes, Mask};

    #[derive(Clone, Copy)]
    pub(crate) struct Avx2<V>(V);

    macro_rules! op {
        ($intrinsic:expr) => {
            // SAFETY: values of `Avx2` are made and used under `run_avx2` alone.
            unsafe { $intrinsic }
        };
    }

    binary!(Avx2<__m256>:
        Add add |a, b| op!(_mm256_add_ps(a, b)),
        Sub sub |a, b| op!(_mm256_sub_ps(a, b)),
        Mul mul |a, b| op!(_mm256_mul_ps(a, b)),
        Div div |a, b| op!(_mm256_div_ps(a, b)),
    );

    impl Lanes for Avx2<__m256> {
        type Scalar = f32;

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
        fn replace(mask: Self, this: Self, other: Self) -> Self {
            let differ = op!(_mm256_xor_ps(this.0, other.0));
            Self(op!(_mm256_xor_ps(other.0, _mm256_and_ps(differ, mask.0))))
        }
        #[inline(always)]
        fn signs(self) -> u32 {
            op!(_mm256_movemask_ps(self.0)).cast_unsigned()
        }
        #[inline(always)]
        fn least(self, other: Self) -> Self {
            Self(op!(_mm256_min_ps(self.0, other.0)))
        }
        #[inline(always)]
        fn most(self, other: Self) -> Self {
            Self(op!(_mm256_max_ps(self.0, other.0)))
        }
        // Of two zeros, and where one is NaN, this instruction gives the second.
        #[inline(always)]
        fn positive(self) -> Self {
            self.most(Self::constant(0.0))
        }
        #[inline(always)]
        fn not_behind(self) -> Self {
            Self::constant(0.0).most(self)
        }
        #[inline(always)]
        fn interleave(x: Self, y: Self, z: Self, to: &mut [[f32; 3]; LANES]) {
            let to = to.as_flattened_mut();
            let (to, rest) = to.split_at_mut(LANES);
            let (middle, end) = rest.split_at_mut(LANES);
            op!({
                // In each half: x0 x2 y0 y2, y1 y3 z1 z3, z0 z2 x1 x3.
                let xy = _mm256_shuffle_ps::<0x88>(x.0, y.0);
                let yz = _mm256_shuffle_ps::<0xdd>(y.0, z.0);
                let zx = _mm256_shuffle_ps::<0xd8>(z.0, x.0);
                // x0 y0 z0 x1, y1 z1 x2 y2, z2 x3 y3 z3.
                let a = _mm256_shuffle_ps::<0x88>(xy, zx);
                let b = _mm256_shuffle_ps::<0xd8>(yz, xy);
                let c = _mm256_shuffle_ps::<0xdd>(zx, yz);
                _mm256_storeu_ps(to.as_mut_ptr(), _mm256_permute2f128_ps::<0x20>(a, b));
                _mm256_storeu_ps(middle.as_mut_ptr(), _mm256_blend_ps::<0xf0>(c, a));
                _mm256_storeu_ps(end.as_mut_ptr(), _mm256_permute2f128_ps::<0x31>(b, c));
            });
        }
        #[inline(always)]
        fn bytes(x: Self, y: Self, z: Self, to: &mut [[u8; 3]; LANES]) {
            let (to, rest) = to.as_flattened_mut().split_at_mut(16);
            op!({
                let [x, y, z] = [x, y, z].map(|lanes| _mm256_cvttps_epi32(lanes.0));
                let yz = _mm256_or_si256(_mm256_slli_epi32::<8>(y), _mm256_slli_epi32::<16>(z));
                let order = _mm256_loadu_si256(THREE_OF_FOUR.as_ptr().cast());
                let packed = _mm256_shuffle_epi8(_mm256_or_si256(x, yz), order);
                let packed =
                    _mm256_permutevar8x32_epi32(packed, _mm256_setr_epi32(0, 1, 2, 4, 5, 6, 3, 7));
                _mm_storeu_si128(to.as_mut_ptr().cast(), _mm256_castsi256_si128(packed));
                let end = _mm256_extracti128_si256::<1>(packed);
                _mm_storel_epi64(rest.as_mut_ptr().cast(), end);
            });
        }
    }

    /// In each half: the lowest three bytes of its four numbers, packed.
    const THREE_OF_FOUR: [i8; 32] = [
        0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, -1, -1, -1, -1, //
        0, 1, 2, 4, 5, 6, 8, 9, 10, 12, 13, 14, -1, -1, -1, -1,
    ];

    /// Lanes 0 to 3, and 4 to 7.
    type Halves = [__m256d; 2];

    /// An intrinsic on both halves.
    macro_rules! halves {
        ($intrinsic:expr; $($operand:expr),*) => {
            op!([$intrinsic($($operand[0]),*), $intrinsic($($operand[1]),*)])
        };
    }

    binary!(Avx2<Halves>:
        Add add |a, b| halves!(_mm256_add_pd; a, b),
        Sub sub |a, b| halves!(_mm256_sub_pd; a, b),
        Mul mul |a, b| halves!(_mm256_mul_pd; a, b),
        Div div |a, b| halves!(_mm256_div_pd; a, b),
    );

    impl Lanes for Avx2<Halves> {
        type Scalar = f64;

        #[inline(always)]
        fn splat(x: f64) -> Self {
            Self(op!([_mm256_set1_pd(x); 2]))
        }
        #[inline(always)]
        fn from_array(x: [f64; LANES]) -> Self {
            Self(op!([_mm256_loadu_pd(x.as_ptr()), _mm256_loadu_pd(x[4..].as_ptr())]))
        }
        #[inline(always)]
        fn to_array(self) -> [f64; LANES] {
            let mut array = [0.0; LANES];
            op!(_mm256_storeu_pd(array.as_mut_ptr(), self.0[0]));
            op!(_mm256_storeu_pd(array[4..].as_mut_ptr(), self.0[1]));
            array
        }
        #[inline(always)]
        fn sqrt(self) -> Self {
            Self(halves!(_mm256_sqrt_pd; self.0))
        }
        #[inline(always)]
        fn lt(self, other: Self) -> Mask<Self> {
            Mask(Self(halves!(_mm256_cmp_pd::<_CMP_LT_OQ>; self.0, other.0)))
        }
        #[inline(always)]
        fn le(self, other: Self) -> Mask<Self> {
            Mask(Self(halves!(_mm256_cmp_pd::<_CMP_LE_OQ>; self.0, other.0)))
        }
        #[inline(always)]
        fn gt(self, other: Self) -> Mask<Self> {
            Mask(Self(halves!(_mm256_cmp_pd::<_CMP_GT_OQ>; self.0, other.0)))
        }
        #[inline(always)]
        fn ge(self, other: Self) -> Mask<Self> {
            Mask(Self(halves!(_mm256_cmp_pd::<_CMP_GE_OQ>; self.0, other.0)))
        }
        #[inline(always)]
        fn same_bits(self, other: Self) -> Mask<Self> {
            let (a, b) =
                (halves!(_mm256_castpd_si256; self.0), halves!(_mm256_castpd_si256; other.0));
            let equal = halves!(_mm256_cmpeq_epi64; a, b);
            Mask(Self(halves!(_mm256_castsi256_pd; equal)))
        }
        #[inline(always)]
        fn bit_and(self, other: Self) -> Self {
            Self(halves!(_mm256_and_pd; self.0, other.0))
        }
        #[inline(always)]
        fn bit_or(self, other: Self) -> Self {
            Self(halves!(_mm256_or_pd; self.0, other.0))
        }
        #[inline(always)]
        fn bit_clear(self, mask: Self) -> Self {
            Self(halves!(_mm256_andnot_pd; mask.0, self.0))
        }
        #[inline(always)]
        fn choose(mask: Self, this: Self, other: Self) -> Self {
            Self(halves!(_mm256_blendv_pd; other.0, this.0, mask.0))
        }
        #[inline(always)]
        fn replace(mask: Self, this: Self, other: Self) -> Self {
            let differ = halves!(_mm256_xor_pd; this.0, other.0);
            let masked = halves!(_mm256_and_pd; differ, mask.0);
            Self(halves!(_mm256_xor_pd; other.0, masked))
        }
        #[inline(always)]
        fn signs(self) -> u32 {
            let [low, high] = halves!(_mm256_movemask_pd; self.0);
            (low | high << 4).cast_unsigned()
        }
    }
}
