//! The deepest path of the recursion, and the stack that it takes.

/// The deepest path that the recursion follows.
pub const DEPTH_ALLOWED: u32 = 100_000;

/// Stack bytes that a thread needs for a path of [`DEPTH_ALLOWED`] reflections: one frame a mirror,
/// with room for the larger frames of a debug build.
pub const STACK_BYTES: usize = 256 << 20;

/// A path that would have overflowed the stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a path has more than {} reflections, which the recursion's stack does not hold",
    DEPTH_ALLOWED
)]
pub struct TooDeep;
