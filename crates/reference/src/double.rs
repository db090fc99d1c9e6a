//! The recursion in f64, for studies of accuracy: the same folder, compiled a second time with
//! other numbers under the names `Real` and `Vec3`. [`truth`](crate::truth) is apart from both.

#[expect(clippy::duplicate_mod, reason = "the same operations in f64, and no second source")]
#[path = "recursion/mod.rs"]
mod recursion;

pub use recursion::{path, power, ray, render, trace};

/// Numbers of the recursion: f64.
mod real {
    pub(crate) use std::f64::consts;

    pub(crate) use glam::DVec3 as Vec3;

    pub(crate) type Real = f64;
    pub(crate) type Bits = u64;
}
