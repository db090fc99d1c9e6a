//! What is asked of the study, and what refuses it.

use catoptric_core::Isa;

use crate::checked::Difference;
use crate::subject::Subject;
use crate::timing::Repeat;
use crate::tracer::Threads;
use crate::way::Way;

/// What is measured.
pub struct Request<'a> {
    /// Scenes, in order.
    pub subjects: &'a [Subject],
    /// Values of `max_depth`.
    pub depths: &'a [u32],
    /// Who traces; no two of one name.
    pub ways: &'a [Way],
    /// Numbers of threads to trace on.
    pub threads: &'a Threads,
    /// How often each picture is timed.
    pub repeat: Repeat,
    /// The engine's instruction set.
    pub isa: Isa,
}

/// Two pictures or ray counts that should be the same are not.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{scene} to depth {depth}: {way} on {threads} threads is wrong, {difference}; nothing was timed"
)]
pub struct Mismatch {
    /// The scene's name.
    pub scene: String,
    /// The scene's `max_depth`.
    pub depth: u32,
    /// What traced it.
    pub way: String,
    /// Number of threads that traced.
    pub threads: usize,
    /// What is not the same.
    pub difference: Difference,
}
