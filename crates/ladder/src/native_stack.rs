//! How much native stack a rung uses: the addresses that it reaches, event by event.

use crate::{Event, Watch};

/// Watches where the native stack ends whenever something happens.
#[derive(Clone, Copy, Debug, Default)]
pub struct NativeStack {
    /// Lowest and highest address so far.
    reach: Option<(usize, usize)>,
}

impl NativeStack {
    /// Bytes between the highest and the lowest end of the stack that was seen. A constant
    /// below one frame is missing: what lies above the first event.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.reach.map_or(0, |(low, high)| high - low)
    }
}

impl Watch for NativeStack {
    /// The event itself lies at the stack's end.
    #[inline(never)]
    fn see(&mut self, event: Event) {
        let here = std::ptr::from_ref(std::hint::black_box(&event)).addr();
        let (low, high) = self.reach.unwrap_or((here, here));
        self.reach = Some((low.min(here), high.max(here)));
    }
}
