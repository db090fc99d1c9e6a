//! The stack: what every level of a tile still owes, and what was counted there.
//!
//! A mirror has one child, so each eye ray's stack is a chain, and the rays in flight (origin,
//! direction, weight) are held once, in the waves. A level below them keeps of each ray only
//! what it needs when a colour comes back: the colour so far, and what the level above takes of
//! it, k, for which ray. That is 20 bytes a ray and level in f32.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

use catoptric_scene::{Counts, DepthCount};

use crate::lanes::{LANES, Lane, Lanes};
use crate::vec3::{Packed, Vec3};
use crate::wave::{PACKETS, Slot};

/// Bytes of a stack that a ray takes at each level, in f32.
pub const RAY_LEVEL_BYTES: usize = size_of::<Pending<f32>>() / LANES;

/// Eight rays whose colour is not yet complete.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct Pending<S> {
    /// Local light, or the background; complete once all deeper levels are folded back.
    pub(crate) colour: Packed<S>,
    /// How much of it goes back to the level above.
    pub(crate) k: [S; LANES],
    /// To which rays of that level.
    pub(crate) parents: [Slot; LANES],
    /// The parents are a packet, lane by lane.
    pub(crate) side_by_side: bool,
    pub(crate) live: u32,
}

impl<S: Lane> Pending<S> {
    pub(crate) const EMPTY: Self = Self {
        colour: [[S::ZERO; LANES]; 3],
        k: [S::ZERO; LANES],
        parents: [0; LANES],
        side_by_side: false,
        live: 0,
    };
}

/// The stack of one thread. It grows as rays go deep and is kept between tiles.
pub(crate) struct Stack<'a, S: Lane> {
    /// All levels down to the one in flight, one after another.
    packets: Vec<Pending<S>>,
    /// How many packets that is.
    len: usize,
    levels: Vec<Level>,
    depth: usize,
    budget: &'a Budget,
    granted: usize,
}

#[derive(Clone, Copy, Default)]
struct Level {
    /// Its first packet.
    start: usize,
    count: DepthCount,
}

/// Bytes that the stacks of all threads may take.
pub(crate) struct Budget {
    pub(crate) limit: usize,
    taken: AtomicUsize,
    /// Some stack was refused what it asked for: the picture will not be whole.
    refused: AtomicBool,
}

impl Budget {
    pub(crate) fn new(limit: usize) -> Self {
        Self { limit, taken: AtomicUsize::new(0), refused: AtomicBool::new(false) }
    }

    /// Whether some stack could not grow: the rendering ends, in every thread.
    #[inline(always)]
    pub(crate) fn is_refused(&self) -> bool {
        self.refused.load(Ordering::Relaxed)
    }

    /// Takes bytes if the limit allows it.
    fn take(&self, bytes: usize) -> bool {
        let within = |taken: usize| taken.checked_add(bytes).filter(|&sum| sum <= self.limit);
        self.taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, within).is_ok()
    }

    fn give_back(&self, bytes: usize) {
        self.taken.fetch_sub(bytes, Ordering::Relaxed);
    }
}

impl<'a, S: Lane> Stack<'a, S> {
    /// Levels of a new stack.
    const FIRST: usize = 32;

    /// An empty stack. Its first levels, each of a whole tile, are always granted.
    pub(crate) fn new(budget: &'a Budget) -> Self {
        Self {
            packets: vec![Pending::EMPTY; Self::FIRST * PACKETS],
            len: 0,
            levels: vec![Level::default(); Self::FIRST],
            depth: 0,
            budget,
            granted: 0,
        }
    }

    /// Whether some thread's stack was refused more, so that nothing further is of use.
    #[inline(always)]
    pub(crate) fn is_refused(&self) -> bool {
        self.budget.is_refused()
    }

    /// Makes room for a level of at most so many packets below the one in flight; false if the
    /// limit forbids it.
    #[inline(always)]
    pub(crate) fn make_room(&mut self, packets: usize) -> bool {
        (self.len + packets <= self.packets.len() && self.depth + 1 < self.levels.len())
            || self.grow(packets)
    }

    /// Adds a quarter to what is full, unless this stack or another was refused more. Out of
    /// line: it holds no lanes.
    #[cold]
    #[inline(never)]
    fn grow(&mut self, packets: usize) -> bool {
        let full = self.len + packets > self.packets.len();
        let more_packets = if full { self.packets.len() / 4 } else { 0 };
        let full = self.depth + 1 >= self.levels.len();
        let more_levels = if full { self.levels.len() / 4 } else { 0 };
        let bytes = more_packets * size_of::<Pending<S>>() + more_levels * size_of::<Level>();
        let granted = !self.budget.is_refused() && self.budget.take(bytes);
        if granted {
            self.granted += bytes;
        }
        let grown = granted
            && self.packets.try_reserve_exact(more_packets).is_ok()
            && self.levels.try_reserve_exact(more_levels).is_ok();
        if grown {
            self.packets.resize(self.packets.len() + more_packets, Pending::EMPTY);
            self.levels.resize(self.levels.len() + more_levels, Level::default());
        } else {
            self.budget.refused.store(true, Ordering::Relaxed);
        }
        grown
    }

    /// Puts a level of so many eye rays' packets in place of all there is.
    #[inline(always)]
    pub(crate) fn start(&mut self, packets: usize) -> &mut DepthCount {
        self.len = packets;
        self.depth = 0;
        self.count()
    }

    #[inline(always)]
    pub(crate) fn depth(&self) -> usize {
        self.depth
    }

    /// The counters of the level in flight.
    #[inline(always)]
    pub(crate) fn count(&mut self) -> &mut DepthCount {
        &mut self.levels[self.depth].count
    }

    /// The level in flight, and room for the next.
    #[inline(always)]
    pub(crate) fn level_and_next(&mut self) -> (&mut [Pending<S>], &mut [Pending<S>]) {
        let (levels, next) = self.packets.split_at_mut(self.len);
        (&mut levels[self.levels[self.depth].start..], next)
    }

    /// The level in flight.
    #[inline(always)]
    pub(crate) fn level(&self) -> &[Pending<S>] {
        &self.packets[self.levels[self.depth].start..self.len]
    }

    /// The level above the one in flight.
    #[inline(always)]
    pub(crate) fn level_above(&self) -> &[Pending<S>] {
        let above = self.levels[self.depth - 1].start;
        &self.packets[above..self.levels[self.depth].start]
    }

    /// Room for the next level.
    #[inline(always)]
    pub(crate) fn next(&self) -> &[Pending<S>] {
        &self.packets[self.len..]
    }

    /// The next level, of so many packets, is in flight.
    #[inline(always)]
    pub(crate) fn descend(&mut self, packets: usize) {
        self.depth += 1;
        self.levels[self.depth].start = self.len;
        self.len += packets;
    }

    /// Folds the level in flight back: colour = local + k · what comes back, as the recursion
    /// forms it. The level above is then the one in flight.
    #[inline(always)]
    pub(crate) fn fold<L: Lanes<Scalar = S>>(&mut self) {
        let start = self.levels[self.depth].start;
        self.depth -= 1;
        let (levels, level) = self.packets[..self.len].split_at_mut(start);
        let parents = &mut levels[self.levels[self.depth].start..];
        for pending in &*level {
            let (back, k) = (Vec3::<L>::from_arrays(&pending.colour), L::from_array(pending.k));
            if pending.side_by_side {
                let colour = &mut parents[pending.parents[0] as usize / LANES].colour;
                *colour = fold(Vec3::from_arrays(colour), k, back).to_arrays();
                continue;
            }
            let places = &pending.parents[..LANES.min(pending.live as usize)];
            let mut local = [[S::ZERO; LANES]; 3];
            for (lane, &slot) in places.iter().enumerate() {
                let parent = &parents[slot as usize / LANES].colour;
                for axis in 0..3 {
                    local[axis][lane] = parent[axis][slot as usize % LANES];
                }
            }
            let colour = fold(Vec3::from_arrays(&local), k, back).to_arrays();
            for (lane, &slot) in places.iter().enumerate() {
                let parent = &mut parents[slot as usize / LANES].colour;
                for axis in 0..3 {
                    parent[axis][slot as usize % LANES] = colour[axis][lane];
                }
            }
        }
        self.len = start;
    }

    /// Adds what this stack counted and counts from 0 again.
    pub(crate) fn take_counts(&mut self) -> Counts {
        let used = self.levels.iter().rposition(|l| l.count.rays > 0).map_or(0, |last| last + 1);
        let take = |level: &mut Level| std::mem::take(&mut level.count);
        Counts { depths: self.levels[..used].iter_mut().map(take).collect() }
    }
}

/// The colour of a ray whose mirrored ray came back.
#[inline(always)]
fn fold<L: Lanes>(local: Vec3<L>, k: L, back: Vec3<L>) -> Vec3<L> {
    local + back * k
}

impl<S: Lane> Drop for Stack<'_, S> {
    fn drop(&mut self) {
        self.budget.give_back(self.granted);
    }
}
