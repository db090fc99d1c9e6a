//! The tests that cross crates.

mod circles;
mod deep;
mod house;
mod identity;
mod kernel;
mod language;
mod plan;
mod planted;
mod same;
mod source;
