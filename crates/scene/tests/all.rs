//! Tests of the scene crate, in one binary.

mod compiled;
mod double_double;
mod drafts;
mod family;
mod film;
mod format;
mod messages;
mod overrides;
mod parts;
mod ranges;
mod reference;
mod robustness;
mod round_trip;
mod view;

use catoptric_scene::{Document, Scene, SceneError, SceneFormat};

/// The scene of a TOML text.
fn toml(text: &str) -> Result<Scene, SceneError> {
    Document::parse("a.toml", text.as_bytes(), SceneFormat::Toml)?.into_scene()
}

/// The scene of a JSON text.
fn json(text: &str) -> Result<Scene, SceneError> {
    Document::parse("a.json", text.as_bytes(), SceneFormat::Json)?.into_scene()
}
