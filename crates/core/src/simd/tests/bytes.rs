//! Eight pixels from three times eight lanes.

use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, run};

/// Pixels of eight colours, as numbers and as whole parts.
struct Pixels<S>([[S; LANES]; 3]);

impl<S: TestScalar> Kernel for Pixels<S> {
    type Scalar = S;
    type Output = [[S; 3]; LANES];

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        let [x, y, z] = self.0;
        let mut pixels = [[S::ZERO; 3]; LANES];
        L::interleave(L::from_array(x), L::from_array(y), L::from_array(z), &mut pixels);
        pixels
    }
}

#[test]
fn interleaved_lanes_are_pixels() {
    fn check<S: TestScalar>() {
        let mut numbers = Numbers::new(5);
        for isa in isas() {
            for _ in 0..200 {
                let channels: [[S; LANES]; 3] = std::array::from_fn(|_| numbers.eight());
                let pixels = run(isa, Pixels(channels));
                for (lane, pixel) in pixels.iter().enumerate() {
                    for (channel, x) in pixel.iter().enumerate() {
                        let expected = channels[channel][lane].pattern();
                        assert_eq!(x.pattern(), expected, "{isa}, lane {lane}, {channel}");
                    }
                }
            }
        }
    }
    check::<f32>();
    check::<f64>();
}

/// The whole parts of eight colours.
struct Bytes<S>([[S; LANES]; 3]);

impl<S: TestScalar> Kernel for Bytes<S> {
    type Scalar = S;
    type Output = [[u8; 3]; LANES];

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Self::Output {
        let [x, y, z] = self.0;
        let mut pixels = [[0xaa; 3]; LANES];
        L::bytes(L::from_array(x), L::from_array(y), L::from_array(z), &mut pixels);
        pixels
    }
}

/// Every level: alone, next to it on both sides, and in between.
fn levels<S: TestScalar>() -> Vec<(S, u8)> {
    let mut all = vec![(S::MIN_POSITIVE, 0), (S::from_pattern(1), 0)];
    for level in 0..=u8::MAX {
        let whole = f64::from(level);
        for part in [0.0, 0.25, 0.499, 0.5, 0.501, 0.75] {
            all.push((S::rounded(whole + part), level));
        }
        all.push((S::rounded(whole).next_above(), level));
        all.push((S::rounded(whole + 0.5).next_below(), level));
        all.push((S::rounded(whole + 0.5).next_above(), level));
        all.push((S::rounded(whole + 1.0).next_below(), level));
    }
    all
}

#[test]
fn bytes_are_the_whole_parts_of_every_level() {
    fn check<S: TestScalar>() {
        let levels = levels::<S>();
        for isa in isas() {
            for start in 0..levels.len() {
                // Each channel and lane has a level of its own.
                let at = |channel: usize, lane: usize| {
                    levels[(start + 997 * channel + 131 * lane) % levels.len()]
                };
                let channel = |channel| std::array::from_fn(|lane| at(channel, lane).0);
                let pixels = run(isa, Bytes(std::array::from_fn(channel)));
                for (lane, pixel) in pixels.into_iter().enumerate() {
                    let expected = std::array::from_fn(|channel| at(channel, lane).1);
                    let x: [S; 3] = std::array::from_fn(|channel| at(channel, lane).0);
                    assert_eq!(pixel, expected, "{isa}, lane {lane}: {x:?}");
                }
            }
        }
    }
    check::<f32>();
    check::<f64>();
}
