//! Vectors of doubles.

/// The inner product.
pub(super) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| a[i] * b[i]).sum()
}

/// The vector of length 1. Scaled first, so that no square is lost.
pub(super) fn unit(v: [f64; 3]) -> [f64; 3] {
    let largest = v.into_iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let v = v.map(|x| x / largest);
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}
