//! The recursion in f64: the same folder, compiled a second time with other numbers under the
//! names `Real` and `Vec3`. For studies of accuracy; [`truth`](crate::truth) is apart from both.

#[expect(clippy::duplicate_mod, reason = "the same operations in f64, and no second source")]
#[path = "recursion/mod.rs"]
mod recursion;

pub use recursion::{path, power, ray, render, trace};

/// What the recursion's numbers are here.
mod real {
    pub(crate) use std::f64::consts;

    pub(crate) use glam::DVec3 as Vec3;

    pub(crate) type Real = f64;
    pub(crate) type Bits = u64;
}
