//! A scene of the command line, as its file states it.

use std::path::Path;

use catoptric_scene::{Document, Scene, SceneFormat};

use crate::exit::Failure;
use crate::input::{self, is_stream};

/// The longest scene that is read.
const SCENE_BYTES: u64 = 2 << 30;

/// Reads a scene; `-` is stdin.
///
/// # Errors
/// Exit code 3.
pub(crate) fn read(path: &Path) -> Result<Scene, Failure> {
    let (document, _) = document(path, SCENE_BYTES)?;
    document.into_scene().map_err(Failure::bad_input)
}

/// Reads a scene of at most that many bytes, not yet validated, and says how many it has.
///
/// # Errors
/// Exit code 3.
pub(crate) fn document(path: &Path, limit: u64) -> Result<(Document, usize), Failure> {
    let text = input::read(path, limit)?;
    let format =
        if is_stream(path) { SceneFormat::of_text(&text) } else { SceneFormat::of_path(path) };
    let document = Document::parse(&input::name(path), &text, format);
    Ok((document.map_err(Failure::bad_input)?, text.len()))
}
