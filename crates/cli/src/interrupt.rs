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

/// Whether a signal has asked to stop; only after [`catch_the_second`].
pub(crate) fn asked() -> bool {
    ASKED.load(Ordering::Relaxed)
}

/// From here on, the first interruption only asks, and the second leaves nothing behind.
pub(crate) fn catch_the_second() {
    set_handler(true);
}

/// From here on, an interruption leaves nothing behind.
pub(crate) fn catch() {
    set_handler(false);
}

/// Not so under `nohup`: the signals are caught together, so the hang-up that the caller
/// wants ignored could not be told from the others. There they keep their defaults.
fn set_handler(first_asks: bool) {
    if hang_up_is_ignored() {
        return;
    }
    // Failing here means that the system lacks handlers; rendering works all the same.
    let _ = ctrlc::set_handler(move || {
        if first_asks && !ASKED.swap(true, Ordering::Relaxed) {
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
