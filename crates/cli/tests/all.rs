//! The program, from outside: arguments in; bytes, files and exit codes out.

mod compare;
mod formats;
mod generate;
mod outputs;
mod program;
mod refusals;
mod signals;
mod stats;
mod views;
