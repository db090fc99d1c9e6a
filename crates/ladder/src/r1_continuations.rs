//! Rung 1, continuation-passing style: what is to be done with the colour is an argument.
//!
//! Nothing happens any more after a call returns: every call is the last thing its caller
//! does. Rust promises no tail calls, and each continuation lives in the frame that made it,
//! so the native stack still grows, and faster.

use glam::Vec3;

use crate::{Flight, Step, Walk, Watch};

/// What is still to be done with the colour of a ray; answers with the eye ray's colour.
type Then<'t, W> = &'t dyn Fn(&mut Walk<W>, Vec3) -> Vec3;

/// The light that comes back along the eye ray.
pub(crate) fn trace<W: Watch>(walk: &mut Walk<W>, eye: Flight) -> Vec3 {
    trace_then(walk, eye, &|_, colour| colour)
}

/// Hands the light that comes back along a ray to `then`.
fn trace_then<W: Watch>(walk: &mut Walk<W>, flight: Flight, then: Then<W>) -> Vec3 {
    match walk.step(flight) {
        Step::Ends(colour) => then(walk, colour),
        Step::Mirrors(bounce, next) => trace_then(walk, next, &|walk, back| {
            let colour = walk.fold(flight.depth, bounce, back);
            then(walk, colour)
        }),
    }
}
