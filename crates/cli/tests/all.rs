//! The program, from outside: arguments in; bytes, files and exit codes out.

mod broken;
mod browser;
mod compare;
mod elsewhere;
mod examples;
mod explain;
mod folders;
mod formats;
mod generate;
mod limits;
mod memory;
mod numbers;
mod outputs;
mod program;
mod refusals;
mod replacing;
mod signals;
mod stats;
mod streams;
mod study;
mod terminal;
mod views;
