//! The tests of the ladder.

mod aside;
mod broken;
mod broken_packets;
mod comparison;
mod native_stack;
mod readme;
mod rungs;
