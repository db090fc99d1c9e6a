//! Directions of any length.

use crate::Wider;

/// The unit vector of a direction; `None` for a zero vector and for one with an infinity
/// or NaN in it.
///
/// Divides by the largest component first, so that no finite length overflows or
/// underflows: 1e-200 and 1e200 are directions like any other.
pub(crate) fn unit<W: Wider>(v: [W; 3]) -> Option<[W; 3]> {
    let zero = W::from(0.0);
    let size = v.into_iter().fold(zero, |size, x| {
        let magnitude = if x < zero { -x } else { x };
        if magnitude > size { magnitude } else { size }
    });
    if size == zero || !v.into_iter().all(|x| x.into().to_f64().is_finite()) {
        return None;
    }
    let scaled = v.map(|x| x / size);
    let length = dot(scaled, scaled).sqrt();
    Some(scaled.map(|x| x / length))
}

/// Scales a direction by a power of two, hence exactly, to a length that double-double divides
/// without overflow.
pub(crate) fn tamed(v: [f64; 3]) -> [f64; 3] {
    let power_of_two = |exponent: u64| f64::from_bits((exponent + 1023) << 52);
    let scale = if v.iter().any(|x| x.abs() > 1e100) {
        1.0 / power_of_two(700)
    } else if v.iter().all(|x| x.abs() < 1e-100) {
        power_of_two(700)
    } else {
        1.0
    };
    v.map(|x| x * scale)
}

/// Whether two unit vectors lie along one line, so that no picture plane can be put up
/// between them.
///
/// The rounding of f64 leaves an error of some 4e-16 in each component of their cross
/// product, whose length is the sine s of the angle, so the side vector made from it is
/// off by an angle of 4e-16/s. For s of 1e-8 or more that is at most 4e-8, less than f32
/// tells apart; below, the picture would visibly turn with the rounding.
pub(crate) fn parallel(a: [f64; 3], b: [f64; 3]) -> bool {
    let side = cross(a, b);
    dot(side, side).sqrt() < 1e-8
}

pub(crate) fn cross<W: Wider>(a: [W; 3], b: [W; 3]) -> [W; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot<W: Wider>(a: [W; 3], b: [W; 3]) -> W {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
