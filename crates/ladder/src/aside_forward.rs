//! Aside, forward accumulation: NOT bit-identical.
//!
//! The sum is carried along, so nothing is owed and there is no stack at all: the
//! tail-recursive form, which most renderers use. The weights, w = k0 · k1 · ..., are distributed
//! over the sum: local0 + k0 · (local1 + k1 · ...) = local0 + w1 · local1 + ... holds in the reals;
//! in floats it rounds elsewhere.

use glam::Vec3;

use crate::{Flight, Step, Walk, Watch};

/// The light that comes back along the eye ray, up to rounding.
pub(crate) fn trace<W: Watch>(walk: &mut Walk<W>, eye: Flight) -> Vec3 {
    let mut flight = eye;
    let mut sum = Vec3::ZERO;
    loop {
        match walk.step(flight) {
            Step::Ends(colour) => return sum + flight.weight * colour,
            Step::Mirrors(bounce, next) => {
                sum += flight.weight * bounce.local;
                flight = next;
            }
        }
    }
}
