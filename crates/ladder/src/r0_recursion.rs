//! Rung 0, the recursion: colour = local + k · trace(mirrored ray).
//!
//! The picture is the reference's own (`reference::trace`). The recursion stands here once more,
//! in the two operations that all rungs share, so that its events can be seen.

use glam::Vec3;

use crate::{Flight, Step, Walk, Watch};

/// The light that comes back along a ray.
pub(crate) fn trace<W: Watch>(walk: &mut Walk<W>, flight: Flight) -> Vec3 {
    match walk.step(flight) {
        Step::Ends(colour) => colour,
        Step::Mirrors(bounce, next) => {
            let back = trace(walk, next);
            walk.fold(flight.depth, bounce, back)
        }
    }
}
