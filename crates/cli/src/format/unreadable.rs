//! Why a picture cannot be read.

use std::io;

use crate::exit::Failure;

/// Why a picture could not be read; the text continues the file's name.
#[derive(Debug)]
pub(super) enum Unreadable {
    /// Broken.
    Bad(String),
    /// Sound, but not what is compared here.
    Other(String),
    /// Not given by the system.
    Io(io::Error),
}

impl Unreadable {
    pub(super) fn of(self, name: &str) -> Failure {
        match self {
            Self::Bad(what) => Failure::bad_input(format_args!("{name} {what}")),
            Self::Other(what) => Failure::wrong_use(format_args!("{name} {what}")),
            Self::Io(error) => Failure::bad_input(format_args!("{name} cannot be read: {error}")),
        }
    }
}

impl From<io::Error> for Unreadable {
    fn from(error: io::Error) -> Self {
        Self::Io(error)
    }
}
