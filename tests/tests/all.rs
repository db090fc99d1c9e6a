//! The tests that cross crates.

mod deep;
mod identity;
mod kernel;
mod planted;
