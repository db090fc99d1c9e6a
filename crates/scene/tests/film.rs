//! The one quantisation, against a computation in arbitrary precision.

use catoptric_scene::{Film, Quantiser, Transfer};
use dashu_float::FBig;
use dashu_float::round::mode::HalfEven;

type Exact = FBig<HalfEven, 2>;

/// A quotient of integers, to 200 bits.
fn ratio(numerator: u32, denominator: u32) -> Exact {
    let exact = |n: u32| Exact::from(n).with_precision(200).value();
    exact(numerator) / exact(denominator)
}

/// The least f32 that is not below a positive number.
fn rounded_up(exact: &Exact) -> f32 {
    let near = exact.to_f64().value() as f32;
    let not_below = |x: f32| Exact::try_from(x).expect("finite") >= *exact;
    let least = [near.next_down(), near, near.next_up()].into_iter().find(|&x| not_below(x));
    least.expect("one of the neighbours is above")
}

/// The linear value of an encoded one by the standard's own formula.
fn srgb_to_linear(encoded: &Exact) -> Exact {
    if *encoded <= ratio(4045, 100_000) {
        encoded / ratio(1292, 100)
    } else {
        ((encoded + ratio(55, 1000)) / ratio(1055, 1000)).powf(&ratio(24, 10))
    }
}

#[test]
fn srgb_levels_begin_at_the_exact_thresholds() {
    let quantiser = Quantiser::new(Transfer::Srgb);
    for level in 1..=255_u8 {
        let threshold = rounded_up(&srgb_to_linear(&ratio(2 * u32::from(level) - 1, 510)));
        assert_eq!(quantiser.level(threshold), level, "at {threshold:e}");
        assert_eq!(quantiser.level(threshold.next_down()), level - 1, "below {threshold:e}");
    }
}

#[test]
fn both_transfers_clamp_and_take_nan_as_black() {
    for transfer in [Transfer::Linear, Transfer::Srgb] {
        let quantiser = Quantiser::new(transfer);
        let cases = [
            (f32::NAN, 0),
            (-f32::NAN, 0),
            (f32::NEG_INFINITY, 0),
            (-1.0, 0),
            (-0.0, 0),
            (0.0, 0),
            (f32::from_bits(1), 0),
            (1.0, 255),
            (1.0_f32.next_up(), 255),
            (f32::MAX, 255),
            (f32::INFINITY, 255),
        ];
        for (linear, level) in cases {
            assert_eq!(quantiser.level(linear), level, "{transfer:?} {linear:e}");
        }
    }
}

#[test]
fn linear_levels_are_the_stated_operations_in_f32() {
    let quantiser = Quantiser::new(Transfer::Linear);
    for level in 1..=255_u8 {
        // The first value for which the sum of the product and 1/2, each rounded to f32,
        // reaches the level. It may lie an ulp from the exact threshold.
        let mut first = (f32::from(level) - 0.5) / 255.0;
        let reached = |x: f32| x * 255.0 + 0.5 >= f32::from(level);
        while reached(first) {
            first = first.next_down();
        }
        while !reached(first) {
            first = first.next_up();
        }
        assert_eq!(quantiser.level(first), level);
        assert_eq!(quantiser.level(first.next_down()), level - 1);
    }
    assert_eq!(quantiser.level(0.5), 128);
    assert_eq!(quantiser.level(0.001), 0);
    assert_eq!(quantiser.level(0.002), 1);
}

/// Between its thresholds a level does not change: a stride that meets every exponent, and
/// many mantissas, against a search and against the definition word by word.
#[test]
fn levels_everywhere_between() {
    let thresholds: Vec<f32> =
        (1..=255).map(|v| rounded_up(&srgb_to_linear(&ratio(2 * v - 1, 510)))).collect();
    let [linear, srgb] = [Transfer::Linear, Transfer::Srgb].map(Quantiser::new);
    for bits in (0..=1.0_f32.to_bits()).step_by(1_009) {
        let x = f32::from_bits(bits);
        assert_eq!(linear.level(x), (x * 255.0 + 0.5) as u8, "{x:e}");
        let searched = thresholds.partition_point(|&threshold| threshold <= x);
        assert_eq!(usize::from(srgb.level(x)), searched, "{x:e}");
    }
}

#[test]
fn many_levels_are_those_of_each() {
    let pixels: Vec<[f32; 3]> =
        (0..100).map(|i| [i as f32 / 70.0 - 0.2, i as f32 / 100.0, f32::NAN]).collect();
    for transfer in [Transfer::Linear, Transfer::Srgb] {
        let quantiser = Quantiser::new(transfer);
        let mut levels = vec![[7; 3]; pixels.len()];
        quantiser.levels(&pixels, &mut levels);
        for (pixel, level) in pixels.iter().zip(levels) {
            assert_eq!(pixel.map(|x| quantiser.level(x)), level, "{pixel:?}");
        }
    }
}

#[test]
fn a_new_film_is_black() {
    let film = Film::new(3, 2);
    assert_eq!((film.width(), film.height()), (3, 2));
    assert_eq!(film.pixels(), [[0.0; 3]; 6]);
}
