//! The scalars that a picture is computed in.

use std::fmt::Debug;
use std::ops::{Add, Div, Mul, Neg, Sub};

use crate::DoubleDouble;

/// The scalar of a picture: f32, or f64 for studies of accuracy. There is no other one.
///
/// Each constant of a scene is formed in [`Scalar::Wider`] and rounded once to the scalar.
pub trait Scalar:
    sealed::Sealed
    + Copy
    + Debug
    + Default
    + PartialOrd
    + Neg<Output = Self>
    + Mul<Output = Self>
    + Send
    + Sync
    + 'static
{
    /// Vector of three scalars: glam's `Vec3` or `DVec3`.
    type Vec3: Copy
        + Debug
        + PartialEq
        + Neg<Output = Self::Vec3>
        + From<[Self; 3]>
        + Into<[Self; 3]>
        + Send
        + Sync;

    /// Arithmetic that constants are formed in: f64 for f32, double-double for f64.
    type Wider: Wider;

    /// The number 0.
    const ZERO: Self;

    /// The least positive normal number.
    const MIN_POSITIVE: Self;

    /// Binary exponent below which a highlight is taken as 0: beside 1 it is far less than an ulp.
    const FAINTEST: f64;

    /// Coefficients c_j = 2/((2j + 1) ln 2) of log2 m = s·sum of c_j s^(2j), s = (m - 1)/(m + 1).
    const LOG2_SERIES: &'static [Self];

    /// Coefficients c_j = (ln 2)^j / j! of 2^f = sum of c_j f^j.
    const EXP2_SERIES: &'static [Self];

    /// The nearest scalar.
    fn rounded(x: f64) -> Self;

    /// The scalar nearest to a double-double, rounded once.
    fn nearest(x: DoubleDouble) -> Self;

    /// The same number in f64, exact.
    fn to_f64(self) -> f64;
}

/// Arithmetic that constants are formed in, before they are rounded to a scalar.
pub trait Wider:
    sealed::Sealed
    + Copy
    + PartialOrd
    + From<f64>
    + Into<DoubleDouble>
    + Neg<Output = Self>
    + Add<Output = Self>
    + Sub<Output = Self>
    + Mul<Output = Self>
    + Div<Output = Self>
{
    /// The square root.
    #[must_use]
    fn sqrt(self) -> Self;

    /// The difference a - b.
    #[must_use]
    fn difference(a: f64, b: f64) -> Self {
        Self::from(a) - Self::from(b)
    }
}

mod sealed {
    pub trait Sealed {}
    impl Sealed for f32 {}
    impl Sealed for f64 {}
    impl Sealed for crate::DoubleDouble {}
}

impl Scalar for f32 {
    type Vec3 = glam::Vec3;
    type Wider = f64;
    const ZERO: Self = 0.0;
    const MIN_POSITIVE: Self = f32::MIN_POSITIVE;
    const FAINTEST: f64 = -50.0;
    const LOG2_SERIES: &'static [Self] =
        &[2.885_39, 0.961_796_7, 0.577_078, 0.412_198_58, 0.320_598_9];
    const EXP2_SERIES: &'static [Self] = &[
        1.0,
        std::f32::consts::LN_2,
        0.240_226_5,
        0.055_504_11,
        0.009_618_129,
        0.001_333_355_8,
        0.000_154_035_31,
        0.000_015_252_734,
    ];

    #[inline(always)]
    #[expect(clippy::cast_possible_truncation, reason = "this is the rounding")]
    fn rounded(x: f64) -> Self {
        x as Self
    }

    fn nearest(x: DoubleDouble) -> Self {
        x.to_f32()
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self.into()
    }
}

impl Scalar for f64 {
    type Vec3 = glam::DVec3;
    type Wider = DoubleDouble;
    const ZERO: Self = 0.0;
    const MIN_POSITIVE: Self = f64::MIN_POSITIVE;
    const FAINTEST: f64 = -60.0;
    const LOG2_SERIES: &'static [Self] = &[
        2.885_390_081_777_926_8,
        0.961_796_693_925_975_6,
        0.577_078_016_355_585_3,
        0.412_198_583_111_132_4,
        0.320_598_897_975_325_2,
        0.262_308_189_252_538_8,
        0.221_953_083_213_686_67,
        0.192_359_338_785_195_12,
        0.169_728_828_339_878_04,
        0.151_862_635_883_048_77,
        0.137_399_527_703_710_8,
    ];
    const EXP2_SERIES: &'static [Self] = &[
        1.0,
        std::f64::consts::LN_2,
        0.240_226_506_959_100_72,
        0.055_504_108_664_821_58,
        0.009_618_129_107_628_477,
        0.001_333_355_814_642_844_3,
        0.000_154_035_303_933_816_1,
        0.000_015_252_733_804_059_841,
        0.000_001_321_548_679_014_431,
        0.000_000_101_780_860_092_397,
        0.000_000_007_054_911_620_801_123,
        0.000_000_000_444_553_827_187_081_16,
        0.000_000_000_025_678_435_993_488_206,
        0.000_000_000_001_369_148_885_390_412_8,
    ];

    #[inline(always)]
    fn rounded(x: f64) -> Self {
        x
    }

    fn nearest(x: DoubleDouble) -> Self {
        x.to_f64()
    }

    #[inline(always)]
    fn to_f64(self) -> f64 {
        self
    }
}

impl Wider for f64 {
    fn sqrt(self) -> Self {
        f64::sqrt(self)
    }
}

impl Wider for DoubleDouble {
    fn sqrt(self) -> Self {
        DoubleDouble::sqrt(self)
    }
}
