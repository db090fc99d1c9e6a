//! What can be wrong with a scene, said in terms of the user's file.

mod excerpt;
mod fault;
mod key_path;
mod shown;

pub(crate) use fault::{Fault, Target, number};
pub(crate) use key_path::{KeyPath, Segment, Trail};
pub use shown::{is_visible, shown};

use std::fmt;
use std::ops::Range;

use excerpt::NAME;

/// A scene that cannot be used.
///
/// Display is the whole message for people: the file (where there is one), the key's path,
/// what was found and what is allowed; for TOML then a line `--> file:line:column` and the
/// line itself; for JSON `line L column C` where that is known. It may have several lines
/// and does not end in a line break. Key paths are written like `spheres[2].radius` and
/// count from 0. What comes from the file or its name is written as [`shown`] writes it, so
/// the message does nothing to a terminal and fits its screen.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}", Report(self))]
pub struct SceneError {
    file: Option<String>,
    /// What is wrong; boxed, to keep every `Result` on the way small.
    problem: Box<Problem>,
    place: Place,
}

/// Most columns of a parser's message.
const MESSAGE: usize = 480;

/// What is wrong with a scene.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
pub(crate) enum Problem {
    #[error("the file is empty; a scene needs at least one table, such as [image]")]
    Empty,
    #[error("the file is UTF-16 text; save it as UTF-8")]
    Utf16,
    #[error("byte {0} (counted from 0) is not UTF-8 text; a scene is TOML or JSON in UTF-8")]
    NotText(usize),
    #[error("{}", shown(.0, MESSAGE))]
    Syntax(String),
    #[error("{0}")]
    Key(Fault),
    #[error("reading it takes more than the {0} bytes of memory that the limit leaves for it")]
    Limit(u64),
    #[error("reading it needs {0} more bytes of memory, which the system does not grant")]
    NotGranted(u64),
}

/// Place of a problem in the file.
#[derive(Clone, Debug, PartialEq)]
enum Place {
    /// No place: the scene has no text, or the problem is the text as a whole.
    Unknown,
    /// The text does not hold the value: a default, or set after reading.
    NotInFile,
    /// A place in the text. Line and column count from 1, the column in characters; the excerpt
    /// is for TOML.
    At { line: usize, column: usize, excerpt: Option<String> },
}

impl SceneError {
    /// The path of the key that is wrong, like `spheres[2].radius`; `None` where the
    /// problem is not one key: no text, broken syntax, no table at the top level.
    #[must_use]
    pub fn key(&self) -> Option<String> {
        self.fault().filter(|fault| !fault.path.0.is_empty()).map(|fault| fault.path.to_string())
    }

    /// Line and column of the problem in the file, both from 1, where they are known.
    #[must_use]
    pub fn position(&self) -> Option<(usize, usize)> {
        match self.place {
            Place::At { line, column, .. } => Some((line, column)),
            Place::Unknown | Place::NotInFile => None,
        }
    }

    /// Whether the scene is refused because reading it takes more memory than the caller's limit.
    /// Nothing else need be wrong with it.
    #[must_use]
    pub fn is_over_limit(&self) -> bool {
        matches!(*self.problem, Problem::Limit(_))
    }

    /// A problem of a whole file.
    pub(crate) fn of_file(file: &str, problem: Problem) -> Self {
        Self { file: Some(file.to_owned()), problem: Box::new(problem), place: Place::Unknown }
    }

    /// The fault; `None` unless the problem is one key.
    pub(crate) fn fault(&self) -> Option<&Fault> {
        match self.problem.as_ref() {
            Problem::Key(fault) => Some(fault),
            Problem::Empty
            | Problem::Utf16
            | Problem::NotText(_)
            | Problem::Syntax(_)
            | Problem::Limit(_)
            | Problem::NotGranted(_) => None,
        }
    }

    /// Adds the place in a TOML text, some bytes of it, and an excerpt that shows the line.
    pub(crate) fn shown(mut self, file: &str, text: &str, span: Range<usize>) -> Self {
        self = self.at(file, text, span.start);
        if let Place::At { line, excerpt, .. } = &mut self.place {
            *excerpt = Some(excerpt::render(file, text, *line, span));
        }
        self
    }

    /// Adds the place in a file's text, one byte of it.
    pub(crate) fn at(self, file: &str, text: &str, byte: usize) -> Self {
        let (line, column) = excerpt::line_column(text, byte);
        let place = Place::At { line, column, excerpt: None };
        Self { file: Some(file.to_owned()), place, ..self }
    }

    /// Adds that the value is not in the file.
    pub(crate) fn not_in_file(self, file: &str) -> Self {
        Self { file: Some(file.to_owned()), place: Place::NotInFile, ..self }
    }
}

impl From<Problem> for SceneError {
    fn from(problem: Problem) -> Self {
        Self { file: None, problem: Box::new(problem), place: Place::Unknown }
    }
}

impl From<Fault> for Problem {
    fn from(fault: Fault) -> Self {
        Self::Key(fault)
    }
}

impl From<Fault> for SceneError {
    fn from(fault: Fault) -> Self {
        Problem::Key(fault).into()
    }
}

/// The message for people.
struct Report<'a>(&'a SceneError);

impl fmt::Display for Report<'_> {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let SceneError { file, problem, place } = self.0;
        if let Some(file) = file {
            write!(f, "{}: ", shown(file, NAME))?;
        }
        write!(f, "{problem}")?;
        match place {
            Place::Unknown => Ok(()),
            Place::NotInFile => {
                write!(f, " (not in the file: a default, or set after the file was read)")
            }
            Place::At { excerpt: Some(excerpt), .. } => write!(f, "\n{excerpt}"),
            Place::At { line, column, excerpt: None } => {
                write!(f, "; at line {line} column {column}")
            }
        }
    }
}
