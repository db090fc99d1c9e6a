//! The tests that cross crates.

mod deep;
mod house;
mod identity;
mod kernel;
mod plan;
mod planted;
mod same;
