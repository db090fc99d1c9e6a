//! The studies without their clocks: every case of the stability suite with its bound, the
//! measures that follow paths.

mod agreement;
mod amplification;
mod causes;
mod condition;
mod depth;
mod error;
mod input;
mod light;
mod scenes;
mod search;
mod stability;
mod tables;
mod timing;
