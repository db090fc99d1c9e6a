//! The scene that is asked for: read, overridden, validated.

use catoptric_scene::{Material, Plane, Primitive, Scene, Sphere};

use super::options::Options;
use crate::exit::Failure;

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
    let (mut document, text) = crate::scene::document(&options.scene, options.memory_limit.0)?;
    options.override_scene(document.draft_mut());
    let scene = document.into_scene().map_err(Failure::bad_input)?;
    let (spheres, planes) = (scene.spheres.len(), scene.planes.len());
    let stated = spheres * size_of::<Sphere>() + planes * size_of::<Plane>();
    let compiled = (spheres + planes) * (size_of::<Primitive>() + size_of::<Material>());
    let bytes = (text + stated + compiled) as u64;
    Ok(Loaded { scene, bytes })
}
