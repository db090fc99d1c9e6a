//! The tests of the ladder.

mod aside;
mod broken;
mod comparison;
mod native_stack;
mod readme;
mod rungs;
