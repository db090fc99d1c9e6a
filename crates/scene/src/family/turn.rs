//! Cosine and sine of parts of a turn.

/// Cosine and sine of k/n of a turn; 0 <= k < n, n at most 2^32.
///
/// Error: below 2^-52 absolute. The same bits everywhere, unlike libm's: the octant is
/// exact in integers, then both Taylor series run to their last bit on [0, pi/4].
pub(super) fn turn(k: u64, n: u64) -> (f64, f64) {
    let eighths = 8 * k;
    let (octant, rest) = (eighths / n, eighths % n);
    // Odd octants are measured from their upper end, so that axes and diagonals are shared.
    let part = if octant % 2 == 0 { rest } else { n - rest };
    #[expect(clippy::cast_precision_loss, reason = "integers of at most 33 bits")]
    let angle = std::f64::consts::FRAC_PI_4 * (part as f64 / n as f64);
    let (cos, sin) = (series(1.0, 1.0, angle), series(angle, 2.0, angle));
    match octant {
        0 => (cos, sin),
        1 => (sin, cos),
        2 => (-sin, cos),
        3 => (-cos, sin),
        4 => (-cos, -sin),
        5 => (-sin, -cos),
        6 => (sin, -cos),
        _ => (cos, -sin),
    }
}

/// Sum of the alternating terms first, first·x²/(d(d + 1)), ..., d growing by 2, smallest
/// first. Ten terms: the next is below 2^-63 of the first.
fn series(first: f64, denominator: f64, x: f64) -> f64 {
    let mut terms = [first; 10];
    let mut d = denominator;
    for i in 1..terms.len() {
        terms[i] = -terms[i - 1] * (x * x) / (d * (d + 1.0));
        d += 2.0;
    }
    terms.iter().rev().fold(0.0, |sum, term| sum + term)
}
