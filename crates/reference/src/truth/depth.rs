//! The deepest path of truth, and the stack that it takes.

/// The deepest reflection that [`Truth`](super::Truth) follows. A scene's `max_depth` may be
/// larger; only a path that needs more fails.
pub const DEPTH_ALLOWED: u32 = 100_000;

/// Stack bytes that one reflection takes at most. Measured on x86-64 in double-double: 496
/// in release, 544 in this workspace's dev profile, 1184 without any optimisation; in f64
/// 320, 304 and 752.
pub const STACK_PER_LEVEL: usize = 1536;

/// Stack bytes with which a thread can follow [`DEPTH_ALLOWED`] reflections.
///
/// Truth recurses on the thread that calls it, and [`Truth::render`](super::Truth::render) on the
/// threads of rayon's current pool. An ordinary thread of 2 MiB is good for about 1 300 levels; a
/// caller that lets paths go deeper starts its threads with this much. Only the pages that
/// a path reaches are taken.
pub const STACK_BYTES: usize = DEPTH_ALLOWED as usize * STACK_PER_LEVEL + (1 << 20);

/// A path needs more reflections than the native stack is sized for.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a path reflects more than {allowed} times, which is as deep as the recursion goes: lower max_depth, raise min_weight, or use the packet engine"
)]
pub struct TooDeep {
    /// The deepest reflection followed.
    pub allowed: u32,
}
