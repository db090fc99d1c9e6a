//! Signals: SIGINT, SIGTERM and SIGHUP remove what is unfinished and exit 130. A study stops
//! at the first one and keeps what it has measured. A signal that the caller ignores stays
//! ignored.

use std::path::PathBuf;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Arc, Mutex, MutexGuard, PoisonError, mpsc};
use std::{fs, process, thread};

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

/// Leaves nothing behind at an interruption, from here on.
///
/// Handles those of the signals that the caller has not set to be ignored, as `nohup` does, and
/// the shell for what it starts in the background.
///
/// A failure leaves the signals as they are, which end the program too, and rendering works all
/// the same.
#[cfg(unix)]
pub(crate) fn catch() {
    use signal_hook::consts::{SIGHUP, SIGINT, SIGTERM, SIGXFSZ};
    use signal_hook::iterator::Signals;

    // A write beyond `ulimit -f` fails for whoever handles this one; it would end the program.
    let _ = signal_hook::flag::register(SIGXFSZ, Arc::default());

    let ignored = ignored();
    let handled = [SIGINT, SIGTERM, SIGHUP].into_iter().filter(|signal| !ignored.contains(signal));
    let handled: Vec<_> = handled.collect();
    // The thread comes first: a signal that is caught and not waited for would be lost.
    let (ready, is_ready) = mpsc::channel::<()>();
    let wait = move || {
        let Ok(mut signals) = Signals::new(handled) else { return };
        drop(ready);
        signals.forever().for_each(|_| interrupted());
    };
    if thread::Builder::new().name("signals".to_owned()).spawn(wait).is_ok() {
        // Ends when the other side is dropped.
        let _ = is_ready.recv();
    }
}

#[cfg(not(unix))]
pub(crate) fn catch() {}

/// Asks to stop, or ends the program.
#[cfg(unix)]
fn interrupted() {
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
}

/// The signals that whoever started the program wants ignored. Known on Linux alone; elsewhere
/// none.
#[cfg(unix)]
fn ignored() -> Vec<i32> {
    let status = fs::read_to_string("/proc/self/status").unwrap_or_default();
    let mask = status.lines().find_map(|line| line.strip_prefix("SigIgn:"));
    let mask = mask.and_then(|mask| u64::from_str_radix(mask.trim(), 16).ok()).unwrap_or(0);
    // The lowest bit is signal 1.
    (1..=64).filter(|signal| mask >> (signal - 1) & 1 == 1).collect()
}
