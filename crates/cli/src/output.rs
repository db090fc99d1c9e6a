//! Writing of bytes to a path or to stdout.
//!
//! ```text
//! place.rs     what a path leads to: an open file, a device or pipe, a regular file
//! over.rs      whether a file can be renamed over what stands there
//! beside.rs    a file beside its later name
//! streams.rs   files that the caller opened
//! folder.rs    the folder of a path
//! ```
//!
//! A regular file is written beside its name and renamed: under the asked name there is
//! always either what was there before or all of the new. Where a rename is not possible,
//! the complete file is copied into the one that is there. A device or pipe is written
//! directly, since a rename would replace it, and so is what the caller opened.

mod beside;
mod folder;
mod over;
mod place;
mod streams;

use std::fs;
use std::io::{self, BufWriter, ErrorKind, Seek, Write};
use std::path::Path;

use crate::exit::Failure;
use crate::interrupt::unfinished;
use beside::Beside;
use over::Over;
use place::{Place, STDOUT, find};

/// Bytes that are collected before they are handed to the system.
const BUFFER: usize = 1 << 18;

/// A place for bytes that has been looked at, but not touched.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    name: String,
    place: Place,
}

impl Target {
    /// Looks at a path; `-` is stdout.
    ///
    /// # Errors
    /// Exit code 4 for what can be known to fail: a folder, a path whose folder is not
    /// there, a write-protected file, a stream that is closed.
    pub(crate) fn new(path: &Path) -> Result<Self, Failure> {
        let found = find(path);
        let name = match &found {
            Ok(Place::Open(STDOUT)) => "<stdout>".to_owned(),
            _ if path.as_os_str() == "-" => "<stdout>".to_owned(),
            _ => path.display().to_string(),
        };
        match found {
            Ok(place) => Ok(Self { name, place }),
            Err(why) => Err(Failure::not_written(format_args!("{name} cannot be written: {why}"))),
        }
    }

    /// Looks at stdout.
    ///
    /// # Errors
    /// Exit code 4 if it is closed, or open for reading only.
    pub(crate) fn stdout() -> Result<Self, Failure> {
        Self::new(Path::new("-"))
    }

    /// Looks at a path that is to be a regular file.
    ///
    /// # Errors
    /// Exit code 4, as for any other, and for what is there and is none.
    pub(crate) fn file(path: &Path) -> Result<Self, Failure> {
        let target = Self::new(path)?;
        match &target.place {
            Place::File(..) => Ok(target),
            Place::Open(_) | Place::Direct(_) => Err(Failure::not_written(format_args!(
                "{} cannot be written: it is no regular file, and would not be replaced; name another place",
                target.name
            ))),
        }
    }

    /// How messages call it.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// How the closing line calls it: with a word on what could not be replaced.
    pub(crate) fn closing_name(&self) -> String {
        match self.place {
            Place::File(_, Over::Copied(why)) => format!("{} (written in place: {why})", self.name),
            _ => self.name.clone(),
        }
    }

    /// Whether writing would replace that file, which must be there.
    pub(crate) fn replaces(&self, file: &Path) -> bool {
        match &self.place {
            Place::File(path, Over::Renamed) => {
                fs::canonicalize(file).is_ok_and(|file| file == *path)
            }
            // Under whatever name.
            Place::File(path, Over::Copied(_)) => is_one_file(path, file),
            Place::Open(_) | Place::Direct(_) => false,
        }
    }

    /// Whether two targets are one place.
    pub(crate) fn is(&self, other: &Self) -> bool {
        self.place == other.place
    }

    /// Finds out early whether a file can be made there, by making one and removing it.
    ///
    /// # Errors
    /// Exit code 4.
    pub(crate) fn probe(&self) -> Result<(), Failure> {
        match &self.place {
            Place::File(path, _) => {
                Beside::new(path).map(drop).map_err(|error| self.not_written(&error))
            }
            // Opening a pipe waits for its reader: not before there is something to say.
            Place::Open(_) | Place::Direct(_) => Ok(()),
        }
    }

    /// Writes all of it: where that is direct, for good; otherwise beside, to be put in
    /// place by [`commit`].
    ///
    /// # Errors
    /// Exit code 4, with a full disk and a closed pipe among the reasons. Nothing is left
    /// beside then.
    pub(crate) fn stage(
        &self,
        write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
    ) -> Result<Staged, Failure> {
        let staged = match &self.place {
            Place::Open(number) => {
                streams::open(*number).and_then(|file| buffered(file, write)).map(|()| None)
            }
            Place::Direct(path) => fs::OpenOptions::new()
                .write(true)
                .open(path)
                .and_then(|file| buffered(file, write))
                .map(|()| None),
            Place::File(path, _) => Beside::new(path).and_then(|beside| {
                buffered(&beside.file, write)?;
                Ok(Some(beside))
            }),
        };
        let beside = staged.map_err(|error| self.not_written(&error))?;
        Ok(Staged { target: self.clone(), beside })
    }

    fn not_written(&self, error: &io::Error) -> Failure {
        let advice = match error.kind() {
            ErrorKind::BrokenPipe => "whatever reads it has gone",
            ErrorKind::StorageFull | ErrorKind::QuotaExceeded => {
                "make room, or write to another place"
            }
            ErrorKind::FileTooLarge => "raise the limit on files (ulimit -f), or make it smaller",
            ErrorKind::PermissionDenied | ErrorKind::ReadOnlyFilesystem => "write to another place",
            _ => "nothing was kept",
        };
        Failure::not_written(format_args!("{} cannot be written: {error}; {advice}", self.name))
    }
}

/// Something that is written, but perhaps not under its name yet. Dropping it gives it up.
pub(crate) struct Staged {
    target: Target,
    beside: Option<Beside>,
}

/// Puts everything in place; an interruption comes before or after all of it.
///
/// # Errors
/// Exit code 4 if one cannot be put in place; what comes after it is given up. The message
/// says what was kept and what was not.
pub(crate) fn commit(all: impl IntoIterator<Item = Staged>) -> Result<(), Failure> {
    let mut listed = unfinished();
    let mut failure = None;
    let (mut kept, mut given_up) = (Vec::new(), Vec::new());
    // Dropped without the lock, which dropping takes.
    let mut done = Vec::new();
    for Staged { target, beside } in all {
        let (Some(mut beside), Place::File(path, over)) = (beside, &target.place) else {
            continue;
        };
        if failure.is_some() {
            given_up.push(target.name);
        } else {
            let temporary = beside.unlist(&mut listed);
            let placed = match over {
                // A failed rename hands the path back, and dropping it removes the file.
                Over::Renamed => temporary.persist(path).map_err(|lost| lost.error.to_string()),
                Over::Copied(_) => copy(&mut beside.file, path),
            };
            match placed {
                Ok(()) => kept.push(target.name),
                Err(why) => failure = Some((target.name, why)),
            }
        }
        done.push(beside);
    }
    drop(listed);
    // After a failure the message names what is in place and what is as before.
    let Some((name, why)) = failure else { return Ok(()) };
    let also = |what: &str, names: &[String]| match names {
        [] => String::new(),
        names => format!("; {what}: {}", names.join(", ")),
    };
    Err(Failure::not_written(format_args!(
        "{name} cannot be written: {why}{}{}",
        also("written and kept", &kept),
        also("given up, and as before", &given_up)
    )))
}

/// Copies a complete file into one that is there.
///
/// # Errors
/// Why not. The file is empty then, rather than half written.
fn copy(from: &mut fs::File, path: &Path) -> Result<(), String> {
    let opened = fs::OpenOptions::new().write(true).open(path);
    let mut to = opened.map_err(|error| format!("{error}; it is as before"))?;
    let copied = from.rewind().and_then(|()| to.set_len(0)).and_then(|()| io::copy(from, &mut to));
    copied.map(drop).map_err(|error| {
        let _ = to.set_len(0);
        format!("{error}; it could only be written in place, and is empty now")
    })
}

#[cfg(unix)]
fn is_one_file(a: &Path, b: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    let node = |path| fs::metadata(path).ok().map(|found| (found.dev(), found.ino()));
    node(a).is_some() && node(a) == node(b)
}

#[cfg(not(unix))]
fn is_one_file(a: &Path, b: &Path) -> bool {
    fs::canonicalize(a).is_ok_and(|a| fs::canonicalize(b).is_ok_and(|b| a == b))
}

fn buffered(
    to: impl Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut to = BufWriter::with_capacity(BUFFER, to);
    write(&mut to)?;
    to.flush()
}
