//! The command that makes a scene again.

use std::fmt;

/// `catoptric generate FAMILY` and its options, each with its value, none left to defaults
/// that a later version might change.
#[derive(Clone, Debug)]
pub(super) struct Recipe(String);

impl Recipe {
    /// The command without options.
    pub(super) fn new(family: &str) -> Self {
        Self(format!("catoptric generate {family}"))
    }

    /// Adds an option; the value has no blanks.
    pub(super) fn with(self, option: &str, value: impl fmt::Display) -> Self {
        Self(format!("{} {option} {value}", self.0))
    }

    /// Adds an option if it has a value.
    pub(super) fn with_any(self, option: &str, value: Option<impl fmt::Display>) -> Self {
        match value {
            Some(value) => self.with(option, value),
            None => self,
        }
    }

    /// Adds a flag if it is set.
    pub(super) fn with_flag(self, flag: &str, set: bool) -> Self {
        if set { Self(format!("{} {flag}", self.0)) } else { self }
    }
}

impl fmt::Display for Recipe {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.0)
    }
}
