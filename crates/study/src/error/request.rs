//! What is asked of the study.

use crate::subject::Subject;
use crate::timing::Repeat;
use crate::tracer::{Threads, Tracer};

/// What is measured.
pub struct Request<'a> {
    /// Scenes, in order.
    pub subjects: &'a [Subject],
    /// Who traces.
    pub tracer: Tracer,
    /// Pools; the largest one makes truth.
    pub threads: &'a Threads,
    /// Number of threads each setting is timed on; one of the pools has that many.
    pub timed_on: usize,
    /// How often each setting is timed.
    pub repeat: Repeat,
    /// An RMSE for which the cheapest setting is found and named.
    pub target: Option<f64>,
}
