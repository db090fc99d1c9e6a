//! Stub: the packet engine's interface.
mod isa;
mod render;
pub use isa::Isa;
pub use render::{Settings, StackFull, render};
