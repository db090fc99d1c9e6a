//! The scene that is asked for: read, overridden, validated.

use catoptric_core::cone_bytes;
use catoptric_scene::{Draft, Light, Plane, Scene, Sphere};

use super::options::Options;
use crate::exit::Failure;

/// A valid scene.
pub(super) struct Loaded {
    pub(super) scene: Scene,
    /// Bytes that it takes at most: its text, what is stated, and what the engines make of it.
    pub(super) bytes: u64,
}

/// Reads the scene and sets what the options say.
///
/// # Errors
/// Exit code 3.
pub(super) fn load(options: &Options) -> Result<Loaded, Failure> {
    let (mut document, text) =
        crate::scene::document(&options.scene, options.memory_limit.0, "raise --memory-limit")?;
    options.override_scene(document.draft_mut());
    let scene = document.into_scene().map_err(Failure::bad_scene)?;
    let bytes = text + stated(&scene) + made(&scene);
    Ok(Loaded { scene, bytes })
}

/// Bytes of a scene as stated.
fn stated(scene: &Draft) -> u64 {
    let lights = scene.lights.capacity() * size_of::<Light>();
    let spheres = scene.spheres.capacity() * size_of::<Sphere>();
    let planes = scene.planes.capacity() * size_of::<Plane>();
    (lights + scene.materials.bytes() + spheres + planes) as u64
}

/// Bytes that an engine makes of a sphere or plane, at most, while it compiles, plans and traces:
/// measured where each has a material of its own, the most that there are.
const BODY_BYTES: u64 = 320;

/// Bytes that a light takes at most, as above.
const LIGHT_BYTES: u64 = 120;

/// Bytes that an engine makes of a scene, at most.
fn made(scene: &Draft) -> u64 {
    let (lights, spheres) = (scene.lights.len(), scene.spheres.len());
    let cones = cone_bytes(spheres, lights) as u64;
    let (lights, bodies) = (lights as u64, (spheres + scene.planes.len()) as u64);
    bodies * BODY_BYTES + lights * LIGHT_BYTES + cones
}
