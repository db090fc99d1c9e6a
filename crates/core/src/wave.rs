//! The rays of one level of a tile, packed: those that go on leave no gaps.
//!
//! Eight rays that met one primitive go on together, as a packet. Rays that go on alone wait until
//! they are eight, whichever primitives they left. So only the last packet of a wave of mirrored
//! rays has lanes without a ray, its last ones.
//!
//! A wave has at most as many rays as the one above it, and all its packets but the last are
//! full: so it never holds more than [`PACKETS`].

use std::ops::Range;

use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::packet::{NONE, Rays};
use crate::plane::{PACKETS, Plane, Vectors};
use crate::stack::{Owed, Stack};
use crate::vec3::{Packed, Vec3};

/// Packets one after another, all of whose rays left one primitive.
#[derive(Clone, Copy)]
pub(crate) struct Run {
    /// The primitive, or [`NONE`] where not all of a packet left one.
    pub(crate) left: u32,
    /// The first packet after them.
    pub(crate) end: u32,
}

/// Rays of a tile at one level.
pub(crate) struct Wave<S> {
    origins: Vectors<S>,
    directions: Vectors<S>,
    /// How many lanes of each packet hold rays, the first ones; the others hold the first ray again.
    live: [u8; PACKETS],
    /// Runs of mirrored rays. Each holds a packet at least, so there are no more than packets, and an
    /// index taken modulo [`PACKETS`] is itself while the wave is filled.
    runs: [Run; PACKETS],
    runs_len: usize,
    /// What the packets after the last run left.
    left_last: u32,
    /// Index of the primitive that each ray left, which is not met again, or all ones. Kept only
    /// where the run does not say it.
    left: Plane<S>,
    /// Cumulative weights; kept only where there is a cut by weight.
    weights: Plane<S>,
    len: usize,
    waiting: Waiting<S>,
}

/// Rays that do not yet fill a packet, and what they owe.
struct Waiting<S> {
    origin: Packed<S>,
    direction: Packed<S>,
    left: [S; LANES],
    weight: [S; LANES],
    local: Packed<S>,
    owed: [Owed; LANES],
    live: usize,
}

/// Mirrored rays that leave one primitive.
pub(crate) struct Mirrored<L: Lanes> {
    pub(crate) rays: Rays<L>,
    /// `None` without a cut by weight.
    pub(crate) weight: Option<L>,
    pub(crate) left: u32,
}

impl<S: Lane> Wave<S> {
    pub(crate) fn new() -> Self {
        Self {
            origins: Vectors::zero(),
            directions: Vectors::zero(),
            live: [0; PACKETS],
            runs: [Run { left: NONE, end: 0 }; PACKETS],
            runs_len: 0,
            left_last: NONE,
            left: Plane::of(S::ZERO),
            weights: Plane::of(S::rounded(1.0)),
            len: 0,
            waiting: Waiting {
                origin: [[S::ZERO; LANES]; 3],
                direction: [[S::ZERO; LANES]; 3],
                left: [S::ZERO; LANES],
                weight: [S::ZERO; LANES],
                local: [[S::ZERO; LANES]; 3],
                owed: [Owed::NOTHING; LANES],
                live: 0,
            },
        }
    }

    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.len
    }

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
    pub(crate) fn origins(&self) -> &Vectors<S> {
        &self.origins
    }

    #[inline(always)]
    pub(crate) fn directions(&self) -> &Vectors<S> {
        &self.directions
    }

    #[inline(always)]
    pub(crate) fn rays<L: Lanes<Scalar = S>>(&self, packet: usize) -> Rays<L> {
        Rays { origin: self.origins.packet(packet), direction: self.directions.packet(packet) }
    }

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

    #[inline(always)]
    pub(crate) fn left(&self) -> &Plane<S> {
        &self.left
    }

    #[inline(always)]
    pub(crate) fn weights(&self) -> &Plane<S> {
        &self.weights
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.len = 0;
        self.runs_len = 0;
    }

    /// One packet more.
    #[inline(always)]
    fn add(&mut self, left: u32, live: usize) {
        debug_assert!(self.len < PACKETS);
        if left != self.left_last {
            self.end_run();
            self.left_last = left;
        }
        self.live[self.len % PACKETS] = live as u8;
        self.len += 1;
    }

    /// Ends the run of the packets so far, if there are any.
    #[inline(always)]
    fn end_run(&mut self) {
        self.runs[self.runs_len % PACKETS] = Run { left: self.left_last, end: self.len as u32 };
        self.runs_len += usize::from(self.len > 0);
    }

    /// Puts a packet of eye rays in its place, in a wave that holds no others: weights stay 1. The
    /// wave has them once [`Wave::has_eye`] says how many they are.
    #[inline(always)]
    pub(crate) fn put_eye<L: Lanes<Scalar = S>>(
        &mut self,
        packet: usize,
        direction: Vec3<L>,
        live: usize,
    ) {
        debug_assert!(packet < PACKETS);
        self.directions.put(packet, direction);
        self.live[packet % PACKETS] = live as u8;
    }

    /// Ends a wave of so many packets of eye rays.
    #[inline(always)]
    pub(crate) fn has_eye(&mut self, packets: usize) {
        self.clear();
        self.len = packets;
    }

    /// Eight rays.
    #[inline(always)]
    pub(crate) fn push<L: Lanes<Scalar = S>>(&mut self, mirrored: &Mirrored<L>) {
        self.origins.put(self.len, mirrored.rays.origin);
        self.directions.put(self.len, mirrored.rays.direction);
        if mirrored.left == NONE {
            self.left.put(self.len, L::index(NONE));
        }
        if let Some(weight) = mirrored.weight {
            self.weights.put(self.len, weight);
        }
        self.add(mirrored.left, LANES);
    }

    /// Those of eight rays that go on, and what they owe.
    #[inline(always)]
    pub(crate) fn push_lanes<L: Lanes<Scalar = S>>(
        &mut self,
        mirrored: &Mirrored<L>,
        goes_on: Mask<L>,
        local: &Packed<S>,
        owed: &[Owed; LANES],
        stack: &mut Stack<S>,
    ) {
        let Rays { origin, direction } = mirrored.rays;
        let (origin, direction) = (origin.to_arrays(), direction.to_arrays());
        #[expect(clippy::manual_map, reason = "a closure may be left as a call in the kernel")]
        let weight = match mirrored.weight {
            Some(weight) => Some(weight.to_array()),
            None => None,
        };
        let mut lanes = goes_on.bits();
        while lanes != 0 {
            let from = lanes.trailing_zeros() as usize % LANES;
            lanes &= lanes - 1;
            let to = self.waiting.live % LANES;
            for axis in 0..3 {
                self.waiting.origin[axis][to] = origin[axis][from];
                self.waiting.direction[axis][to] = direction[axis][from];
                self.waiting.local[axis][to] = local[axis][from];
            }
            self.waiting.left[to] = S::from_index(mirrored.left);
            if let Some(weight) = &weight {
                self.waiting.weight[to] = weight[from];
            }
            self.waiting.owed[to] = owed[from];
            self.waiting.live += 1;
            if self.waiting.live == LANES {
                self.push_waiting::<L>(stack);
            }
        }
    }

    /// Ends the level: rays wait no longer.
    #[inline(always)]
    pub(crate) fn close<L: Lanes<Scalar = S>>(&mut self, stack: &mut Stack<S>) {
        if self.waiting.live > 0 {
            self.push_waiting::<L>(stack);
        }
        self.end_run();
    }

    #[inline(always)]
    fn push_waiting<L: Lanes<Scalar = S>>(&mut self, stack: &mut Stack<S>) {
        let Waiting { origin, direction, left, weight, local, owed, live } = &mut self.waiting;
        for lane in *live..LANES {
            for axis in 0..3 {
                origin[axis][lane] = origin[axis][0];
                direction[axis][lane] = direction[axis][0];
                local[axis][lane] = local[axis][0];
            }
            (left[lane], weight[lane], owed[lane]) = (left[0], weight[0], owed[0]);
        }
        self.origins.put(self.len, Vec3::<L>::from_arrays(origin));
        self.directions.put(self.len, Vec3::<L>::from_arrays(direction));
        self.left.put(self.len, L::from_array(*left));
        self.weights.put(self.len, L::from_array(*weight));
        stack.push(Vec3::<L>::from_arrays(local), owed, 0);
        let live = std::mem::take(live);
        self.add(NONE, live);
    }
}
