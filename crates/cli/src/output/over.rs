//! Whether a complete file can be renamed over what stands there.

use std::fs::{self, Metadata};
use std::path::Path;

use super::folder::folder;

/// How a complete file comes to its name.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Over {
    /// The new file was renamed over the old.
    Renamed,
    /// The bytes were copied into the file that is there, which cannot be replaced, and why.
    Copied(&'static str),
}

/// How a regular file, there already or not, can be put in place.
///
/// # Errors
/// Why it cannot.
pub(super) fn over(path: &Path, there: Option<&Metadata>) -> Result<Over, String> {
    if is_fixed(folder(path)) {
        return Err("its folder is immutable or append-only; write to another one".to_owned());
    }
    let Some(there) = there else { return Ok(Over::Renamed) };
    if is_fixed(path) {
        return Err("the file is immutable or append-only; name another one".to_owned());
    }
    let why = if is_mounted(path) {
        "it is mounted by itself"
    } else if is_held(path, there) {
        "it is another user's, in a folder where each may replace only their own"
    } else {
        return Ok(Over::Renamed);
    };
    // Neither made nor changed by this.
    let opened = fs::OpenOptions::new().write(true).open(path);
    match opened {
        Ok(_) => Ok(Over::Copied(why)),
        Err(error) => Err(format!("{why}, and {error}; write to another place")),
    }
}

/// Whether another user's file is in a sticky folder.
#[cfg(unix)]
fn is_held(path: &Path, there: &Metadata) -> bool {
    use std::os::unix::fs::MetadataExt;
    const STICKY: u32 = 0o1000;
    let user = rustix::process::geteuid().as_raw();
    let Ok(folder) = fs::metadata(folder(path)) else { return false };
    let held = folder.mode() & STICKY != 0 && there.uid() != user && folder.uid() != user;
    held && !owns_all(user)
}

#[cfg(target_os = "linux")]
fn owns_all(_: u32) -> bool {
    use rustix::thread::{CapabilitySet, capabilities};
    let held = capabilities(None);
    held.is_ok_and(|held| held.effective.contains(CapabilitySet::FOWNER))
}

#[cfg(all(unix, not(target_os = "linux")))]
fn owns_all(user: u32) -> bool {
    user == 0
}

#[cfg(not(unix))]
fn is_held(_: &Path, _: &Metadata) -> bool {
    false
}

/// Whether its attributes forbid replacing it, or anything in it.
fn is_fixed(path: &Path) -> bool {
    #[cfg(target_os = "linux")]
    {
        use rustix::fs::StatxAttributes;
        attributes(path).intersects(StatxAttributes::IMMUTABLE | StatxAttributes::APPEND)
    }
    #[cfg(not(target_os = "linux"))]
    {
        let _ = path;
        false
    }
}

/// Whether a file is the root of a mount.
fn is_mounted(path: &Path) -> bool {
    #[cfg(target_os = "linux")]
    {
        attributes(path).contains(rustix::fs::StatxAttributes::MOUNT_ROOT)
    }
    #[cfg(not(target_os = "linux"))]
    {
        let _ = path;
        false
    }
}

/// What the system says of a file; nothing where it is not known.
#[cfg(target_os = "linux")]
fn attributes(path: &Path) -> rustix::fs::StatxAttributes {
    use rustix::fs::{AtFlags, CWD, StatxAttributes, StatxFlags, statx};
    let found = statx(CWD, path, AtFlags::SYMLINK_NOFOLLOW, StatxFlags::empty());
    found.map_or(StatxAttributes::empty(), |found| found.stx_attributes & found.stx_attributes_mask)
}
