//! The crate's tests, one program.

mod double;
mod truth;
