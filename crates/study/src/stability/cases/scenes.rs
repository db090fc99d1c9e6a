//! Scenes that several cases use.

use catoptric_scene::{Document, Draft, Light, Material, SceneFormat, Sphere};

use super::super::amplification::Orbit;
use super::super::generic::along;

const WORKSHOP: &str = include_str!("../../../../../scenes/workshop.toml");

/// The workshop's scene, its ground a mirror of factor `ground`.
pub(crate) fn workshop(width: u32, height: u32, max_depth: u32, ground: f64) -> Draft {
    let document = Document::parse("workshop.toml", WORKSHOP.as_bytes(), SceneFormat::Toml);
    let mut draft = document.expect("the scene of scenes/").draft().clone();
    draft.materials[draft.spheres[0].material].reflect = Some(ground);
    sized(draft, width, height, max_depth)
}

/// The draft with another size and depth.
pub(crate) fn sized(mut draft: Draft, width: u32, height: u32, max_depth: u32) -> Draft {
    draft.image.width = width;
    draft.image.height = height;
    draft.render.max_depth = max_depth;
    draft
}

/// A matt white material that mirrors with factor k.
pub(crate) fn mirror(k: f64) -> Material {
    Material { reflect: Some(k), ..Material::matt([1.0; 3]) }
}

/// A glossy mirror: every term of the formula counts.
pub(crate) fn glossy(k: f64) -> Material {
    Material {
        color: [0.62, 0.53, 0.41],
        diffuse: 0.57,
        specular: 0.43,
        shininess: 17.0,
        reflect: Some(k),
    }
}

/// Seen from between spheres, along an orbit that rays follow as long as f64 can aim them, with
/// a field of view of `degrees`; under a bright sky.
pub(crate) fn between_balls(orbit: &Orbit, degrees: f64, k: f64, max_depth: u32) -> Draft {
    let aimed = orbit.aimed(3, max_depth as usize);
    let ahead = aimed.direction().to_array();
    let mut draft = aimed.scene.into_draft();
    let eye = draft.camera.position;
    draft.camera.look_at = along(eye, ahead, 64.0);
    draft.camera.up = Orbit::plane_normal().to_array();
    draft.camera.fov = degrees;
    draft.render.background = [0.3, 0.5, 0.7];
    draft.lights.push(Light { position: along(eye, [11.0, 13.0, 7.0], 1.0), intensity: [0.8; 3] });
    draft.materials.iter_mut().for_each(|material| *material = glossy(k));
    sized(draft, 40, 30, max_depth)
}

/// An empty mirror sphere of radius 10 around the eye, without lights: each reflection adds
/// the ambient light, 0.1, and a ray that leaks adds the background, 1e6.
pub(crate) fn empty_room(width: u32, height: u32, max_depth: u32, k: f64) -> Draft {
    let mut draft = Draft::default();
    draft.camera.position = [1.37, -0.71, 6.13];
    draft.camera.look_at = [-0.41, 0.37, 0.19];
    draft.camera.fov = 70.0;
    draft.render.background = [1e6; 3];
    draft.spheres.push(Sphere {
        center: [0.23, 0.11, -0.31],
        radius: 10.0,
        material: draft.materials.add(mirror(k)),
    });
    sized(draft, width, height, max_depth)
}
