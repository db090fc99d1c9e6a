//! How the program ends: exit codes, and the message that says why.

use std::fmt;
use std::io::{self, Write};
use std::process::ExitCode;

use catoptric_scene::{SceneError, shown};

/// Columns of a file's name among words on stdout.
pub(crate) const NAME: usize = 480;

/// Columns of a message: half a screen of 80 x 24.
const MESSAGE: usize = 960;

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
/// without a full stop; only a scene's may have more than one line. It does nothing to a
/// terminal, whatever names and texts of others are in it, and fits its screen.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Failure {
    pub(crate) exit: Exit,
    message: String,
}

impl Failure {
    /// A message of one line.
    fn new(exit: Exit, message: impl fmt::Display) -> Self {
        Self { exit, message: shown(&message.to_string(), MESSAGE) }
    }

    /// Exit code 1.
    pub(crate) fn failed(message: impl fmt::Display) -> Self {
        Self::new(Exit::Failed, message)
    }

    /// Exit code 2.
    pub(crate) fn wrong_use(message: impl fmt::Display) -> Self {
        Self::new(Exit::WrongUse, message)
    }

    /// Exit code 3.
    pub(crate) fn bad_input(message: impl fmt::Display) -> Self {
        Self::new(Exit::BadInput, message)
    }

    /// Exit code 3 for a scene, with its lines as they are.
    pub(crate) fn bad_scene(error: SceneError) -> Self {
        Self { exit: Exit::BadInput, message: error.to_string() }
    }

    /// Exit code 4.
    pub(crate) fn not_written(message: impl fmt::Display) -> Self {
        Self::new(Exit::NotWritten, message)
    }

    /// Says it on stderr. Where even that cannot be written, the exit code must do.
    pub(crate) fn report(&self) {
        write_stderr(format_args!("error: {}", self.message));
    }
}

/// One line on stderr, whatever names are in it.
pub(crate) fn say(line: fmt::Arguments<'_>) {
    write_stderr(format_args!("{}", shown(&line.to_string(), MESSAGE)));
}

/// Writes text and a line break. A closed stderr is no reason to stop (`eprintln!` would panic).
fn write_stderr(text: fmt::Arguments<'_>) {
    let _ = writeln!(io::stderr(), "{text}");
}
