//! A scene of the command line, as its file states it.

use std::path::Path;

use catoptric_scene::{Document, Scene, SceneFormat};

use crate::exit::Failure;
use crate::input::{self, is_stream};

/// Bytes that a scene may take where no limit can be given: its text and what is made of it.
const SCENE_BYTES: u64 = 2 << 30;

/// Reads a scene; `-` is stdin.
///
/// # Errors
/// Exit code 3.
pub(crate) fn read(path: &Path) -> Result<Scene, Failure> {
    let (document, _) = document(path, SCENE_BYTES, "a scene may take that much")?;
    document.into_scene().map_err(Failure::bad_scene)
}

/// Reads a scene, not yet validated, and says how many bytes its text has. It takes at most
/// `limit` bytes of memory; `advice` says what to do where that is too little.
///
/// # Errors
/// Exit code 3.
pub(crate) fn document(path: &Path, limit: u64, advice: &str) -> Result<(Document, u64), Failure> {
    let text = input::read(path, limit, advice)?;
    let format =
        if is_stream(path) { SceneFormat::of_text(&text) } else { SceneFormat::of_path(path) };
    let bytes = text.capacity() as u64;
    let left = limit.saturating_sub(bytes);
    let document = Document::parse_within(&input::name(path), text, format, left);
    let document = document.map_err(|error| {
        if error.is_over_limit() {
            Failure::bad_input(format_args!("{error}: {advice}"))
        } else {
            Failure::bad_scene(error)
        }
    })?;
    Ok((document, bytes))
}
