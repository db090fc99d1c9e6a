//! The way from the recursion to the engine, one rung at a time, and no bit changes.
//!
//! Read `README.md` beside this crate, then the rungs in order; each is one file. `walk` holds the
//! steps that all rungs share, `event` the events by which they are compared.

mod aside_forward;
mod error;
mod event;
mod native_stack;
mod picture;
mod r0_recursion;
mod r1_continuations;
mod r2_frames;
mod r3_loop;
mod r4_packets;
mod r5_engine;
mod rung;
mod walk;

pub use error::{DEEPEST, Error};
pub use event::{Event, Watch};
pub use native_stack::native_stack;
pub use picture::{render_by, watch_by};
pub use rung::{FORWARD, RUNGS, RenderView, Rung, WatchRay};
pub use walk::{Flight, PendingBounce, Step, Walk};
