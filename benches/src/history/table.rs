//! The file: a header, then one line an entry, each with its line end.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::{Path, PathBuf};

use super::entry::{COLUMNS, Entry};

/// Why the history cannot be read or written.
#[derive(Debug, thiserror::Error)]
pub enum TableError {
    /// The system refused.
    #[error("{}: {source}", .path.display())]
    Io {
        /// The file.
        path: PathBuf,
        /// What it said.
        source: io::Error,
    },
    /// A line is not what this tool writes.
    #[error("{}:{line}: {fault}", .path.display())]
    Line {
        /// The file.
        path: PathBuf,
        /// Counted from 1.
        line: usize,
        /// What is wrong with it.
        fault: String,
    },
}

/// All entries of a file, oldest first; none where the file is missing or empty.
///
/// # Errors
/// The first line that is cut off, has other columns than [`COLUMNS`], or a field that does
/// not parse.
pub fn read(path: &Path) -> Result<Vec<Entry>, TableError> {
    let text = match std::fs::read_to_string(path) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        result => result.map_err(|source| TableError::Io { path: path.to_owned(), source })?,
    };
    parse(&text).map_err(|(line, fault)| TableError::Line { path: path.to_owned(), line, fault })
}

/// Adds entries to a file in one write, with the header where there is none yet.
///
/// # Errors
/// Whatever [`read`] finds wrong with the file, which is then not touched, or the system's
/// refusal to write.
pub fn append(path: &Path, entries: &[Entry]) -> Result<(), TableError> {
    read(path)?;
    let io = |source| TableError::Io { path: path.to_owned(), source };
    let mut file = OpenOptions::new().create(true).append(true).open(path).map_err(io)?;
    let mut text = String::new();
    if file.metadata().map_err(io)?.len() == 0 {
        text += &(COLUMNS.join(",") + "\n");
    }
    for entry in entries {
        text += &(entry.to_line() + "\n");
    }
    file.write_all(text.as_bytes()).map_err(io)
}

/// The entries of a text, or the number of the first bad line and what is wrong with it.
fn parse(text: &str) -> Result<Vec<Entry>, (usize, String)> {
    let mut entries = Vec::new();
    for (i, line) in text.split_inclusive('\n').enumerate() {
        let at = |fault| (i + 1, fault);
        let Some(line) = line.strip_suffix('\n') else {
            return Err(at(
                "the line has no end, so it may be cut off: complete or remove it".into()
            ));
        };
        if i == 0 {
            header(line).map_err(at)?;
        } else {
            entries.push(Entry::from_line(line).map_err(at)?);
        }
    }
    Ok(entries)
}

/// Whether a header names the columns that this tool knows, in their order.
fn header(line: &str) -> Result<(), String> {
    let found: Vec<&str> = line.split(',').collect();
    if found == COLUMNS {
        return Ok(());
    }
    let unknown = found.iter().find(|name| !COLUMNS.contains(name));
    let missing = COLUMNS.iter().find(|name| !found.contains(name));
    Err(match (unknown, missing) {
        (Some(name), _) => format!("unknown column {name:?}"),
        (None, Some(name)) => format!("column {name:?} is missing"),
        (None, None) => format!("columns are not in the order {}", COLUMNS.join(",")),
    })
}
