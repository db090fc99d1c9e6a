//! Paths of keys: `spheres[2].radius`, indices from 0.

use std::fmt;

use super::shown;

/// One step of a path.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) enum Segment {
    /// A key of a table.
    Key(String),
    /// An index into an array.
    Index(usize),
}

/// The path of a key from the top of the scene; empty for the top itself.
#[derive(Clone, Debug, Default, PartialEq, Eq)]
pub(crate) struct KeyPath(pub(crate) Vec<Segment>);

/// A path that is being walked, linked from leaf to root on the stack. So walking a scene without
/// faults allocates nothing for paths.
#[derive(Clone, Copy, Debug)]
pub(crate) enum Trail<'a> {
    Root,
    Key(&'a Trail<'a>, &'a str),
    Index(&'a Trail<'a>, usize),
}

impl Trail<'_> {
    /// The path of a key below this path.
    pub(crate) fn key<'a>(&'a self, key: &'a str) -> Trail<'a> {
        Trail::Key(self, key)
    }

    /// The path of an entry below this path.
    pub(crate) fn index(&self, index: usize) -> Trail<'_> {
        Trail::Index(self, index)
    }
}

impl From<Trail<'_>> for KeyPath {
    fn from(trail: Trail<'_>) -> Self {
        let mut segments = Vec::new();
        let mut rest = &trail;
        loop {
            match rest {
                Trail::Root => break,
                Trail::Key(parent, key) => {
                    segments.push(Segment::Key((*key).to_owned()));
                    rest = parent;
                }
                Trail::Index(parent, index) => {
                    segments.push(Segment::Index(*index));
                    rest = parent;
                }
            }
        }
        segments.reverse();
        Self(segments)
    }
}

impl KeyPath {
    /// Writes the path in at most about `most` columns; a long key keeps its two ends.
    pub(super) fn shown(&self, most: usize) -> String {
        shown(&self.text(|key| shown(key, most / 2)), most)
    }

    /// Joins the segments. Keys that TOML would not take bare are quoted, control characters
    /// escaped.
    fn text(&self, short: impl Fn(&str) -> String) -> String {
        if self.0.is_empty() {
            return "top level".to_owned();
        }
        let mut text = String::new();
        for segment in &self.0 {
            match segment {
                Segment::Index(index) => text += &format!("[{index}]"),
                Segment::Key(key) => {
                    if !text.is_empty() {
                        text.push('.');
                    }
                    let bare = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
                    if !key.is_empty() && key.chars().all(bare) {
                        text += &short(key);
                    } else {
                        text += &short(&format!("{key:?}"));
                    }
                }
            }
        }
        text
    }
}

impl fmt::Display for KeyPath {
    /// The whole path, however long its keys are.
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(&self.text(str::to_owned))
    }
}
