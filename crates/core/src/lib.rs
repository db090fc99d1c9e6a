//! The packet engine: eight rays at a time, no recursion, the recursion's bits; in f32, or in
//! f64.
//!
//! Start with `packet`, the loop; then what it calls, in that order: `nearest`, `shade`
//! with `surfaces`, `occluders` and `light`, `wave`, `stack`; then the shapes, which stand here under the
//! same names as in the reference. `plan` says what is left out, `plane` how a wave's numbers lie in
//! memory, `output` what becomes of the colours. `lanes` is the only file that knows what eight
//! lanes are made of.

mod ball;
mod cut;
mod flat;
mod holders;
mod isa;
mod lanes;
mod light;
mod nearest;
mod nested;
mod occluders;
mod output;
mod packet;
mod plan;
mod plane;
mod power;
mod render;
mod shade;
mod sight;
mod singles;
mod stack;
mod surfaces;
mod textbook;
mod tile;
mod vec3;
pub mod watch;
mod wave;

pub use isa::Isa;
pub use occluders::cone_bytes;
pub use plan::{Features, Omission, Plan, TileCandidates, occluders, tile_candidates};
pub use render::{
    PacketScalar, Settings, StackFull, render, render_levels, render_levels_planned, render_planned,
};
pub use stack::RAY_LEVEL_BYTES;
