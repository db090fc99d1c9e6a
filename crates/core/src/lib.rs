//! The packet engine: eight rays at a time, no recursion, the recursion's bits; in f32, or in
//! f64.
//!
//! Folders, from the top down; each sees those below it alone:
//!
//! - [`Engine`] and `bands`: tiles on threads; [`Plan`]: what is left out; [`watch`] and `survey`:
//!   what those who study the engine ask of it.
//! - `trace`: the packet loop, shading, shadows and the stack. Start with `trace/wavefront.rs`.
//! - `cull`: bounds on what a tile's eye rays and shadow rays can meet.
//! - `shape`: where rays meet a sphere or a plane.
//! - `ray`: rays in columns, queues and compaction.
//! - `simd`: eight lanes on every instruction set; the only folder with intrinsics and unsafe code.

mod bands;
mod cull;
mod engine;
mod omission;
mod plan;
mod ray;
mod settings;
mod shape;
mod simd;
mod survey;
mod trace;
pub mod watch;

pub use cull::cone_bytes;
pub use engine::{Engine, Levels, PacketScalar, Target};
pub use omission::{Omission, Omissions};
pub use plan::{Features, Plan};
pub use settings::{Settings, StackFull};
pub use simd::Isa;
pub use survey::{TileCandidates, occluders, tile_candidates};
pub use trace::RAY_BOUNCE_BYTES;
