//! The stack: what every level still owes, and what was counted there.
//!
//! A mirror has one child, so the stack is a chain: the ray in flight (origin, direction,
//! weight, depth) is held once, in the loop, and a level below it keeps only what it needs
//! when the colour comes back. That is (local colour, k), 16 bytes a ray and level.

use std::sync::atomic::{AtomicUsize, Ordering};

use catoptric_scene::{Counts, DepthCount};

use crate::lanes::{LANES, Lanes};
use crate::vec3::Vec3;

/// A bounce whose colour is not yet complete: colour = local + k · (what comes back).
///
/// Lanes that met nothing hold the background and k = 0; lanes without a ray hold 0 and 0,
/// so that folding them changes nothing.
#[derive(Clone, Copy)]
pub(crate) struct PendingBounce<L> {
    pub(crate) local: Vec3<L>,
    pub(crate) k: L,
}

impl<L: Lanes> PendingBounce<L> {
    /// Nothing owed.
    #[inline(always)]
    pub(crate) fn none() -> Self {
        Self { local: Vec3::zero(), k: L::splat(0.0) }
    }

    /// The colour, once `back` has come back.
    #[inline(always)]
    pub(crate) fn fold(self, back: Vec3<L>) -> Vec3<L> {
        self.local + back * self.k
    }
}

/// A pending bounce in memory: red, green, blue, k; eight lanes each.
#[derive(Clone, Copy)]
#[repr(align(32))]
struct Level([[f32; LANES]; 4]);

/// The stack of one thread. It grows as rays go deep and is kept between packets.
pub(crate) struct Stack<'a> {
    levels: Vec<Level>,
    counts: Vec<DepthCount>,
    depth: usize,
    budget: &'a Budget,
}

/// Bytes that the stacks of all threads may take.
pub(crate) struct Budget {
    pub(crate) limit: usize,
    taken: AtomicUsize,
}

impl Budget {
    pub(crate) fn new(limit: usize) -> Self {
        Self { limit, taken: AtomicUsize::new(0) }
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

impl<'a> Stack<'a> {
    /// What one level takes, its counter included.
    const LEVEL_BYTES: usize = size_of::<Level>() + size_of::<DepthCount>();

    /// Levels of a new stack.
    const FIRST: usize = 32;

    /// An empty stack. Its first levels are always granted.
    pub(crate) fn new(budget: &'a Budget) -> Self {
        Self {
            levels: vec![Level([[0.0; LANES]; 4]); Self::FIRST],
            counts: vec![DepthCount::default(); Self::FIRST],
            depth: 0,
            budget,
        }
    }

    /// Makes room for the level of the ray in flight; false if the limit forbids it.
    #[inline(always)]
    pub(crate) fn make_room(&mut self) -> bool {
        self.depth < self.levels.len() || self.grow()
    }

    /// Doubles the stack. Out of line: it holds no lanes.
    #[cold]
    #[inline(never)]
    fn grow(&mut self) -> bool {
        let more = self.levels.len();
        let granted = self.budget.take(more * Self::LEVEL_BYTES)
            && self.levels.try_reserve_exact(more).is_ok()
            && self.counts.try_reserve_exact(more).is_ok();
        if granted {
            self.levels.resize(2 * more, Level([[0.0; LANES]; 4]));
            self.counts.resize(2 * more, DepthCount::default());
        }
        granted
    }

    /// The counters of the ray in flight. Needs room.
    #[inline(always)]
    pub(crate) fn count(&mut self) -> &mut DepthCount {
        &mut self.counts[self.depth]
    }

    /// Puts the level of the ray in flight down. Needs room.
    #[inline(always)]
    pub(crate) fn push<L: Lanes>(&mut self, bounce: PendingBounce<L>) {
        let PendingBounce { local, k } = bounce;
        self.levels[self.depth] =
            Level([local.x.to_array(), local.y.to_array(), local.z.to_array(), k.to_array()]);
        self.depth += 1;
    }

    /// Takes the deepest level off.
    #[inline(always)]
    pub(crate) fn pop<L: Lanes>(&mut self) -> Option<PendingBounce<L>> {
        self.depth = self.depth.checked_sub(1)?;
        let [x, y, z, k] = self.levels[self.depth].0.map(L::from_array);
        Some(PendingBounce { local: Vec3 { x, y, z }, k })
    }

    /// Forgets all levels, for a path that is given up.
    pub(crate) fn clear(&mut self) {
        self.depth = 0;
    }

    /// Adds what this stack counted and counts from 0 again.
    pub(crate) fn take_counts(&mut self) -> Counts {
        let used = self.counts.iter().rposition(|c| c.rays > 0).map_or(0, |last| last + 1);
        let depths = self.counts[..used].to_vec();
        self.counts[..used].fill(DepthCount::default());
        Counts { depths }
    }
}

impl Drop for Stack<'_> {
    fn drop(&mut self) {
        let grown = self.levels.len() - Self::FIRST;
        self.budget.give_back(grown * Self::LEVEL_BYTES);
    }
}
