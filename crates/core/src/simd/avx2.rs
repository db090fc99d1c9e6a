//! Lanes of 256-bit AVX2 operations. Only reached through `dispatch::run`, which enables them.
#![expect(unsafe_code, reason = "intrinsics")]

use std::arch::x86_64::*;
use std::ops::{Add, Div, Mul, Sub};

use super::lanes::{LANES, Lanes, Mask, binary};

/// Eight lanes in 256-bit registers: one of f32, two of f64.
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
    fn min_or_second(self, other: Self) -> Self {
        Self(op!(_mm256_min_ps(self.0, other.0)))
    }
    #[inline(always)]
    fn max_or_second(self, other: Self) -> Self {
        Self(op!(_mm256_max_ps(self.0, other.0)))
    }
    // This instruction gives the second of two zeros, and the second where one is NaN.
    #[inline(always)]
    fn positive(self) -> Self {
        self.max_or_second(Self::constant(0.0))
    }
    #[inline(always)]
    fn not_behind(self) -> Self {
        Self::constant(0.0).max_or_second(self)
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

/// The order of bytes that packs, in each half, the lowest three of its four numbers.
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
        let (a, b) = (halves!(_mm256_castpd_si256; self.0), halves!(_mm256_castpd_si256; other.0));
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
