//! Scenes for the tests, and their pictures.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::{
    Compiled, Document, Draft, Film, Grid, Image, Light, Material, MaterialId, Materials, Numerics,
    Scene, SceneFormat, Sphere, View,
};
use catoptric_study::metrics::widened;

const WORKSHOP: &str = include_str!("../../../scenes/workshop.toml");

/// The workshop's scene to depth 8, its ground a mirror of factor 0.3.
pub(crate) fn workshop(width: u32, height: u32, numerics: Numerics) -> Scene {
    let document = Document::parse("workshop.toml", WORKSHOP.as_bytes(), SceneFormat::Toml);
    let mut draft = document.expect("a scene of scenes/").draft().clone();
    draft.image = Image { width, height, ..draft.image };
    draft.render.max_depth = 8;
    draft.render.numerics = numerics;
    draft.materials[draft.spheres[0].material].reflect = Some(0.3);
    Scene::new(draft).expect("valid")
}

/// Looks along -z from the origin at spheres that [`matt`] made; a lamp at `lamp`.
pub(crate) fn seen(image: [u32; 2], fov: f64, lamp: [f64; 3], spheres: &[Sphere]) -> Draft {
    let mut draft = Draft {
        image: Image { width: image[0], height: image[1], ..Image::default() },
        lights: vec![Light { position: lamp, intensity: [1.0; 3] }],
        materials: only_matt().0,
        spheres: spheres.to_vec(),
        ..Draft::default()
    };
    draft.camera.fov = fov;
    draft
}

/// One matt material, as every draft of [`seen`] has it.
fn only_matt() -> (Materials, MaterialId) {
    let mut materials = Materials::default();
    let id = materials.add(Material::matt([0.8, 0.7, 0.6]));
    (materials, id)
}

/// A matt sphere for [`seen`].
pub(crate) fn matt(center: [f64; 3], radius: f64) -> Sphere {
    Sphere { center, radius, material: only_matt().1 }
}

pub(crate) fn scene(draft: Draft) -> Scene {
    Scene::new(draft).expect("a valid scene")
}

/// The f32 picture and truth's.
pub(crate) fn pictures(scene: &Scene) -> (Vec<[f64; 3]>, Vec<[f64; 3]>) {
    let view = View::whole(scene);
    let mut film = Film::new(scene.image.width, scene.image.height);
    let compiled = Compiled::new(scene);
    catoptric_reference::render(&compiled, &Grid::new(&view), &mut film, &|_| ()).expect("shallow");
    let truth = Truth::new(scene, Precision::DoubleDouble).render(&view).expect("shallow");
    (widened(film.pixels()), truth.pixels)
}
