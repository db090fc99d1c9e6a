//! What the tests that cross crates share: how two pictures are compared, and scenes to
//! compare them on.

pub mod crowds;
pub mod generate;
pub mod identity;
pub mod scenes;
pub mod source;
pub mod turned;
pub mod unseen;
