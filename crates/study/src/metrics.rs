//! How far a picture is from truth.
//!
//! On linear unclamped RGB, and on the 8-bit levels that people see. Both counts of levels
//! are stated, since values on a rounding tie make many levels differ by one.

use catoptric_scene::{Film, Quantiser, Scalar, Transfer};

/// The difference of a picture from truth.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Metrics {
    /// Largest absolute difference of a channel.
    pub max: f64,
    /// Root of the mean squared difference over all channels.
    pub rmse: f64,
    /// 99.9th percentile of each pixel's largest difference of a channel.
    pub p999: f64,
    /// Pixels whose 8-bit levels differ.
    pub off: u64,
    /// Pixels with a channel whose levels differ by more than one.
    pub off_by_more: u64,
    /// Values that are NaN or infinite in the picture; left out of the others.
    pub not_finite: u64,
}

impl Metrics {
    /// Measures `found` against `truth`, pixel by pixel, with the levels of linear pictures.
    ///
    /// # Panics
    /// If they are not equally many.
    #[must_use]
    pub fn of(found: &[[f64; 3]], truth: &[[f64; 3]]) -> Self {
        Self::over(found, truth, Transfer::Linear, |_| true)
    }

    /// Measures those pixels whose index `counts`, with that transfer's levels. All are 0 where
    /// no pixel counts.
    ///
    /// # Panics
    /// If they are not equally many.
    #[must_use]
    pub fn over(
        found: &[[f64; 3]],
        truth: &[[f64; 3]],
        transfer: Transfer,
        counts: impl Fn(usize) -> bool,
    ) -> Self {
        assert_eq!(found.len(), truth.len(), "pictures of one size");
        let quantiser = Quantiser::new(transfer);
        let levels = |pixel: &[f64; 3]| pixel.map(|channel| quantiser.level(f32::rounded(channel)));
        let (mut squares, mut channels, mut not_finite) = (0.0, 0_u64, 0);
        let (mut off, mut off_by_more) = (0, 0);
        let mut largest = Vec::with_capacity(found.len());
        let pairs = found.iter().zip(truth).enumerate();
        for (_, (found, truth)) in pairs.filter(|(index, _)| counts(*index)) {
            // Channels that are not finite are counted, and left out of RMSE and maximum.
            let mut of_pixel = 0.0_f64;
            for (found, truth) in found.iter().zip(truth) {
                if !found.is_finite() {
                    not_finite += 1;
                    continue;
                }
                let difference = (found - truth).abs();
                squares += difference * difference;
                channels += 1;
                of_pixel = if difference > of_pixel { difference } else { of_pixel };
            }
            largest.push(of_pixel);
            // Levels are compared as an 8-bit picture shows them.
            let pairs = levels(found).into_iter().zip(levels(truth));
            let worst = pairs.map(|(a, b)| a.abs_diff(b)).max().unwrap_or(0);
            off += u64::from(worst > 0);
            off_by_more += u64::from(worst > 1);
        }
        // Percentiles by nearest rank, over each pixel's largest difference.
        largest.sort_by(f64::total_cmp);
        let at = |share: f64| {
            let rank = (largest.len() as f64 * share).ceil() as usize;
            largest.get(rank.saturating_sub(1)).copied().unwrap_or(0.0)
        };
        let rmse = if channels == 0 { 0.0 } else { (squares / channels as f64).sqrt() };
        Self { max: at(1.0), rmse, p999: at(0.999), off, off_by_more, not_finite }
    }
}

/// Pixels of two pictures of one size that differ in some bit; the payload of a NaN says nothing.
#[must_use]
pub fn differing_pixels(a: &Film, b: &Film) -> usize {
    let same = |(a, b): (&f32, &f32)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    let pairs = a.pixels().iter().zip(b.pixels());
    pairs.filter(|(a, b)| !a.iter().zip(*b).all(same)).count()
}

/// The larger; NaN if one is NaN.
pub(crate) fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// The largest difference of a channel; NaN if one is NaN.
pub(crate) fn difference(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
}

/// A picture in f32 as numbers that can be compared with truth.
#[must_use]
pub fn widened(pixels: &[[f32; 3]]) -> Vec<[f64; 3]> {
    pixels.iter().map(|pixel| pixel.map(f64::from)).collect()
}
