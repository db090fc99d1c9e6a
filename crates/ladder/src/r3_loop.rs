//! Rung 3, a loop and a stack: each of rung 2's two functions called only itself last, so
//! each becomes a loop; its list of frames, where only the newest is ever touched, becomes an
//! array.
//!
//! The native stack no longer grows. This rung is also the oracle where paths are too deep for
//! the recursion.

use glam::Vec3;

use crate::{Flight, PendingBounce, Step, Walk, Watch};

/// The light that comes back along the eye ray.
pub(crate) fn trace<W: Watch>(walk: &mut Walk<W>, eye: Flight) -> Vec3 {
    // Entry d: what the mirror at depth d owes.
    let mut stack: Vec<PendingBounce> = Vec::new();

    // Down: every mirror leaves behind what it owes.
    let mut flight = eye;
    let mut colour = loop {
        match walk.step(flight) {
            Step::Ends(colour) => break colour,
            Step::Mirrors(bounce, next) => {
                stack.push(bounce);
                flight = next;
            }
        }
    };

    // Up: folded back from the deepest.
    let mut depth = flight.depth;
    while let Some(bounce) = stack.pop() {
        depth -= 1;
        colour = walk.fold(depth, bounce, colour);
    }
    colour
}
