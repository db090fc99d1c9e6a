//! What a path leads to, links followed.

use std::fs;
use std::io::ErrorKind;
use std::path::{Component, Path, PathBuf};

use super::folder::folder;
use super::over::{Over, over};
use super::streams;
use crate::input::is_stream;

/// Symbolic links that are followed; the kernel's limit.
const LINKS: usize = 40;

/// The number of stdout.
pub(super) const STDOUT: u32 = 1;

#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) enum Place {
    /// A file that the caller opened, by its number.
    Open(u32),
    /// A device or a pipe.
    Direct(PathBuf),
    /// A regular file, there already or not, and how it is put in place.
    File(PathBuf, Over),
}

/// Follows a path; `-` is stdout.
///
/// # Errors
/// Why nothing can be written there, as far as it can be known without writing.
pub(super) fn find(path: &Path) -> Result<Place, String> {
    if is_stream(path) {
        return opened(STDOUT);
    }
    if path.as_os_str().to_string_lossy().ends_with(std::path::is_separator) {
        return Err("it names a folder; name a file in it".to_owned());
    }
    let mut path = path.to_owned();
    for _ in 0..LINKS {
        if let Some(number) = number(&path) {
            return opened(number);
        }
        let Some(name) = path.file_name() else {
            return Err("it is a folder; name a file in it".to_owned());
        };
        // The folder's one true name, so that equal places are seen to be equal.
        let folder = true_folder(folder(&path))?;
        let here = folder.join(name);
        if let Some(number) = number(&here) {
            return opened(number);
        }
        match fs::read_link(&here) {
            Ok(next) if !is_of_a_process(&folder) => path = folder.join(next),
            // An open file of another process: its link is no path.
            Ok(_) => return of_another(here),
            Err(_) => return at(here),
        }
    }
    Err("it leads through too many links".to_owned())
}

fn opened(number: u32) -> Result<Place, String> {
    streams::check(number).map(|()| Place::Open(number))
}

/// The number in a name for an open file of this process.
fn number(path: &Path) -> Option<u32> {
    let named = ["/dev/stdin", "/dev/stdout", "/dev/stderr"];
    if let Some(number) = named.iter().position(|name| path.as_os_str() == *name) {
        return u32::try_from(number).ok();
    }
    let folder = path.parent()?;
    let own = Path::new("/proc").join(std::process::id().to_string());
    // With or without a thread's name: `/proc/self/task/7/fd` has the same files.
    let inside = folder.strip_prefix("/proc/self").or_else(|_| folder.strip_prefix(own));
    let this = match inside.map(|inside| inside.components().collect::<Vec<_>>()) {
        Ok(inside) => match *inside {
            [Component::Normal(fd)] => fd == "fd",
            [Component::Normal(task), _, Component::Normal(fd)] => task == "task" && fd == "fd",
            _ => false,
        },
        Err(_) => folder == Path::new("/dev/fd") || folder == Path::new("/proc/thread-self/fd"),
    };
    let number = path.file_name()?.to_str().filter(|_| this)?;
    // Nothing but digits: parsing takes a sign too.
    number.parse().ok().filter(|_| number.bytes().all(|byte| byte.is_ascii_digit()))
}

fn is_of_a_process(folder: &Path) -> bool {
    folder.starts_with("/proc") && folder.ends_with("fd")
}

fn of_another(path: PathBuf) -> Result<Place, String> {
    match fs::metadata(&path) {
        Ok(found) if found.is_file() => {
            Err("it is an open file of another process; name the file".to_owned())
        }
        Ok(found) if found.is_dir() => Err("it is a folder; name a file in it".to_owned()),
        Ok(_) => direct(path),
        Err(error) => Err(error.to_string()),
    }
}

/// What stands at a path that is no link.
fn at(path: PathBuf) -> Result<Place, String> {
    let found = match fs::symlink_metadata(&path) {
        Ok(found) => Some(found),
        Err(error) if error.kind() == ErrorKind::NotFound => None,
        Err(error) => return Err(error.to_string()),
    };
    match &found {
        Some(found) if found.is_dir() => Err("it is a folder; name a file in it".to_owned()),
        Some(found) if !found.is_file() => direct(path),
        Some(found) if found.permissions().readonly() => {
            Err("the file is write-protected; name another one".to_owned())
        }
        _ => {
            let over = over(&path, found.as_ref())?;
            Ok(Place::File(path, over))
        }
    }
}

fn direct(path: PathBuf) -> Result<Place, String> {
    #[cfg(unix)]
    {
        use std::os::unix::fs::FileTypeExt;
        if fs::metadata(&path).is_ok_and(|found| found.file_type().is_socket()) {
            return Err("it is a socket; name a file".to_owned());
        }
        // Opening a pipe would wait for its reader.
        rustix::fs::access(&path, rustix::fs::Access::WRITE_OK)
            .map_err(|error| std::io::Error::from(error).to_string())?;
    }
    Ok(Place::Direct(path))
}

/// A folder's name without links.
fn true_folder(folder: &Path) -> Result<PathBuf, String> {
    match fs::canonicalize(folder) {
        Ok(found) if found.is_dir() => Ok(found),
        Ok(_) => Err(format!("{} is a file, not a folder", folder.display())),
        Err(error) if error.kind() == ErrorKind::NotADirectory => {
            Err("a folder in its path is a file".to_owned())
        }
        Err(error) => Err(format!("folder {}: {error}; make it first", folder.display())),
    }
}
