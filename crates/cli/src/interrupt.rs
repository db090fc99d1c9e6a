//! Signals: SIGINT, SIGTERM and SIGHUP remove what is unfinished and exit 130. A study stops
//! at the first one and keeps what it has measured.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Mutex, MutexGuard, PoisonError};
use std::{fs, process};

use crate::exit::{Exit, say};

/// Files that exist only until they are renamed or given up.
///
/// Whoever makes, renames or removes one holds the lock meanwhile, so that a signal finds
/// each of them either listed or not there.
static UNFINISHED: Mutex<Vec<PathBuf>> = Mutex::new(Vec::new());

/// The list of unfinished files, locked.
pub(crate) fn unfinished() -> MutexGuard<'static, Vec<PathBuf>> {
    // The list is valid after every single step, so a panic elsewhere does not spoil it.
    UNFINISHED.lock().unwrap_or_else(PoisonError::into_inner)
}

/// Whether a signal has asked to stop.
static ASKED: AtomicBool = AtomicBool::new(false);

/// Whether a signal has asked to stop; only while [`measuring`].
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// Whether something is being measured, which the first interruption only ends.
static MEASURING: AtomicBool = AtomicBool::new(false);

/// Measures: meanwhile the first interruption only asks, and the second leaves nothing behind.
/// Before and after, while something is read or written, the first leaves nothing behind.
pub(crate) fn measuring<T>(measure: impl FnOnce() -> T) -> T {
    MEASURING.store(true, Ordering::Relaxed);
    let measured = measure();
    MEASURING.store(false, Ordering::Relaxed);
    measured
}

/// From here on, an interruption leaves nothing behind.
///
/// Not so under `nohup`: the signals are caught together, so the hang-up that the caller
/// wants ignored could not be told from the others. There they keep their defaults.
pub(crate) fn catch() {
    if hang_up_is_ignored() {
        return;
    }
    // Failing here means that the system lacks handlers; rendering works all the same.
    let _ = ctrlc::set_handler(move || {
        if MEASURING.load(Ordering::Relaxed) && !ASKED.swap(true, Ordering::Relaxed) {
            say(format_args!("interrupted: keeping what is measured; once more ends at once"));
            return;
        }
        // Kept locked to the end: nothing is renamed into place after this line.
        let unfinished = unfinished();
        for path in unfinished.iter() {
            let _ = fs::remove_file(path);
        }
        say(format_args!("interrupted: nothing unfinished is left"));
        process::exit(Exit::Interrupted as i32);
    });
}

/// Whether SIGHUP (signal 1, the lowest bit) was ignored by whoever started the program.
/// Known on Linux alone; elsewhere false.
fn hang_up_is_ignored() -> bool {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let ignored = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    ignored.is_some_and(|mask| u64::from_str_radix(mask.trim(), 16).is_ok_and(|mask| mask & 1 == 1))
}
