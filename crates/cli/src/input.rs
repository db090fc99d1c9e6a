//! Bytes of a file or of stdin.

use std::fs::File;
use std::io::{self, Read};
use std::path::Path;

use crate::exit::Failure;

/// Whether a path is `-`, which stands for stdin or stdout.
pub(crate) fn is_stream(path: &Path) -> bool {
    path.as_os_str() == "-"
}

/// How messages call an input.
pub(crate) fn name(path: &Path) -> String {
    if is_stream(path) { "<stdin>".to_owned() } else { path.display().to_string() }
}

/// Reads a file, or stdin for `-`, of at most `limit` bytes. `advice` says what to do where that is
/// too little.
///
/// # Errors
/// Exit code 3: missing, unreadable, longer than the limit, or than the system has memory for. No
/// more than that is read.
pub(crate) fn read(path: &Path, limit: u64, advice: &str) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let read = if is_stream(path) {
        read_at_most(io::stdin().lock(), 0, limit, &mut bytes)
    } else {
        File::open(path).and_then(|file| {
            let length = file.metadata()?.len();
            read_at_most(file, length, limit, &mut bytes)
        })
    };
    let name = name(path);
    read.map_err(|error| Failure::bad_input(format_args!("{name} cannot be read: {error}")))?;
    if bytes.len() as u64 > limit {
        return Err(Failure::bad_input(format_args!(
            "{name} has more than the {limit} bytes that the memory limit allows: {advice}"
        )));
    }
    // What a pipe holds is not known before, so its buffer may be twice as large.
    bytes.shrink_to_fit();
    Ok(bytes)
}

/// One byte past the limit tells that there is more. `length` is what is expected.
fn read_at_most(from: impl Read, length: u64, limit: u64, to: &mut Vec<u8>) -> io::Result<usize> {
    let most = limit.saturating_add(1);
    let expected = usize::try_from(length.saturating_add(1).min(most)).unwrap_or(usize::MAX);
    to.try_reserve_exact(expected)?;
    from.take(most).read_to_end(to)
}
