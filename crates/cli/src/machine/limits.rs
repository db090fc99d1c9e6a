//! Limits that the caller sets on a process, as the shell's `ulimit` shows them.

/// Bytes of address space that all of the process may take; `None` for no limit.
pub(crate) fn address_space() -> Option<u64> {
    #[cfg(unix)]
    return rustix::process::getrlimit(rustix::process::Resource::As).current;
    #[cfg(not(unix))]
    None
}

/// Bytes that the first thread's stack may take; `None` for no limit.
pub(crate) fn stack() -> Option<u64> {
    #[cfg(unix)]
    return rustix::process::getrlimit(rustix::process::Resource::Stack).current;
    #[cfg(not(unix))]
    None
}
