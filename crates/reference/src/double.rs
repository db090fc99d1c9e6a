//! The recursion in f64: the same files, compiled a second time with other numbers under the
//! names `Real` and `Vec3`. For studies of accuracy; [`truth`](crate::truth) is apart from both.
#![expect(clippy::duplicate_mod, reason = "the same operations in f64, and no second source")]

#[path = "ball.rs"]
mod ball;
#[path = "flat.rs"]
mod flat;
#[path = "path.rs"]
pub mod path;
#[path = "power.rs"]
mod power;
#[path = "render.rs"]
mod render;
#[path = "textbook.rs"]
mod textbook;
#[path = "trace.rs"]
pub mod trace;

pub use power::power;
pub use render::render;

/// What the recursion's numbers are here.
mod real {
    pub(crate) use std::f64::consts;

    pub(crate) use glam::DVec3 as Vec3;

    pub(crate) type Real = f64;
    pub(crate) type Bits = u64;
}
