//! Vectors of stated numbers, rounded once.

use crate::{DoubleDouble, Scalar, Wider};

/// The unit vector of a direction of a valid scene.
pub(super) fn unit<W: Wider>(v: [W; 3]) -> [W; 3] {
    crate::direction::unit(v).expect("a valid scene's directions are not zero")
}

/// A colour, with 0 for -0: then no sum of light is -0, and adding 0 to one changes no bit.
pub(super) fn colour<S: Scalar>(v: [f64; 3]) -> S::Vec3 {
    rounded3::<S>(v.map(|x| x + 0.0))
}

/// Three numbers, each rounded.
pub(super) fn rounded3<S: Scalar>(v: [f64; 3]) -> S::Vec3 {
    v.map(S::rounded).into()
}

/// Three sums, each rounded once.
pub(super) fn nearest3<S: Scalar>(v: [DoubleDouble; 3]) -> S::Vec3 {
    v.map(S::nearest).into()
}
