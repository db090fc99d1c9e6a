//! Studies: what accuracy costs, what depth costs, where the numerics hold.
//!
//! A study is a sweep plus a caption: it measures rows and says what they show. All studies
//! fill the same [`catoptric_report::Report`], which takes every format there.
//!
//! ```text
//! metrics.rs      how far one picture is from another
//! subject.rs      scenes that a study is made of
//! tracer.rs       who traces, on how many threads
//! way.rs          ways to trace a picture: renderers and rungs
//! timing.rs       how long it takes, in turn
//! checked.rs      pictures are compared before their making is timed
//! formula.rs      which formulas, in which precision
//! omissions.rs    what each omission of a plan saves
//! light.rs        how much light a scene can hold
//! depth.rs        cost against depth
//!   depth/          its rows and plots, the rays of each depth, where the speed comes from
//! ladder.rs       what each step from the recursion to the engine costs and buys
//! error.rs        error against run time
//!   error/          its rows and sweeps, truth, the settings that are worth their time
//! stability.rs    stiff and extreme cases against truth
//!   stability/      its cases and its measures
//! ```

pub mod checked;
pub mod depth;
pub mod error;
pub mod formula;
pub mod ladder;
pub mod light;
pub mod metrics;
pub mod omissions;
pub mod stability;
pub mod subject;
pub mod timing;
pub mod tracer;
pub mod way;

/// What a study needs of the program that runs it.
pub trait Watch: Sync {
    /// Whether to stop after the measurement at hand; what was measured so far is kept.
    fn stopped(&self) -> bool;

    /// A line for people who wait: what is measured now.
    fn say(&self, line: &str);
}

/// Nobody waits and nobody stops it.
pub struct Unwatched;

impl Watch for Unwatched {
    fn stopped(&self) -> bool {
        false
    }

    fn say(&self, _: &str) {}
}
