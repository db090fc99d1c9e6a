//! Phong's constants.

use super::constants::{colour, rounded3};
use crate::{Material, Scalar};

/// A material's constants, each product formed in f64 and rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong<S: Scalar = f32> {
    /// ambient · colour; 0 for -0.
    pub ambient: S::Vec3,
    /// kd · colour.
    pub diffuse: S::Vec3,
    /// ks.
    pub specular: S,
    /// The highlight's exponent.
    pub power: Power<S>,
    /// The mirror factor k, in [0, 1].
    pub mirror: S,
}

/// An exponent p, for bases in [0, 1].
///
/// x^p is taken as 0 for x <= `cut` = 2^(-50/p), in f64 2^(-60/p): the result is below 1e-15 or
/// 1e-18, and no intermediate product can become subnormal, which would cost a hundred cycles
/// each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Power<S: Scalar = f32> {
    /// Whole p up to 1024: repeated squaring, from the lowest bit of p.
    Whole {
        /// The exponent p.
        exponent: u32,
        /// Largest x whose power is 0; -1 for p = 0, since 0^0 is 1.
        cut: S,
    },
    /// Any other p: 2^(p log2 x).
    Real {
        /// The exponent p.
        exponent: S,
        /// Largest x whose power is 0; never below the least normal number.
        cut: S,
    },
}

impl<S: Scalar> Power<S> {
    /// Largest p that is squared: above it, squaring's error (about p/2 ulp) passes the
    /// exponential's.
    const LARGEST_WHOLE: f64 = 1024.0;

    fn new(p: f64) -> Self {
        if p == 0.0 {
            return Self::Whole { exponent: 0, cut: S::rounded(-1.0) };
        }
        let cut = S::rounded((S::FAINTEST / p).exp2());
        let cut = if cut < S::MIN_POSITIVE { S::MIN_POSITIVE } else { cut };
        if p.fract() == 0.0 && p <= Self::LARGEST_WHOLE {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole")]
            Self::Whole { exponent: p as u32, cut }
        } else {
            Self::Real { exponent: S::rounded(p), cut }
        }
    }

    /// Kind, p and cut as bits: equal exactly where the powers are the same.
    fn bits(self) -> [u64; 3] {
        match self {
            Self::Whole { exponent, cut } => [0, exponent.into(), bits(cut)],
            Self::Real { exponent, cut } => [1, bits(exponent), bits(cut)],
        }
    }
}

impl<S: Scalar> Phong<S> {
    /// Whether the material reflects no light's light, neither diffusely nor as a highlight.
    #[inline(always)]
    #[must_use]
    pub fn is_unlit(&self) -> bool {
        let [r, g, b] = self.diffuse.into();
        self.specular == S::ZERO && r == S::ZERO && g == S::ZERO && b == S::ZERO
    }

    pub(super) fn new(material: &Material, ambient: [f64; 3]) -> Self {
        Self {
            ambient: colour::<S>(std::array::from_fn(|i| ambient[i] * material.color[i])),
            diffuse: rounded3::<S>(material.color.map(|c| material.diffuse * c)),
            specular: S::rounded(material.specular),
            power: Power::new(material.shininess),
            mirror: S::rounded(material.mirror()),
        }
    }

    /// All constants as bits, to find equal materials.
    pub(super) fn bits(&self) -> [u64; 11] {
        let [a, d] = [self.ambient, self.diffuse].map(|v| v.into().map(bits::<S>));
        let [kind, exponent, cut] = self.power.bits();
        let (ks, k) = (bits(self.specular), bits(self.mirror));
        [a[0], a[1], a[2], d[0], d[1], d[2], ks, kind, exponent, cut, k]
    }
}

/// The bits of a number's f64: different for different numbers.
fn bits<S: Scalar>(x: S) -> u64 {
    x.to_f64().to_bits()
}
