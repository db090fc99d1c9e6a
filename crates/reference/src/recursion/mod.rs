//! The recursion over mirrors, written once and compiled twice, in f32 and in f64: the module that
//! mounts this folder gives the numbers as `real`.

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
