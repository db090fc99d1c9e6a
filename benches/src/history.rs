//! The speed-up over time: one line a scene and recording, in `history.csv`.
//!
//! `measure` makes an entry, `table` reads and writes them, `rule` says whether the last one
//! is worse than the noise.

pub mod commit;
pub mod entry;
pub mod measure;
pub mod rule;
pub mod spread;
pub mod table;
