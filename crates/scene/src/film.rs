//! The film: linear RGB, and the one quantisation to 8 bits.

use crate::{Scalar, Transfer};

/// A picture in linear RGB, unclamped. A film in f64 is for studies: levels are made of f32.
///
/// Layout: row-major from the top left, one `[r, g, b]` a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Film<S: Scalar = f32> {
    width: u32,
    height: u32,
    pixels: Vec<[S; 3]>,
}

impl Film {
    /// A black film in f32. The system gives its memory page by page, as pixels are first written.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self::black(width, height)
    }
}

impl<S: Scalar> Film<S> {
    /// A black film.
    #[must_use]
    pub fn black(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![[S::ZERO; 3]; width as usize * height as usize] }
    }

    /// Columns.
    #[must_use]
    pub fn width(&self) -> u32 {
        self.width
    }

    /// Rows.
    #[must_use]
    pub fn height(&self) -> u32 {
        self.height
    }

    /// All pixels, row by row from the top.
    #[must_use]
    pub fn pixels(&self) -> &[[S; 3]] {
        &self.pixels
    }

    /// All pixels, for writing.
    pub fn pixels_mut(&mut self) -> &mut [[S; 3]] {
        &mut self.pixels
    }
}

/// Turns linear f32 into 8-bit levels: clamp to [0, 1] (NaN is 0), transfer, times 255, plus 1/2,
/// truncate. This is the only place where pictures are quantised.
///
/// sRGB is decided by comparing with thresholds, so that no libm decides a pixel:
/// level v is reached at the least f32 whose exact curve value is at least (v - 1/2)/255.
#[derive(Clone, Debug)]
pub struct Quantiser {
    /// The sRGB transfer; `None` is the linear one.
    srgb: Option<Box<Srgb>>,
}

impl Quantiser {
    /// The quantiser of a transfer.
    #[must_use]
    pub fn new(transfer: Transfer) -> Self {
        match transfer {
            Transfer::Linear => Self { srgb: None },
            Transfer::Srgb => Self { srgb: Some(Box::new(Srgb::new())) },
        }
    }

    /// Whether levels are the whole parts of what [`Quantiser::scaled`] gives.
    #[must_use]
    #[inline(always)]
    pub fn is_linear(&self) -> bool {
        self.srgb.is_none()
    }

    /// 255 x + 1/2 for a linear value clamped to [0, 1]. Its whole part is the level in the linear
    /// transfer; for callers that quantise many values at once.
    #[must_use]
    #[inline(always)]
    pub fn scaled(linear: f32) -> f32 {
        clamped(linear) * 255.0 + 0.5
    }

    /// The level of one linear value.
    #[must_use]
    #[inline(always)]
    pub fn level(&self, linear: f32) -> u8 {
        match &self.srgb {
            None => linear_level(linear),
            Some(srgb) => srgb.level(linear),
        }
    }

    /// Writes the levels of many pixels: the same as one by one, without a call for each.
    ///
    /// Always inlined, so that it is compiled for the caller's instruction set.
    ///
    /// # Panics
    /// If there is not one place for each pixel.
    #[inline(always)]
    pub fn levels(&self, linear: &[[f32; 3]], to: &mut [[u8; 3]]) {
        assert_eq!(linear.len(), to.len(), "a place for each pixel");
        let all = linear.as_flattened().iter().zip(to.as_flattened_mut());
        match &self.srgb {
            None => {
                for (&linear, to) in all {
                    *to = linear_level(linear);
                }
            }
            Some(srgb) => {
                for (&linear, to) in all {
                    *to = srgb.level(linear);
                }
            }
        }
    }
}

/// Clamps to [0, 1]. NaN fails the first comparison and becomes 0.
#[inline(always)]
fn clamped(x: f32) -> f32 {
    let x = if x > 0.0 { x } else { 0.0 };
    if x < 1.0 { x } else { 1.0 }
}

/// The linear transfer: 255 x + 1/2, truncated.
///
/// The cast `as u8` would say the same, but is not compiled to vector instructions. Adding
/// 2^23 rounds to a whole number, which stands in the lowest bits of the sum's mantissa; where
/// it was rounded up, the truncated number is one less.
#[inline(always)]
#[expect(clippy::cast_possible_truncation, reason = "the lowest 8 bits are the level")]
fn linear_level(linear: f32) -> u8 {
    const WHOLE: f32 = 8_388_608.0; // 2^23
    let x = Quantiser::scaled(linear);
    let rounded = x + WHOLE;
    let truncated = if rounded - WHOLE > x { rounded - 1.0 } else { rounded };
    truncated.to_bits() as u8
}

/// The sRGB transfer as comparisons.
#[derive(Clone, Debug)]
struct Srgb {
    /// Level v is reached at `thresholds[v - 1]`.
    thresholds: [f32; 255],
    /// Levels by the upper 16 bits of an f32: the level of the least f32 with those bits, at most
    /// two below the level of any other f32 with them. The last entry is for 1.
    starts: Vec<u8>,
}

impl Srgb {
    #[expect(clippy::cast_possible_truncation, reason = "at most 255 thresholds")]
    fn new() -> Self {
        let thresholds = srgb_thresholds();
        let start = |upper: u32| {
            let least = f32::from_bits(upper << 16);
            thresholds.partition_point(|&threshold| threshold <= least) as u8
        };
        let starts = (0..=1.0_f32.to_bits() >> 16).map(start).collect();
        Self { thresholds, starts }
    }

    #[inline(always)]
    fn level(&self, linear: f32) -> u8 {
        let x = clamped(linear);
        let mut level = self.starts[(x.to_bits() >> 16) as usize];
        while level < 255 && self.thresholds[usize::from(level)] <= x {
            level += 1;
        }
        level
    }
}

/// Thresholds of the levels 1 to 255, level v at index v - 1: the least f32 not below the exact
/// threshold.
#[expect(clippy::cast_possible_truncation, reason = "rounded up on the next line")]
fn srgb_thresholds() -> [f32; 255] {
    let mut thresholds = [0.0; 255];
    for (below, threshold) in thresholds.iter_mut().enumerate() {
        let exact = srgb_to_linear((below as f64 + 0.5) / 255.0);
        let rounded = exact as f32;
        *threshold = if f64::from(rounded) < exact { rounded.next_up() } else { rounded };
    }
    thresholds
}

/// The inverse sRGB curve (IEC 61966-2-1) of a value in [0, 1], by + - * / alone, so that
/// it is the same on every machine: x^2.4 = x^2 · y^2 with y^5 = x.
fn srgb_to_linear(encoded: f64) -> f64 {
    if encoded <= 0.04045 {
        return encoded / 12.92;
    }
    let x = (encoded + 0.055) / 1.055;
    // Newton from above converges monotonically; x lies in [0.09, 1].
    let mut root = 1.0;
    for _ in 0..64 {
        let power4 = root * root * root * root;
        root -= (root * power4 - x) / (5.0 * power4);
    }
    x * x * (root * root)
}
