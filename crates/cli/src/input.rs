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

/// Reads a file, or stdin for `-`, of at most `limit` bytes.
///
/// # Errors
/// Exit code 3: missing, unreadable, or longer than the limit; no more than that is read.
pub(crate) fn read(path: &Path, limit: u64) -> Result<Vec<u8>, Failure> {
    let mut bytes = Vec::new();
    let read = if is_stream(path) {
        read_at_most(io::stdin().lock(), limit, &mut bytes)
    } else {
        File::open(path).and_then(|file| read_at_most(file, limit, &mut bytes))
    };
    let name = name(path);
    read.map_err(|error| Failure::bad_input(format_args!("{name} cannot be read: {error}")))?;
    if bytes.len() as u64 > limit {
        return Err(Failure::bad_input(format_args!(
            "{name} has more than the {limit} bytes that the memory limit allows: raise --memory-limit"
        )));
    }
    Ok(bytes)
}

/// One byte past the limit tells that there is more.
fn read_at_most(from: impl Read, limit: u64, to: &mut Vec<u8>) -> io::Result<usize> {
    from.take(limit.saturating_add(1)).read_to_end(to)
}
