//! A file beside its later name, until it is put in place.
//!
//! Whoever writes one holds a lock on it, which the system drops with the process. A file of
//! that kind without a lock is left over from a run that was killed; the next run to the same
//! name removes it.

use std::fs::{self, File, Metadata};
use std::hash::{DefaultHasher, Hash, Hasher};
use std::io;
use std::path::Path;

use tempfile::{NamedTempFile, TempPath};

use super::folder::folder;
use crate::interrupt::unfinished;

/// What the name of each ends with.
const SUFFIX: &str = ".unfinished";

/// A file beside its later name, listed as unfinished for as long as it is there.
pub(super) struct Beside {
    pub(super) file: File,
    path: Option<TempPath>,
}

impl Beside {
    /// Makes an empty one for `path`, with the mode and owner of what stands there, and removes
    /// what killed runs have left.
    ///
    /// # Errors
    /// The system's.
    pub(super) fn new(path: &Path) -> io::Result<Self> {
        let prefix = prefix(path);
        sweep(folder(path), &prefix);
        let there = fs::metadata(path).ok();
        let mut builder = tempfile::Builder::new();
        builder.prefix(&prefix).suffix(SUFFIX);
        #[cfg(unix)]
        {
            use std::os::unix::fs::PermissionsExt;
            // A new file's less the umask, which the system applies. One that replaces another
            // is its writer's alone until it has the other's owner and mode.
            let mode = if there.is_some() { 0o600 } else { 0o666 };
            builder.permissions(fs::Permissions::from_mode(mode));
        }
        loop {
            let mut listed = unfinished();
            let (file, path) = NamedTempFile::into_parts(builder.tempfile_in(folder(path))?);
            // Some file systems have no locks; there, nobody takes it for left over.
            let _ = file.lock();
            if is_gone(&file) {
                // Taken for left over before the lock was held.
                continue;
            }
            if let Some(there) = &there {
                take_after(&file, there);
            }
            listed.push(path.to_path_buf());
            return Ok(Self { file, path: Some(path) });
        }
    }

    /// Takes it from the list, which the caller holds locked, to be renamed or removed.
    pub(super) fn unlist(&mut self, listed: &mut Vec<std::path::PathBuf>) -> TempPath {
        let path = self.path.take().expect("it is put in place once");
        listed.retain(|other| *other != *path);
        path
    }
}

impl Drop for Beside {
    fn drop(&mut self) {
        if let Some(path) = self.path.take() {
            let mut listed = unfinished();
            listed.retain(|other| *other != *path);
            drop(path);
        }
    }
}

/// What the names of all of one place begin with; short, however long its own is.
fn prefix(path: &Path) -> String {
    let mut hasher = DefaultHasher::new();
    path.file_name().hash(&mut hasher);
    format!(".catoptric-{:016x}-", hasher.finish())
}

/// Removes what killed runs have left of one place. What cannot be removed is not in the way.
fn sweep(folder: &Path, prefix: &str) {
    for entry in fs::read_dir(folder).into_iter().flatten().flatten() {
        let name = entry.file_name();
        let ours = name.to_str().is_some_and(|n| n.starts_with(prefix) && n.ends_with(SUFFIX));
        // Not a link, and nothing that opening could wait for.
        if ours && entry.file_type().is_ok_and(|kind| kind.is_file()) {
            let left = File::open(entry.path()).is_ok_and(|file| file.try_lock().is_ok());
            if left {
                let _ = fs::remove_file(entry.path());
            }
        }
    }
}

#[cfg(unix)]
fn is_gone(file: &File) -> bool {
    use std::os::unix::fs::MetadataExt;
    file.metadata().is_ok_and(|found| found.nlink() == 0)
}

#[cfg(not(unix))]
fn is_gone(_: &File) -> bool {
    false
}

/// Gives a file the permissions of another one and, as far as the system lets, its owner and
/// group. A group that it cannot have leaves the new one no more than everybody.
#[cfg(unix)]
fn take_after(file: &File, there: &Metadata) {
    use std::os::unix::fs::{MetadataExt, PermissionsExt, fchown};
    let Ok(made) = file.metadata() else { return };
    if (made.uid(), made.gid()) != (there.uid(), there.gid())
        && fchown(file, Some(there.uid()), Some(there.gid())).is_err()
    {
        let _ = fchown(file, None, Some(there.gid()));
    }
    let mut mode = there.mode() & 0o777;
    if file.metadata().is_ok_and(|made| made.gid() != there.gid()) {
        mode &= !0o070 | (mode & 0o007) << 3;
    }
    // File systems without modes refuse.
    let _ = file.set_permissions(fs::Permissions::from_mode(mode));
}

#[cfg(not(unix))]
fn take_after(_: &File, _: &Metadata) {}
