//! What can be seen of the packet loop while it runs.

use super::scratch::Scratch;
use super::stack::Stack;
use crate::simd::Lane;

/// Sees each bounce go down and come up. The loop that is observed is the loop that renders: it
/// asks once a bounce whether it is.
pub(crate) trait Observe<S: Lane> {
    /// Called after a bounce was traced; the next one has so many packets.
    fn bounce(&mut self, scratch: &Scratch<S>, next: usize);
    /// Called before the bounce in flight is taken off the stack.
    fn before_fold(&mut self, stack: &Stack<S>);
    /// Called after a bounce was folded.
    fn after_fold(&mut self, stack: &Stack<S>);
}
