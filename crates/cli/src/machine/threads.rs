//! Threads and their stacks: how many, how large, and what to do where they are not granted.

use std::fmt::Display;
use std::process::ExitCode;
use std::thread;

use super::limits;
use crate::exit::Failure;
use crate::size::Size;

/// Bytes of stack that suffice for all but the recursion.
pub(crate) const STACK: usize = 2 << 20;

/// Address space that a thread may take beside its stack: what the system's allocator reserves
/// for it.
const BESIDE: u64 = 128 << 20;

/// Threads that the system can run at once, as far as it says so.
pub(crate) fn available() -> usize {
    thread::available_parallelism().map_or(1, usize::from).min(1024)
}

/// Runs the program where it has [`STACK`] bytes of stack, whatever `ulimit -s` says.
pub(crate) fn on_enough_stack(program: fn() -> ExitCode) -> ExitCode {
    let Some(stack) = limits::stack().filter(|&stack| stack < STACK as u64) else {
        return program();
    };
    let thread = thread::Builder::new().name("main".to_owned()).stack_size(STACK).spawn(program);
    match thread {
        // A panic has said why already; this code is what it ends the first thread with.
        Ok(thread) => thread.join().unwrap_or(ExitCode::from(101)),
        Err(error) => {
            let (stack, kib) = (Size(stack), STACK >> 10);
            let failure = Failure::failed(format_args!(
                "a stack of {stack} is too small, and a thread with a larger one cannot be had: {error}; raise `ulimit -s` to {kib} KiB"
            ));
            failure.report();
            failure.exit.into()
        }
    }
}

/// Threads that are wanted, and the advice of the command that wants them.
pub(crate) struct Wanted {
    pub(crate) threads: usize,
    /// Bytes of each one's stack.
    pub(crate) stack: usize,
    /// How to have so many threads and no more.
    pub(crate) fewer: fn(usize) -> String,
    /// What needs no such threads, if anything does.
    pub(crate) instead: Option<&'static str>,
}

impl Wanted {
    /// Exit code 1, with advice that helps: fewer threads only where that is enough.
    pub(crate) fn refused(&self, error: &dyn Display) -> Failure {
        let what = match self.threads {
            1 => "a thread".to_owned(),
            threads => format!("{threads} threads"),
        };
        let each = self.stack as u64 + BESIDE;
        let needed = each * (self.threads as u64 + 1);
        let (why, raise, fewer) = match limits::address_space() {
            Some(limit) if limit < needed => {
                let (stack, limit_shown) = (Size(self.stack as u64), Size(limit));
                (
                    format!(
                        "each takes {stack} of address space for its stack, and `ulimit -v` allows {limit_shown} in all"
                    ),
                    format!("raise that to {} KiB", needed >> 10),
                    (limit / each).saturating_sub(1).min(self.threads as u64 - 1) as usize,
                )
            }
            _ => (
                error.to_string(),
                "raise `ulimit -u`, or the number of tasks that a container may have".to_owned(),
                self.threads / 2,
            ),
        };
        let fewer = (fewer > 0).then(|| (self.fewer)(fewer));
        let advice = [Some(raise), fewer, self.instead.map(str::to_owned)];
        let advice = advice.into_iter().flatten().collect::<Vec<_>>().join(", or ");
        Failure::failed(format_args!("{what} cannot be had: {why}; {advice}"))
    }
}
