//! Files that the caller opened: the standard streams, and others by their number.
//!
//! A closed stream cannot be seen once `main` runs: Rust opens /dev/null in its place, so that
//! no other file gets its number, and a write to it would succeed. It is looked at before.

use std::fs::File;
use std::io;

#[cfg(unix)]
use std::sync::atomic::{AtomicU8, Ordering};

/// What may be written to of 0, 1 and 2, a bit each, as the caller gave them.
#[cfg(unix)]
static WRITABLE: AtomicU8 = AtomicU8::new(0);

#[cfg(unix)]
ctor::declarative::ctor! {
    // The promise that is made here: it needs nothing of what Rust sets up before `main`.
    #[ctor(unsafe)]
    fn look() {
        use rustix::fs::{OFlags, fcntl_getfl};
        use rustix::stdio::{stderr, stdin, stdout};
        let mut writable = 0;
        for (number, stream) in [stdin(), stdout(), stderr()].into_iter().enumerate() {
            // Fails for a closed one.
            let flags = fcntl_getfl(stream);
            if flags.is_ok_and(|flags| flags.intersects(OFlags::WRONLY | OFlags::RDWR)) {
                writable |= 1 << number;
            }
        }
        WRITABLE.store(writable, Ordering::Relaxed);
    }
}

/// Finds out whether the caller opened a file with that number, and for writing.
///
/// # Errors
/// Why it cannot be written to.
#[cfg(unix)]
pub(super) fn check(number: u32) -> Result<(), String> {
    if number < 3 {
        return match WRITABLE.load(Ordering::Relaxed) >> number & 1 {
            1 => Ok(()),
            _ => Err("it is closed, or open for reading only".to_owned()),
        };
    }
    use rustix::fs::OFlags;
    let not_opened = || Err(format!("no file with number {number} was opened for it"));
    match flags(number) {
        None if std::path::Path::new(ABOUT).exists() => not_opened(),
        // The system does not say.
        None => Ok(()),
        // What this program opened itself is not passed on to others; what it was given is, or
        // it would not have got it.
        Some(flags) if flags.contains(OFlags::CLOEXEC) => not_opened(),
        Some(flags) if flags.intersects(OFlags::WRONLY | OFlags::RDWR) => Ok(()),
        Some(_) => Err("it is open for reading only".to_owned()),
    }
}

#[cfg(not(unix))]
pub(super) fn check(_: u32) -> Result<(), String> {
    Ok(())
}

/// The folder in which the system tells of open files; on Linux alone.
#[cfg(unix)]
const ABOUT: &str = "/proc/self/fdinfo";

/// The flags of an open file.
#[cfg(unix)]
fn flags(number: u32) -> Option<rustix::fs::OFlags> {
    let about = std::fs::read_to_string(format!("{ABOUT}/{number}")).ok()?;
    let flags = about.lines().find_map(|line| line.strip_prefix("flags:"))?;
    let flags = u32::from_str_radix(flags.trim(), 8).ok()?;
    Some(rustix::fs::OFlags::from_bits_retain(flags))
}

/// The open file itself, under another number: what is written goes on where the caller is in
/// it, at its end if the caller appends.
///
/// # Errors
/// The system's.
#[cfg(unix)]
pub(super) fn open(number: u32) -> io::Result<File> {
    use rustix::stdio::{stderr, stdin, stdout};
    let stream = match number {
        0 => stdin(),
        1 => stdout(),
        2 => stderr(),
        _ => return by_number(number),
    };
    Ok(stream.try_clone_to_owned()?.into())
}

#[cfg(target_os = "linux")]
fn by_number(number: u32) -> io::Result<File> {
    use rustix::process::{PidfdFlags, PidfdGetfdFlags, getpid, pidfd_getfd, pidfd_open};
    let this = pidfd_open(getpid(), PidfdFlags::empty());
    let asked = i32::try_from(number).map_err(io::Error::other)?;
    match this.and_then(|this| pidfd_getfd(this, asked, PidfdGetfdFlags::empty())) {
        Ok(file) => Ok(file.into()),
        // Containers forbid it. Opened once more, a pipe or device is the same, and so is a file
        // that is appended to; another file would be written from its beginning.
        Err(refused) => {
            use rustix::fs::OFlags;
            let path = format!("/proc/self/fd/{number}");
            let appends = flags(number).is_some_and(|flags| flags.contains(OFlags::APPEND));
            if std::fs::metadata(&path)?.is_file() && !appends {
                return Err(refused.into());
            }
            std::fs::OpenOptions::new().write(true).append(appends).open(path)
        }
    }
}

/// Elsewhere than on Linux, opening the name gives the open file itself.
#[cfg(all(unix, not(target_os = "linux")))]
fn by_number(number: u32) -> io::Result<File> {
    std::fs::OpenOptions::new().write(true).open(format!("/dev/fd/{number}"))
}

#[cfg(not(unix))]
pub(super) fn open(number: u32) -> io::Result<File> {
    use std::os::windows::io::AsHandle;
    let stream = match number {
        1 => io::stdout().as_handle().try_clone_to_owned()?,
        2 => io::stderr().as_handle().try_clone_to_owned()?,
        _ => return Err(io::ErrorKind::Unsupported.into()),
    };
    Ok(stream.into())
}
