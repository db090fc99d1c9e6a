//! The scene that is asked for: read, overridden, validated.

use std::path::Path;

use catoptric_scene::{Document, Material, Plane, Primitive, Scene, SceneFormat, Sphere};

use super::options::Options;
use crate::exit::Failure;
use crate::input;

/// A valid scene.
pub(super) struct Loaded {
    pub(super) scene: Scene,
    /// Bytes that it takes: its text and its primitives, also in their compiled form.
    pub(super) bytes: u64,
}

/// Reads the scene and sets what the options say.
///
/// # Errors
/// Exit code 3.
pub(super) fn load(options: &Options) -> Result<Loaded, Failure> {
    let path = options.scene.as_path();
    let text = input::read(path, options.memory_limit.0)?;
    let format = format(path, &text);
    let mut document =
        Document::parse(&input::name(path), &text, format).map_err(Failure::bad_input)?;
    options.override_scene(document.draft_mut());
    let scene = document.into_scene().map_err(Failure::bad_input)?;
    let (spheres, planes) = (scene.spheres.len(), scene.planes.len());
    let stated = spheres * size_of::<Sphere>() + planes * size_of::<Plane>();
    let compiled = (spheres + planes) * (size_of::<Primitive>() + size_of::<Material>());
    let bytes = (text.len() + stated + compiled) as u64;
    Ok(Loaded { scene, bytes })
}

fn format(path: &Path, text: &[u8]) -> SceneFormat {
    if input::is_stream(path) { SceneFormat::of_text(text) } else { SceneFormat::of_path(path) }
}
