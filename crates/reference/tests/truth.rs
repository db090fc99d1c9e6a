//! Truth against closed forms, against arbitrary precision, and against itself.

mod agreement;
mod cases;
mod closed_forms;
mod depth;
mod distances;
mod exact;
mod lights;
pub(crate) mod scenes;
