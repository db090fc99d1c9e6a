//! The recursion over mirrors. It stands here once and is compiled twice, in f32 and in f64: `real`
//! is what its numbers are, and comes from whoever mounts this folder.

use super::real;

mod general_sphere;
pub mod path;
mod power;
pub mod ray;
mod render;
mod robust_sphere;
mod shape;
mod textbook;
pub mod trace;

pub use power::power;
pub use render::render;
