//! The film: linear RGB, and the one quantisation to 8 bits.

use crate::Transfer;

/// A picture in linear RGB, f32, unclamped.
///
/// Layout: row-major from the top left, one `[r, g, b]` a pixel.
#[derive(Clone, Debug, PartialEq)]
pub struct Film {
    width: u32,
    height: u32,
    pixels: Vec<[f32; 3]>,
}

impl Film {
    /// A black film. Its pages are taken as they are first written.
    #[must_use]
    pub fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![[0.0; 3]; width as usize * height as usize] }
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
    pub fn pixels(&self) -> &[[f32; 3]] {
        &self.pixels
    }

    /// All pixels, for writing.
    pub fn pixels_mut(&mut self) -> &mut [[f32; 3]] {
        &mut self.pixels
    }
}

/// Linear f32 to 8-bit levels: clamp to [0, 1] (NaN is 0), transfer, times 255, plus 1/2,
/// truncate. This is the only place where that happens.
///
/// sRGB is decided by comparing with thresholds, so that no libm decides a pixel:
/// level v is reached at the least f32 whose exact curve value is at least (v - 1/2)/255.
#[derive(Clone, Debug)]
pub struct Quantiser {
    /// `None` is the linear transfer.
    srgb: Option<Box<[f32; 255]>>,
}

impl Quantiser {
    /// The quantiser of a transfer.
    #[must_use]
    pub fn new(transfer: Transfer) -> Self {
        match transfer {
            Transfer::Linear => Self { srgb: None },
            Transfer::Srgb => Self { srgb: Some(Box::new(srgb_thresholds())) },
        }
    }

    /// The level of one linear value.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "in 0 to 255.5")]
    pub fn level(&self, linear: f32) -> u8 {
        // NaN fails both comparisons and becomes 0.
        let x = if linear > 0.0 { if linear < 1.0 { linear } else { 1.0 } } else { 0.0 };
        match &self.srgb {
            None => (x * 255.0 + 0.5) as u8,
            Some(thresholds) => thresholds.partition_point(|&t| t <= x) as u8,
        }
    }
}

/// Threshold of level v at index v - 1: the least f32 not below the exact one.
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
