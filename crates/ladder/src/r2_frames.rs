//! Rung 2, defunctionalised: the two closures of rung 1 become the two cases of a data type,
//! and calling one becomes `pay`.
//!
//! A case is named by what it owes, its fields are what the closure had captured. (Reynolds,
//! Definitional interpreters for higher-order programming languages, 1972; Danvy and Nielsen,
//! Defunctionalization at work, 2001.) The calls are still calls, so the native stack grows.

use glam::Vec3;

use crate::{Flight, PendingBounce, Step, Walk, Watch};

/// What is still owed when the colour of a ray at depth d comes back.
pub(crate) enum Owed {
    /// Nothing is owed by the eye, d = 0: the colour is the answer.
    Nothing,
    /// A fold is owed by the mirror at depth d - 1, and then the rest.
    Fold(PendingBounce, Box<Owed>),
}

/// The light that comes back along the eye ray.
pub(crate) fn trace<W: Watch>(walk: &mut Walk<W>, eye: Flight) -> Vec3 {
    trace_owing(walk, eye, Owed::Nothing)
}

/// Pays what is owed with the light that comes back along a ray.
fn trace_owing<W: Watch>(walk: &mut Walk<W>, flight: Flight, owed: Owed) -> Vec3 {
    match walk.step(flight) {
        Step::Ends(colour) => pay(walk, owed, flight.depth, colour),
        Step::Mirrors(bounce, next) => trace_owing(walk, next, Owed::Fold(bounce, Box::new(owed))),
    }
}

/// Pays what is owed with the colour of a ray at `depth`.
fn pay<W: Watch>(walk: &mut Walk<W>, owed: Owed, depth: u32, colour: Vec3) -> Vec3 {
    match owed {
        Owed::Nothing => colour,
        Owed::Fold(bounce, rest) => {
            let colour = walk.fold(depth - 1, bounce, colour);
            pay(walk, *rest, depth - 1, colour)
        }
    }
}
