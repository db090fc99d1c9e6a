//! What differs, measured.

use catoptric_scene::{Quantiser, Transfer};

use crate::format::Picture;

/// The differences between two pictures of one size and kind.
#[derive(Clone, Debug)]
pub(super) struct Difference {
    pub(super) width: u32,
    pub(super) height: u32,
    /// What is compared, and the unit of `largest` and `rmse`.
    pub(super) values: Values,
    /// Pixels that differ in at least one channel.
    pub(super) pixels: u64,
    /// The first of them, row by row from the top left.
    pub(super) first: Option<First>,
    /// Largest absolute difference of a channel, over those that are finite.
    pub(super) largest: f64,
    /// Root of the mean squared difference over all channels whose difference is finite.
    pub(super) rmse: f64,
    /// Channels that differ by no finite number: one side is infinite or NaN.
    pub(super) not_finite: u64,
    /// Pixels by the largest difference of their 8-bit levels, 0 to 255; f32 is quantised with
    /// the linear transfer.
    levels_apart: [u64; 256],
}

/// What is compared.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Values {
    /// 0 to 255.
    Levels,
    /// Linear f32, compared as bits.
    Linear,
}

/// A pixel that differs.
#[derive(Clone, Copy, Debug)]
pub(super) struct First {
    pub(super) x: u32,
    pub(super) y: u32,
    pub(super) values: Pair,
}

/// A pixel's or channel's values in A and in B.
#[derive(Clone, Copy, Debug)]
pub(super) enum Pair {
    Levels([u8; 3], [u8; 3]),
    Linear([f32; 3], [f32; 3]),
}

/// Two values of one channel.
trait Channel: Copy {
    fn differs(self, other: Self) -> bool;
    /// The value as a number, for the size of a difference.
    fn number(self) -> f64;
}

impl Channel for u8 {
    fn differs(self, other: Self) -> bool {
        self != other
    }

    fn number(self) -> f64 {
        self.into()
    }
}

impl Channel for f32 {
    /// Compares bits, so that -0 and 0 differ, but takes all NaNs for equal: a payload says
    /// nothing about a picture.
    fn differs(self, other: Self) -> bool {
        self.to_bits() != other.to_bits() && !(self.is_nan() && other.is_nan())
    }

    fn number(self) -> f64 {
        self.into()
    }
}

/// The absolute difference of two channels; `None` where there is no finite one.
fn distance<T: Channel>(a: T, b: T) -> Option<f64> {
    if !a.differs(b) {
        return Some(0.0);
    }
    Some((a.number() - b.number()).abs()).filter(|d| d.is_finite())
}

impl Difference {
    /// Compares two pictures of one size and kind.
    pub(super) fn between(a: &Picture, b: &Picture) -> Self {
        match (a, b) {
            (Picture::Levels(a), Picture::Levels(b)) => {
                let mut found =
                    Self::measure(a.width, &a.pixels, &b.pixels, Values::Levels, Pair::Levels);
                found.count_levels(a.pixels.iter().zip(&b.pixels).map(|(&a, &b)| (a, b)));
                found
            }
            (Picture::Linear(a), Picture::Linear(b)) => {
                let (width, a, b) = (a.width(), a.pixels(), b.pixels());
                let mut found = Self::measure(width, a, b, Values::Linear, Pair::Linear);
                let quantiser = Quantiser::new(Transfer::Linear);
                let levels = |pixel: &[f32; 3]| pixel.map(|channel| quantiser.level(channel));
                found.count_levels(a.iter().zip(b).map(|(a, b)| (levels(a), levels(b))));
                found
            }
            _ => unreachable!("pictures of two kinds are not compared"),
        }
    }

    /// Pixels with a channel whose 8-bit levels differ by more than that; f32 is quantised with
    /// the linear transfer.
    pub(super) fn level_pixels_over(&self, levels: u8) -> u64 {
        self.levels_apart[usize::from(levels) + 1..].iter().sum()
    }

    fn measure<T: Channel>(
        width: u32,
        a: &[[T; 3]],
        b: &[[T; 3]],
        values: Values,
        pair: impl Fn([T; 3], [T; 3]) -> Pair,
    ) -> Self {
        let (mut pixels, mut first) = (0, None);
        let (mut largest, mut squares, mut finite, mut not_finite) = (0.0, 0.0, 0_u64, 0);
        for (index, (&a, &b)) in a.iter().zip(b).enumerate() {
            // Every channel counts towards the sums; what is not finite on one side has no
            // distance.
            let mut differs = false;
            for (&a, &b) in a.iter().zip(&b) {
                differs |= a.differs(b);
                match distance(a, b) {
                    None => not_finite += 1,
                    Some(distance) => {
                        finite += 1;
                        squares += distance * distance;
                        if distance > largest {
                            largest = distance;
                        }
                    }
                }
            }
            // A pixel differs if one of its channels does.
            if differs {
                pixels += 1;
                let (x, y) = (index % width as usize, index / width as usize);
                first.get_or_insert(First { x: x as u32, y: y as u32, values: pair(a, b) });
            }
        }
        // The mean is over finite channels alone.
        let rmse = if finite == 0 { 0.0 } else { (squares / finite as f64).sqrt() };
        Self {
            width,
            height: (a.len() / width as usize) as u32,
            values,
            pixels,
            first,
            largest,
            rmse,
            not_finite,
            levels_apart: [0; 256],
        }
    }

    fn count_levels(&mut self, pixels: impl Iterator<Item = ([u8; 3], [u8; 3])>) {
        for (a, b) in pixels {
            let apart = a.iter().zip(&b).map(|(&a, &b)| a.abs_diff(b)).max().unwrap_or(0);
            self.levels_apart[usize::from(apart)] += 1;
        }
    }

    /// What a difference is multiplied by in the image, so that the largest is level 255.
    pub(super) fn amplification(&self) -> f64 {
        if self.largest > 0.0 { 255.0 / self.largest } else { 1.0 }
    }

    /// Levels of the difference image: the amplified absolute difference, at least 1 where
    /// a channel differs at all, 255 where it differs by no finite number.
    pub(super) fn image(&self, a: &Picture, b: &Picture) -> Vec<u8> {
        match (a, b) {
            (Picture::Levels(a), Picture::Levels(b)) => {
                self.amplified(a.pixels.as_flattened(), b.pixels.as_flattened())
            }
            (Picture::Linear(a), Picture::Linear(b)) => {
                self.amplified(a.pixels().as_flattened(), b.pixels().as_flattened())
            }
            _ => unreachable!("pictures of two kinds have no difference"),
        }
    }

    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "1 to 255.5")]
    fn amplified<T: Channel>(&self, a: &[T], b: &[T]) -> Vec<u8> {
        let factor = self.amplification();
        let level = |(&a, &b): (&T, &T)| match distance(a, b) {
            None => 255,
            Some(_) if !a.differs(b) => 0,
            Some(distance) => ((distance * factor + 0.5) as u8).max(1),
        };
        a.iter().zip(b).map(level).collect()
    }
}

/// How many f32 lie between two numbers, one of them included, in the order in which -0
/// stands just below 0; `None` if one is NaN.
pub(super) fn ulps(a: f32, b: f32) -> Option<u32> {
    /// Monotonic: negative numbers are turned around below the others.
    fn place(x: f32) -> u32 {
        let bits = x.to_bits();
        if x.is_sign_negative() { !bits } else { bits | 1 << 31 }
    }
    (!a.is_nan() && !b.is_nan()).then(|| place(a).abs_diff(place(b)))
}

#[cfg(test)]
mod tests {
    use super::ulps;

    #[test]
    fn ulps_count_steps() {
        assert_eq!(ulps(1.0, 1.0), Some(0));
        assert_eq!(ulps(1.0, 1.0_f32.next_up()), Some(1));
        assert_eq!(ulps(-1.0, (-1.0_f32).next_up()), Some(1));
        assert_eq!(ulps(-0.0, 0.0), Some(1));
        assert_eq!(ulps(0.0_f32.next_up(), (-0.0_f32).next_down()), Some(3));
        assert_eq!(ulps(f32::MAX, f32::INFINITY), Some(1));
        assert_eq!(ulps(f32::NAN, 1.0), None);
    }
}
