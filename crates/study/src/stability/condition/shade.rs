//! Numbers as colours.

/// Smith and van der Walt's viridis (matplotlib 2.0, 2015; CC0) from ten anchors evenly apart:
/// even to the eye in lightness, and for eyes that do not tell red from green. 0 to 1; what is
/// below, or NaN, is the darkest.
pub(super) fn viridis(x: f64) -> [u8; 3] {
    const ANCHORS: [[u8; 3]; 10] = [
        [0x44, 0x01, 0x54],
        [0x48, 0x28, 0x78],
        [0x3e, 0x49, 0x89],
        [0x31, 0x68, 0x8e],
        [0x26, 0x82, 0x8e],
        [0x1f, 0x9e, 0x89],
        [0x35, 0xb7, 0x79],
        [0x6e, 0xce, 0x58],
        [0xb5, 0xde, 0x2b],
        [0xfd, 0xe7, 0x25],
    ];
    let last = ANCHORS.len() - 1;
    let x = if x > 0.0 { x } else { 0.0 };
    let at = if x < 1.0 { x * last as f64 } else { last as f64 };
    #[expect(clippy::cast_possible_truncation, clippy::cast_sign_loss, reason = "0 to 9, 0 to 255")]
    let (low, mix) = (at as usize, |a: u8, b: u8| {
        (f64::from(a) + (f64::from(b) - f64::from(a)) * at.fract()).round() as u8
    });
    let (a, b) = (ANCHORS[low], ANCHORS[if low < last { low + 1 } else { last }]);
    std::array::from_fn(|c| mix(a[c], b[c]))
}
