//! What is asked of the study.

use catoptric_core::Isa;

use crate::subject::Subject;
use crate::timing::Repeat;
use crate::tracer::Threads;

/// What is measured.
pub struct Request<'a> {
    /// Scenes, in order.
    pub subjects: &'a [Subject],
    /// A pool of one thread.
    pub threads: &'a Threads,
    /// How often each rung is timed.
    pub repeat: Repeat,
    /// The engine's instruction set.
    pub isa: Isa,
}
