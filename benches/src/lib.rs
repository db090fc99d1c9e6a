//! What the benches and the history share: subjects whose picture is checked, runners that
//! time them, scenes made for the purpose, and the history of the speed-up.
//!
//! This package reads clocks; the libraries do not.

pub mod crowds;
pub mod history;
pub mod kernels;
pub mod runner;
pub mod scenes;
pub mod subject;
pub mod test_mode;
