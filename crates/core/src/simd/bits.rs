//! The bits of a scalar, which the series of logarithm and power read and write.

use catoptric_scene::Scalar;

/// What the series do to the bits of a number.
pub(crate) trait Bits: Scalar {
    /// 1.5·2^23, in f64 1.5·2^52: added to a number it rounds it to a whole one, which then
    /// stands in the low bits.
    const ROUNDING_SHIFT: Self;

    /// e and m of x = 2^e m, m in [sqrt(1/2), sqrt 2).
    fn exponent_and_mantissa(self) -> (Self, Self);

    /// 2^n of n + [`Bits::ROUNDING_SHIFT`].
    fn two_to_shifted(self) -> Self;
}

macro_rules! bits {
    ($scalar:ident) => {
        impl Bits for $scalar {
            const ROUNDING_SHIFT: Self = 1.5 / $scalar::EPSILON;

            #[inline(always)]
            fn exponent_and_mantissa(self) -> (Self, Self) {
                const FRACTION_BITS: u32 = $scalar::MANTISSA_DIGITS - 1;
                let start = std::$scalar::consts::FRAC_1_SQRT_2.to_bits();
                let bits = self.to_bits();
                let exponent = bits.wrapping_sub(start).cast_signed() >> FRACTION_BITS;
                let m = bits.wrapping_sub((exponent << FRACTION_BITS).cast_unsigned());
                (exponent as $scalar, $scalar::from_bits(m))
            }

            #[inline(always)]
            fn two_to_shifted(self) -> Self {
                const FRACTION_BITS: u32 = $scalar::MANTISSA_DIGITS - 1;
                let one = (1.0 as $scalar).to_bits();
                $scalar::from_bits((self.to_bits() << FRACTION_BITS).wrapping_add(one))
            }
        }
    };
}

bits!(f32);
bits!(f64);
