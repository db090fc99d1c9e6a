//! The studies without their clocks: every case of the stability suite with its bound, the
//! measures that follow paths, every format of a report.

mod agreement;
mod amplification;
mod causes;
mod condition;
mod depth;
mod error;
mod input;
mod light;
mod occasion;
mod report;
mod scenes;
mod search;
mod stability;
mod tables;
mod timing;
