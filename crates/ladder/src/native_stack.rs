//! Measures how much native stack a rung uses, by the addresses that it reaches, event by event.

use std::hint::black_box;
use std::ptr;

use crate::{Event, Watch};

/// Calls `watched` with a watch on the native stack. Gives its answer, and the bytes from this call
/// down to the lowest event.
///
/// Stack that a rung takes between events, to test a shadow ray say, is not seen. All events must
/// come on this thread.
#[inline(never)]
pub fn native_stack<R>(watched: impl FnOnce(&mut dyn Watch) -> R) -> (R, usize) {
    let base = black_box(0_usize);
    let top = ptr::from_ref(black_box(&base)).addr();
    let mut lowest = Lowest(top);
    let answer = watched(&mut lowest);
    (answer, top - lowest.0)
}

/// The lowest address so far.
struct Lowest(usize);

impl Watch for Lowest {
    /// Notes the address of the event, which lies at the stack's end.
    #[inline(never)]
    fn see(&mut self, event: Event) {
        let here = ptr::from_ref(black_box(&event)).addr();
        self.0 = self.0.min(here);
    }
}
