//! Tracing a tile: the packet loop and all that it calls, top-down.
//!
//! `wavefront` is the loop; then what it calls, in that order: `nearest`, `shade` with
//! `hit_groups`, `light` and `shadow`, `regroup`, `stack`. `frame` is what it reads, `scratch` what
//! it keeps.

mod across;
mod budget;
mod frame;
mod hit_groups;
mod light;
mod nearest;
mod observe;
mod output;
mod pending;
mod points;
mod regroup;
mod scratch;
mod shade;
mod shadow;
mod stack;
mod tile;
mod wavefront;

pub(crate) use budget::Budget;
pub(crate) use frame::Frame;
pub(crate) use observe::Observe;
pub(crate) use output::{Linear, Output, Put};
pub use pending::RAY_BOUNCE_BYTES;
pub(crate) use scratch::Scratch;
pub(crate) use stack::{Stack, TooDeep};
pub(crate) use tile::Tile;
