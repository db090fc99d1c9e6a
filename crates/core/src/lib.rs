//! The packet engine: eight rays at a time, no recursion, the recursion's bits.
//!
//! Start with `packet`, the loop; then `shade`, then the shapes, which stand here under the
//! same names as in the reference. `lanes` is the only file that knows what eight lanes are
//! made of.

mod ball;
mod flat;
mod isa;
mod lanes;
mod packet;
mod power;
mod render;
mod shade;
mod sight;
mod stack;
mod textbook;
mod tile;
mod vec3;

pub use isa::Isa;
pub use render::{Settings, StackFull, render, render_levels};
