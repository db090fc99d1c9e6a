//! Depth that rungs allow, and errors past it.

use catoptric_core::StackFull;

/// The deepest path of rungs with a stack of their own.
pub const DEEPEST: u32 = 1_000_000;

/// Failure of a rung: a path went deeper than it allows.
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
