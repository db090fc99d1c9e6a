//! Another number in the place of one.

use std::ops::Range;

/// Ends of ranges, and values at which formulas change.
const ODD: [f64; 20] = [
    0.0,
    -0.0,
    1.0,
    -1.0,
    0.5,
    2.0,
    1e-12,
    1e12,
    -1e15,
    1e15,
    1e-20,
    1e-38,
    1e-45,
    1e19,
    1e38,
    5e-324,
    1e300,
    16_777_216.0,
    179.999,
    4_294_967_295.0,
];

/// The text with one or two of its numbers changed; `None` where there is none.
pub fn change(bytes: &[u8], seed: u32) -> Option<String> {
    let mut random = Random(u64::from(seed));
    let mut text = std::str::from_utf8(bytes).ok()?.to_owned();
    for _ in 0..=random.below(2) {
        let places = places(&text);
        let place = places.get(random.below(places.len().max(1)))?.clone();
        let other = places[random.below(places.len())].clone();
        let value = text[place.clone()].parse::<f64>().ok()?;
        let other = text[other].parse::<f64>().ok()?;
        let new = match random.below(10) {
            0 => ODD[random.below(ODD.len())],
            1 => other,
            2 => -value,
            3 => value * 10_f64.powi(random.below(13) as i32 - 6),
            4 => f64::from((value as f32).next_up()),
            5 => f64::from((value as f32).next_down()),
            6 => value.round(),
            7 => value + other,
            8 => value * (1.0 + 1e-6 * random.below(100) as f64),
            _ => random.below(2001) as f64 / 100.0 - 10.0,
        };
        // Debug would write a fraction after a whole number, which no count takes.
        text.replace_range(place, &format!("{new}"));
    }
    Some(text)
}

/// The places of all numbers that parse.
fn places(text: &str) -> Vec<Range<usize>> {
    let part = |c: char| c.is_ascii_digit() || "+-.e".contains(c);
    let mut found = Vec::new();
    let mut rest = 0;
    while let Some(start) = text[rest..].find(|c: char| c.is_ascii_digit() || c == '-') {
        let start = rest + start;
        rest = text[start..].find(|c: char| !part(c)).map_or(text.len(), |end| start + end);
        if text[start..rest].parse::<f64>().is_ok() {
            found.push(start..rest);
        }
    }
    found
}

/// Splitmix64.
struct Random(u64);

impl Random {
    fn below(&mut self, bound: usize) -> usize {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut x = self.0;
        x = (x ^ (x >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        x = (x ^ (x >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((x ^ (x >> 31)) % bound as u64) as usize
    }
}
