//! Text to scene.
//!
//! Both formats become values (`value`), which one reader turns into a [`Draft`] (`draft`,
//! `table`), so that they cannot differ. Lights, bodies and materials come one by one, and the
//! values of each are dropped before the next: there is no tree of a whole scene, and what is kept
//! is counted (`memory`). Values hold no places in the text: when a key is wrong, and only then,
//! the text is parsed once more and the key's path walked in it (`locate` of `toml` and of `json`).

mod draft;
mod json;
mod located;
mod memory;
mod nearest;
mod table;
mod text;
mod toml;
mod value;

use std::ops::Range;
use std::path::Path;

use crate::error::{KeyPath, Problem, Target};
use crate::{Draft, Scene, SceneError};
use draft::Reader;
use located::Located;
use memory::Memory;

/// The language of a scene file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum SceneFormat {
    /// TOML, for people.
    Toml,
    /// JSON, for programs; the same keys.
    Json,
}

impl SceneFormat {
    /// Tells the format by a file's name: JSON if it ends in `.json` (in any case), otherwise TOML.
    #[must_use]
    pub fn of_path(path: &Path) -> Self {
        let json = path.extension().is_some_and(|ending| ending.eq_ignore_ascii_case("json"));
        if json { Self::Json } else { Self::Toml }
    }

    /// Tells the format by the text, for a scene without a name: JSON if the first byte that is not
    /// blank is `{`, otherwise TOML.
    #[must_use]
    pub fn of_text(text: &[u8]) -> Self {
        if text::starts_like_json(text) { Self::Json } else { Self::Toml }
    }
}

/// A scene file that was read: its text and the draft that it states.
///
/// Change the draft at will (as a program's options do), then make it a scene. An error
/// names the file and the place of the wrong value, if that value came from the file.
#[derive(Clone, Debug)]
pub struct Document {
    name: String,
    text: String,
    format: SceneFormat,
    draft: Draft,
}

impl Document {
    /// Reads a scene's text. `name` stands for the file in messages.
    ///
    /// A byte order mark is skipped. Keys that are absent take their defaults.
    ///
    /// # Errors
    /// No text at all (zero bytes, or only white space), text that is not UTF-8 or not of
    /// that format, nested deeper than any scene needs, a key twice, an unknown key, a
    /// value of the wrong type, a required key that is missing, an unknown material, a
    /// material named and stated inline. Ranges are not checked here.
    pub fn parse(name: &str, bytes: &[u8], format: SceneFormat) -> Result<Self, SceneError> {
        Self::parse_within(name, bytes.to_vec(), format, u64::MAX)
    }

    /// Reads a scene's text as [`Document::parse`] does, and takes at most `limit` bytes of memory
    /// for it beside the text itself, which is not copied.
    ///
    /// # Errors
    /// As for [`Document::parse`]; and more memory is needed than the limit, or than the system
    /// grants. The memory has not been taken then.
    pub fn parse_within(
        name: &str,
        bytes: Vec<u8>,
        format: SceneFormat,
        limit: u64,
    ) -> Result<Self, SceneError> {
        let text = text::text(name, bytes)?;
        let mut reader = Reader::new(Memory::new(limit));
        match format {
            SceneFormat::Toml => toml::read(name, &text, &mut reader)?,
            SceneFormat::Json => json::read(name, &text, &mut reader)?,
        }
        let draft =
            reader.finish().map_err(|problem| locate_stated(name, &text, format, problem))?;
        Ok(Self { name: name.to_owned(), text, format, draft })
    }

    /// The name that messages use.
    #[must_use]
    pub fn name(&self) -> &str {
        &self.name
    }

    /// What the file states, or what was made of it.
    #[must_use]
    pub fn draft(&self) -> &Draft {
        &self.draft
    }

    /// The draft, for settings that override the file.
    pub fn draft_mut(&mut self) -> &mut Draft {
        &mut self.draft
    }

    /// Validates the draft.
    ///
    /// # Errors
    /// The first key, in the order of the format, whose value is not allowed.
    pub fn into_scene(mut self) -> Result<Scene, SceneError> {
        let draft = std::mem::take(&mut self.draft);
        Scene::new(draft).map_err(|error| self.locate_found(error))
    }

    /// Adds the place of a value that is out of range, if the file holds that value.
    fn locate_found(&self, error: SceneError) -> SceneError {
        let Some(fault) = error.fault() else {
            return error;
        };
        let located = locate(&self.text, self.format, &fault.path, Target::Value);
        match located {
            Some(located) if located.value.describe() == fault.found => {
                // `ambient = -1` stands for three numbers; the file has no `ambient[0]`.
                let mut fault = fault.clone();
                fault.path.0.truncate(located.depth);
                place(&self.name, &self.text, self.format, fault.into(), located.span)
            }
            _ => error.not_in_file(&self.name),
        }
    }
}

/// Adds the place of what the text states wrongly. A key that is missing is shown at the
/// table that lacks it.
fn locate_stated(name: &str, text: &str, format: SceneFormat, problem: Problem) -> SceneError {
    let Problem::Key(fault) = problem else {
        return SceneError::of_file(name, problem);
    };
    let mut path = fault.path.clone();
    loop {
        if let Some(located) = locate(text, format, &path, fault.target) {
            return place(name, text, format, fault.into(), located.span);
        }
        // The top level is always there, and has no place of its own worth showing.
        if path.0.len() <= 1 {
            return SceneError::of_file(name, Problem::Key(fault));
        }
        path.0.pop();
    }
}

fn place(
    name: &str,
    text: &str,
    format: SceneFormat,
    error: SceneError,
    span: Range<usize>,
) -> SceneError {
    match format {
        SceneFormat::Toml => error.shown(name, text, span),
        SceneFormat::Json => error.at(name, text, span.start),
    }
}

/// Finds a key; `None` if the text does not have it.
fn locate(text: &str, format: SceneFormat, path: &KeyPath, target: Target) -> Option<Located> {
    match format {
        SceneFormat::Toml => toml::locate(text, &path.0, target),
        SceneFormat::Json => json::locate(text, &path.0),
    }
}
