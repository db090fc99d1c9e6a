//! The memory that the stacks of all threads may take.

use std::sync::atomic::{AtomicBool, AtomicUsize, Ordering};

/// Bytes that the stacks of all threads may take.
pub(crate) struct Budget {
    limit: usize,
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

    /// Ends the rendering, in every thread.
    pub(super) fn refuse(&self) {
        self.refused.store(true, Ordering::Relaxed);
    }

    /// Takes bytes if the limit allows it.
    pub(super) fn take(&self, bytes: usize) -> bool {
        let within = |taken: usize| taken.checked_add(bytes).filter(|&sum| sum <= self.limit);
        self.taken.fetch_update(Ordering::Relaxed, Ordering::Relaxed, within).is_ok()
    }

    pub(super) fn give_back(&self, bytes: usize) {
        self.taken.fetch_sub(bytes, Ordering::Relaxed);
    }
}
