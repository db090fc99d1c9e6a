//! Where bytes go.
//!
//! A regular file is written beside its name and renamed: under the asked name there is
//! always either what was there before or all of the new. A device or pipe is written
//! directly, since a rename would replace it.

use std::fs;
use std::io::{self, BufWriter, ErrorKind, Write};
use std::path::{Path, PathBuf};

use tempfile::{NamedTempFile, TempPath};

use crate::exit::Failure;
use crate::input::is_stream;
use crate::interrupt::unfinished;

/// Symbolic links that are followed to a file that is not there yet; the kernel's limit.
const LINKS: usize = 40;

/// Bytes that are collected before they are handed to the system.
const BUFFER: usize = 1 << 18;

/// A place for bytes that has been looked at, but not touched.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Target {
    name: String,
    place: Place,
}

#[derive(Clone, Debug, PartialEq, Eq)]
enum Place {
    Stdout,
    /// A device, a pipe, or an open file by its number.
    Direct(PathBuf),
    /// A regular file, links followed, there already or not.
    Beside(PathBuf),
}

impl Target {
    /// Looks at a path; `-` and `/dev/stdout` are stdout.
    ///
    /// # Errors
    /// Exit code 4 for what can be known to fail: a folder, a path whose folder is not
    /// there, a write-protected file.
    pub(crate) fn new(path: &Path) -> Result<Self, Failure> {
        let name = path.display().to_string();
        if is_stream(path) || path.as_os_str() == "/dev/stdout" {
            return Ok(Self { name: "<stdout>".to_owned(), place: Place::Stdout });
        }
        let refuse = |why: &dyn std::fmt::Display| {
            Err(Failure::not_written(format_args!("{name} cannot be written: {why}")))
        };
        if name.ends_with(std::path::is_separator) {
            return refuse(&"it names a folder; name a file in it");
        }
        let place = match fs::metadata(path) {
            Ok(found) if found.is_dir() => {
                return refuse(&"it is a folder; name a file in it");
            }
            Ok(found) if !found.is_file() || is_open_file(path) => Place::Direct(path.to_owned()),
            Ok(found) if found.permissions().readonly() => {
                return refuse(&"the file is write-protected; name another one");
            }
            Ok(_) => Place::Beside(fs::canonicalize(path).unwrap_or_else(|_| path.to_owned())),
            Err(error) if error.kind() == ErrorKind::NotFound => Place::Beside(behind_links(path)),
            Err(error) if error.kind() == ErrorKind::NotADirectory => {
                return refuse(&"a folder in its path is a file");
            }
            Err(error) => return refuse(&error),
        };
        let Place::Beside(path) = &place else {
            return Ok(Self { name, place });
        };
        // The folder's one true name, so that equal places are seen to be equal.
        let folder = folder(path);
        match (fs::canonicalize(folder), path.file_name()) {
            (Ok(found), Some(file)) if found.is_dir() => {
                Ok(Self { name, place: Place::Beside(found.join(file)) })
            }
            (Ok(_), _) => refuse(&format_args!("{} is not a folder", folder.display())),
            (Err(error), _) => {
                refuse(&format_args!("folder {}: {error}; make it first", folder.display()))
            }
        }
    }

    /// How messages call it.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Whether writing would replace that file, which must be there.
    pub(crate) fn replaces(&self, file: &Path) -> bool {
        match &self.place {
            Place::Beside(path) => fs::canonicalize(file).is_ok_and(|file| file == *path),
            Place::Stdout | Place::Direct(_) => false,
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
            Place::Beside(path) => {
                temporary(path).map(drop).map_err(|error| self.not_written(&error))
            }
            // Opening a pipe waits for its reader: not before there is something to say.
            Place::Stdout | Place::Direct(_) => Ok(()),
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
            Place::Stdout => buffered(io::stdout().lock(), write).map(|()| None),
            Place::Direct(path) => fs::OpenOptions::new()
                .write(true)
                .open(path)
                .and_then(|file| buffered(file, write))
                .map(|()| None),
            Place::Beside(path) => temporary(path).and_then(|(mut file, unfinished)| {
                buffered(&mut file, write)?;
                Ok(Some(unfinished))
            }),
        };
        let unfinished = staged.map_err(|error| self.not_written(&error))?;
        Ok(Staged { target: self.clone(), unfinished })
    }

    fn not_written(&self, error: &io::Error) -> Failure {
        let advice = match error.kind() {
            ErrorKind::BrokenPipe => "whatever reads it has gone",
            ErrorKind::StorageFull => "make room, or write to another place",
            ErrorKind::PermissionDenied => "write to another place",
            _ => "nothing was kept",
        };
        Failure::not_written(format_args!("{} cannot be written: {error}; {advice}", self.name))
    }
}

/// Something that is written, but perhaps not under its name yet. Dropping it gives it up.
pub(crate) struct Staged {
    target: Target,
    unfinished: Option<Unfinished>,
}

/// Puts everything in place; an interruption comes before or after all of it.
///
/// # Errors
/// Exit code 4 if a rename fails; what comes after it is given up.
pub(crate) fn commit(all: impl IntoIterator<Item = Staged>) -> Result<(), Failure> {
    let mut listed = unfinished();
    let mut failure = None;
    let mut given_up = Vec::new();
    for Staged { target, unfinished } in all {
        let (Some(mut unfinished), Place::Beside(path)) = (unfinished, &target.place) else {
            continue;
        };
        if failure.is_none()
            && let Some(temporary) = unfinished.0.take()
        {
            listed.retain(|path| *path != *temporary);
            // A failed rename hands the path back, and dropping it removes the file.
            let renamed = temporary.persist(path);
            failure = renamed.err().map(|lost| target.not_written(&lost.error));
        }
        given_up.push(unfinished);
    }
    // What was given up takes the lock to be removed.
    drop(listed);
    drop(given_up);
    failure.map_or(Ok(()), Err)
}

/// A file beside its later name, listed as unfinished for as long as it is there.
struct Unfinished(Option<TempPath>);

impl Drop for Unfinished {
    fn drop(&mut self) {
        if let Some(temporary) = self.0.take() {
            let mut listed = unfinished();
            listed.retain(|path| *path != *temporary);
            drop(temporary);
        }
    }
}

/// Makes a file beside `path`, with the permissions of any new file.
fn temporary(path: &Path) -> io::Result<(fs::File, Unfinished)> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(".catoptric-").suffix(".unfinished");
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // Less the umask, which the system applies.
        builder.permissions(fs::Permissions::from_mode(0o666));
    }
    let mut listed = unfinished();
    let (file, temporary) = NamedTempFile::into_parts(builder.tempfile_in(folder(path))?);
    listed.push(temporary.to_path_buf());
    Ok((file, Unfinished(Some(temporary))))
}

fn buffered(
    to: impl Write,
    write: impl FnOnce(&mut dyn Write) -> io::Result<()>,
) -> io::Result<()> {
    let mut to = BufWriter::with_capacity(BUFFER, to);
    write(&mut to)?;
    to.flush()
}

/// The folder that a file is in.
fn folder(path: &Path) -> &Path {
    match path.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent,
        _ => Path::new("."),
    }
}

/// Paths that stand for a file that is open already, which must not be replaced.
fn is_open_file(path: &Path) -> bool {
    path.starts_with("/proc") || path.starts_with("/dev/fd") || path.as_os_str() == "/dev/stderr"
}

/// The name that a file will have once it is made through links that lead nowhere yet.
fn behind_links(path: &Path) -> PathBuf {
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        let Ok(next) = fs::read_link(&path) else { break };
        path = folder(&path).join(next);
    }
    path
}
