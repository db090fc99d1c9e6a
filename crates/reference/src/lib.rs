//! The recursive ray tracer that specifies the picture, and truth in higher precision.

pub mod truth;
