//! Directions of any length.

/// The unit vector of a direction; `None` for a zero vector and for one with an infinity
/// or NaN in it.
///
/// Divides by the largest component first, so that no finite length overflows or
/// underflows: 1e-200 and 1e200 are directions like any other.
pub(crate) fn unit(v: [f64; 3]) -> Option<[f64; 3]> {
    let size = v.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
    if size == 0.0 || !v.iter().all(|x| x.is_finite()) {
        return None;
    }
    let scaled = v.map(|x| x / size);
    let length = dot(scaled, scaled).sqrt();
    Some(scaled.map(|x| x / length))
}

/// Whether two unit vectors lie along one line, so that no picture plane can be put up
/// between them.
///
/// The rounding of f64 leaves an error of some 4e-16 in each component of their cross
/// product, whose length is the sine s of the angle, so the side vector made from it is
/// off by an angle of 4e-16/s. From s = 1e-8 on that is at most 4e-8, less than f32
/// tells apart; below, the picture would visibly turn with the rounding.
pub(crate) fn parallel(a: [f64; 3], b: [f64; 3]) -> bool {
    let side = cross(a, b);
    dot(side, side).sqrt() < 1e-8
}

pub(crate) fn cross(a: [f64; 3], b: [f64; 3]) -> [f64; 3] {
    [a[1] * b[2] - a[2] * b[1], a[2] * b[0] - a[0] * b[2], a[0] * b[1] - a[1] * b[0]]
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}
