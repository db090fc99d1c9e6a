//! The rays of one bounce of a tile, packed: those that go on leave no gaps.
//!
//! Eight rays that met one primitive go on together, as a packet. Rays that go on alone are put
//! together to eights before they come here, whichever primitives they left. So only the last
//! packet of a queue of reflected rays has lanes without a ray, its last ones.
//!
//! A queue has at most as many rays as the one above it, and all its packets but the last are
//! full: so it never holds more than [`PACKETS`].

use std::ops::Range;

use super::column::{Column, PACKETS, Vec3Column};
use super::rays::{NONE, Rays};
use crate::simd::{LANES, Lane, Lanes, Vec3};

/// The last bounce at which the rays of a tile go side by side.
pub(crate) const BREADTH: usize = 1024;

/// Queues of a thread: one for eye rays, two for odd and even bounces, one for bounce [`BREADTH`].
pub(crate) const QUEUES: usize = 4;

/// Index of the queue that holds the rays of a bounce.
#[inline(always)]
pub(crate) fn queue_of(bounce: usize) -> usize {
    match bounce {
        0 => 0,
        BREADTH => 3,
        _ => 1 + bounce % 2,
    }
}

/// Packets one after another, all of whose rays left one primitive.
#[derive(Clone, Copy)]
pub(crate) struct Run {
    /// The primitive, or [`NONE`] where not all of a packet left one.
    pub(crate) from: u32,
    /// The first packet after them.
    pub(crate) end: u32,
}

/// Rays of a tile at one bounce.
pub(crate) struct RayQueue<S> {
    origins: Vec3Column<S>,
    directions: Vec3Column<S>,
    /// How many lanes of each packet hold rays, the first ones; the others hold the first ray
    /// again.
    live: [u8; PACKETS],
    /// Runs of reflected rays. Each holds a packet at least, so there are no more than packets, and
    /// an index taken modulo [`PACKETS`] is itself while the queue is filled.
    runs: [Run; PACKETS],
    runs_len: usize,
    /// What the packets after the last run left.
    from_last: u32,
    /// Index of the primitive that each ray left, which is not met again, or all ones. Kept only
    /// where the run does not say it.
    from: Column<S>,
    /// Cumulative weights; kept only where there is a cut by weight.
    weights: Column<S>,
    len: usize,
}

/// Eight rays that leave a surface.
pub(crate) struct Departing<L> {
    pub(crate) rays: Rays<L>,
    /// `None` without a cut by weight.
    pub(crate) weight: Option<L>,
    /// The primitive that all of them left, or [`NONE`].
    pub(crate) from: u32,
}

impl<S: Lane> RayQueue<S> {
    pub(crate) fn new() -> Self {
        Self {
            origins: Vec3Column::zero(),
            directions: Vec3Column::zero(),
            live: [0; PACKETS],
            runs: [Run { from: NONE, end: 0 }; PACKETS],
            runs_len: 0,
            from_last: NONE,
            from: Column::of(S::ZERO),
            weights: Column::of(S::rounded(1.0)),
            len: 0,
        }
    }

    /// Packets that it holds.
    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    /// Lanes of a packet that hold rays, the first ones.
    #[inline(always)]
    pub(crate) fn live(&self, packet: usize) -> u32 {
        self.live[packet % PACKETS].into()
    }

    /// Rays of some packets.
    #[inline(always)]
    pub(crate) fn count(&self, packets: Range<usize>) -> u64 {
        self.live[packets].iter().map(|&live| u64::from(live)).sum()
    }

    #[inline(always)]
    pub(crate) fn runs(&self) -> &[Run] {
        &self.runs[..self.runs_len]
    }

    #[inline(always)]
    pub(crate) fn origins(&self) -> &Vec3Column<S> {
        &self.origins
    }

    #[inline(always)]
    pub(crate) fn directions(&self) -> &Vec3Column<S> {
        &self.directions
    }

    #[inline(always)]
    pub(crate) fn rays<L: Lanes<Scalar = S>>(&self, packet: usize) -> Rays<L> {
        Rays { origin: self.origins.packet(packet), direction: self.directions.packet(packet) }
    }

    /// The rays of eight slots.
    #[inline(always)]
    pub(crate) fn gather<L: Lanes<Scalar = S>>(
        &self,
        slots: impl Fn(usize) -> usize + Copy,
    ) -> Rays<L> {
        let (origin, direction) = (self.origins.gather(slots), self.directions.gather(slots));
        Rays { origin, direction }
    }

    /// Origin and direction of a ray.
    pub(crate) fn ray(&self, slot: usize) -> ([S; 3], [S; 3]) {
        (self.origins.ray(slot), self.directions.ray(slot))
    }

    /// Indices of the primitives that rays left, in packets of runs from [`NONE`].
    #[inline(always)]
    pub(crate) fn from(&self) -> &Column<S> {
        &self.from
    }

    #[inline(always)]
    pub(crate) fn weights(&self) -> &Column<S> {
        &self.weights
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.len = 0;
        self.runs_len = 0;
    }

    /// Counts a packet that was written at the end.
    #[inline(always)]
    fn add(&mut self, from: u32, live: usize) {
        debug_assert!(self.len < PACKETS);
        if from != self.from_last {
            self.end_run();
            self.from_last = from;
        }
        self.live[self.len % PACKETS] = live as u8;
        self.len += 1;
    }

    /// Ends the run of the packets so far, if there are any.
    #[inline(always)]
    pub(crate) fn end_run(&mut self) {
        self.runs[self.runs_len % PACKETS] = Run { from: self.from_last, end: self.len as u32 };
        self.runs_len += usize::from(self.len > 0);
    }

    /// Puts a packet of eye rays in its place, in a queue that holds no others: weights stay 1. The
    /// queue has them once [`RayQueue::end_eye_rays`] says how many they are.
    #[inline(always)]
    pub(crate) fn put_eye_rays<L: Lanes<Scalar = S>>(
        &mut self,
        packet: usize,
        direction: Vec3<L>,
        live: usize,
    ) {
        debug_assert!(packet < PACKETS);
        self.directions.put(packet, direction);
        self.live[packet % PACKETS] = live as u8;
    }

    /// Ends a queue of so many packets of eye rays.
    #[inline(always)]
    pub(crate) fn end_eye_rays(&mut self, packets: usize) {
        self.clear();
        self.len = packets;
    }

    /// Adds a packet of eight rays that left one primitive, or none that counts.
    #[inline(always)]
    pub(crate) fn push<L: Lanes<Scalar = S>>(&mut self, departing: &Departing<L>) {
        self.origins.put(self.len, departing.rays.origin);
        self.directions.put(self.len, departing.rays.direction);
        if departing.from == NONE {
            self.from.put(self.len, L::index(NONE));
        }
        if let Some(weight) = departing.weight {
            self.weights.put(self.len, weight);
        }
        self.add(departing.from, LANES);
    }

    /// Adds a packet of `live` rays that left the primitives `from`.
    #[inline(always)]
    pub(crate) fn push_mixed<L: Lanes<Scalar = S>>(
        &mut self,
        rays: &Rays<L>,
        weight: L,
        from: L,
        live: usize,
    ) {
        self.origins.put(self.len, rays.origin);
        self.directions.put(self.len, rays.direction);
        self.from.put(self.len, from);
        self.weights.put(self.len, weight);
        self.add(NONE, live);
    }
}

#[cfg(test)]
mod tests;
