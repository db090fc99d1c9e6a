//! One key that is wrong.

use super::{KeyPath, Trail, shown};

/// Most columns of a key's path; one key in it takes at most half as many.
const PATH: usize = 160;

/// Most columns of what was found.
const FOUND: usize = 160;

/// Most columns of what is allowed, which may list names of the file.
const ALLOWED: usize = 480;

/// What a message about a key points at.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Target {
    /// What the key holds.
    Value,
    /// The key itself: it should not be there.
    Key,
}

/// A key that is wrong: where, what was found, what is allowed.
#[derive(Clone, Debug, PartialEq, thiserror::Error)]
#[error("{}: found {}; allowed: {}", .path.shown(PATH), shown(.found, FOUND), shown(.allowed, ALLOWED))]
pub(crate) struct Fault {
    pub(crate) path: KeyPath,
    /// What was found, in words. A value that is out of range stands exactly as `number` writes it.
    pub(crate) found: String,
    pub(crate) allowed: String,
    pub(crate) target: Target,
}

impl Fault {
    /// A key whose value is wrong or missing.
    pub(crate) fn new(trail: Trail<'_>, found: String, allowed: impl Into<String>) -> Self {
        Self { path: trail.into(), found, allowed: allowed.into(), target: Target::Value }
    }

    /// A key that should not be there.
    pub(crate) fn key(trail: Trail<'_>, found: String, allowed: impl Into<String>) -> Self {
        Self { target: Target::Key, ..Self::new(trail, found, allowed) }
    }
}

/// A number as messages and files write it: the shortest text that reads back to the same bits
/// (as a float), with an exponent below 1e-5 and from 1e16 on. Legal in TOML and, where finite,
/// in JSON.
pub(crate) fn number(x: f64) -> String {
    let size = x.abs();
    if x == 0.0 {
        // A reader takes -0 without a fraction for the integer 0.
        if x.is_sign_negative() { "-0.0".to_owned() } else { "0".to_owned() }
    } else if x.is_nan() {
        "nan".to_owned()
    } else if (1e-5..1e16).contains(&size) {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}
