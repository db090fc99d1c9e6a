//! The crate's tests, one program.

mod truth;
