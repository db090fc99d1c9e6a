//! How the program ends: exit codes, and the message that says why.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

/// The exit codes. `--help` lists them; scripts rely on them.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Exit {
    /// Everything that was asked is done.
    Done = 0,
    /// The rendering failed, or `compare` found a difference.
    Failed = 1,
    /// The command line cannot be meant: options, sizes, formats, crops.
    WrongUse = 2,
    /// A scene or picture is missing, unreadable or bad, or needs more memory than the limit.
    BadInput = 3,
    /// Something could not be written.
    NotWritten = 4,
    /// SIGINT, SIGTERM or SIGHUP.
    Interrupted = 130,
}

impl From<Exit> for ExitCode {
    fn from(exit: Exit) -> Self {
        Self::from(exit as u8)
    }
}

/// Why the program stops early.
///
/// The message names what was found, what is allowed and what to do, without a prefix and
/// without a full stop; only a scene's may have more than one line.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Failure {
    pub(crate) exit: Exit,
    message: String,
}

impl Failure {
    /// Exit code 1.
    pub(crate) fn failed(message: impl fmt::Display) -> Self {
        Self { exit: Exit::Failed, message: message.to_string() }
    }

    /// Exit code 2.
    pub(crate) fn wrong_use(message: impl fmt::Display) -> Self {
        Self { exit: Exit::WrongUse, message: message.to_string() }
    }

    /// Exit code 3.
    pub(crate) fn bad_input(message: impl fmt::Display) -> Self {
        Self { exit: Exit::BadInput, message: message.to_string() }
    }

    /// Exit code 4.
    pub(crate) fn not_written(message: impl fmt::Display) -> Self {
        Self { exit: Exit::NotWritten, message: message.to_string() }
    }

    /// Says it on stderr. Where even that cannot be written, the exit code must do.
    pub(crate) fn report(&self) {
        say(format_args!("error: {}", self.message));
    }
}

/// One line on stderr. A closed stderr is no reason to stop (`eprintln!` would panic).
pub(crate) fn say(line: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{line}");
}
