//! Phong's constants.

use glam::Vec3;

use super::{rounded, rounded3};
use crate::Material;

/// A material's constants, each product formed in f64 and rounded once.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Phong {
    /// ambient · colour.
    pub ambient: Vec3,
    /// kd · colour.
    pub diffuse: Vec3,
    /// ks.
    pub specular: f32,
    /// The highlight's exponent.
    pub power: Power,
    /// The mirror factor k, in [0, 1].
    pub mirror: f32,
}

/// An exponent p, for bases in [0, 1].
///
/// x^p is taken as 0 for x <= `cut` = 2^(-50/p): the result is below 1e-15, and no
/// intermediate product can become subnormal, which would cost a hundred cycles each.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Power {
    /// Whole p up to 1024: repeated squaring, from the lowest bit of p.
    Whole {
        /// p.
        exponent: u32,
        /// -1 for p = 0, since 0^0 is 1.
        cut: f32,
    },
    /// Any other p: 2^(p log2 x).
    Real {
        /// p.
        exponent: f32,
        /// Never below the least normal f32.
        cut: f32,
    },
}

impl Power {
    /// Above it, squaring's error (about p/2 ulp) passes that of the exponential.
    const LARGEST_WHOLE: f64 = 1024.0;

    /// log2 m = s·sum of c_j s^(2j) with s = (m - 1)/(m + 1): c_j = 2/((2j + 1) ln 2).
    pub const LOG2_SERIES: [f32; 5] = [2.885_39, 0.961_796_7, 0.577_078, 0.412_198_58, 0.320_598_9];

    /// 2^f = sum of c_j f^j: c_j = (ln 2)^j / j!.
    pub const EXP2_SERIES: [f32; 8] = [
        1.0,
        std::f32::consts::LN_2,
        0.240_226_5,
        0.055_504_11,
        0.009_618_129,
        0.001_333_355_8,
        0.000_154_035_31,
        0.000_015_252_734,
    ];

    fn new(p: f64) -> Self {
        if p == 0.0 {
            return Self::Whole { exponent: 0, cut: -1.0 };
        }
        let cut = rounded((-50.0 / p).exp2());
        let cut = if cut < f32::MIN_POSITIVE { f32::MIN_POSITIVE } else { cut };
        if p.fract() == 0.0 && p <= Self::LARGEST_WHOLE {
            #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "whole")]
            Self::Whole { exponent: p as u32, cut }
        } else {
            Self::Real { exponent: rounded(p), cut }
        }
    }

    /// Kind, p and cut as bits: equal exactly where the powers are the same.
    fn bits(self) -> [u32; 3] {
        match self {
            Self::Whole { exponent, cut } => [0, exponent, cut.to_bits()],
            Self::Real { exponent, cut } => [1, exponent.to_bits(), cut.to_bits()],
        }
    }
}

impl Phong {
    pub(super) fn new(material: &Material, ambient: [f64; 3]) -> Self {
        Self {
            ambient: rounded3(std::array::from_fn(|i| ambient[i] * material.color[i])),
            diffuse: rounded3(material.color.map(|c| material.diffuse * c)),
            specular: rounded(material.specular),
            power: Power::new(material.shininess),
            mirror: rounded(material.mirror()),
        }
    }

    /// All constants as bits, to find equal materials.
    pub(super) fn bits(&self) -> [u32; 11] {
        let [a, d] = [self.ambient, self.diffuse].map(|v| v.to_array().map(f32::to_bits));
        let [kind, exponent, cut] = self.power.bits();
        let (ks, k) = (self.specular.to_bits(), self.mirror.to_bits());
        [a[0], a[1], a[2], d[0], d[1], d[2], ks, kind, exponent, cut, k]
    }
}
