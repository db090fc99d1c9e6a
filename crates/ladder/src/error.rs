//! How deep rungs go, and what they refuse.

use catoptric_core::StackFull;

/// The deepest path of rungs with a stack of their own.
pub const DEEPEST: u32 = 1_000_000;

/// A path went deeper than a rung allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// More reflections than a rung's stack holds.
    #[error("a path has more than {deepest} reflections, which this rung's stack does not hold")]
    TooDeep {
        /// Reflections that are allowed.
        deepest: u32,
    },
    /// The engine's stacks would pass its limit.
    #[error(transparent)]
    StackFull(#[from] StackFull),
}
