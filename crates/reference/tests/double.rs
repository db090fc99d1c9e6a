//! The recursion in f64 against truth, and its power against arbitrary precision.

mod accuracy;
mod power;
