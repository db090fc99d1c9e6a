//! The ranges of the scene format: what makes a draft a scene.
//!
//! Checks run in the order of the format, so that a message is about the first key that is
//! wrong, and later checks may rely on earlier ones.

pub mod allowed;
mod camera;
mod check;
mod material;

use std::collections::HashSet;

use crate::draft::{Body, Draft};
use crate::error::{Fault, SceneError, Trail};
use allowed::{AMOUNT, COORDINATE, LIGHT, RADIUS, SIDE};
use check::{direction, one, triple};
use material::{Brightest, material};

/// Most materials of a scene: the engine's stack holds their numbers in 22 bits.
pub const MOST_MATERIALS: usize = 4_000_000;

/// Most spheres and planes of a scene: the renderers hold their numbers in 32 bits. Memory ends far
/// below.
pub const MOST_BODIES: usize = 4_000_000_000;

/// Checks all of a draft; the fault is about the first key that is wrong.
pub(crate) fn validate(draft: &Draft) -> Result<(), SceneError> {
    validate_settings(draft)?;
    let brightest = Brightest::of(draft);
    validate_materials(draft, &brightest)?;
    validate_bodies(draft, &brightest)?;
    Ok(())
}

/// Checks what comes before the materials: picture, camera, rendering, lights.
fn validate_settings(draft: &Draft) -> Result<(), Fault> {
    let image = Trail::Root.key("image");
    one(image.key("width"), f64::from(draft.image.width), &SIDE)?;
    one(image.key("height"), f64::from(draft.image.height), &SIDE)?;

    camera::camera(Trail::Root.key("camera"), &draft.camera, &draft.image)?;

    let render = Trail::Root.key("render");
    one(render.key("min_weight"), draft.render.min_weight, &AMOUNT)?;
    triple(render.key("background"), draft.render.background, &LIGHT)?;
    triple(render.key("ambient"), draft.render.ambient, &AMOUNT)?;

    let lights = Trail::Root.key("lights");
    for (index, light) in draft.lights.iter().enumerate() {
        let trail = lights.index(index);
        triple(trail.key("position"), light.position, &COORDINATE)?;
        triple(trail.key("intensity"), light.intensity, &AMOUNT)?;
    }
    Ok(())
}

/// Checks the number of materials, and the materials that have a name. Others are checked with the
/// first body that has them, as the file states them there, or after the bodies if none has.
fn validate_materials(draft: &Draft, brightest: &Brightest) -> Result<(), Fault> {
    let materials = &draft.materials;
    let trail = Trail::Root.key("materials");
    if materials.len() > MOST_MATERIALS {
        let found = format!("{} materials", materials.len());
        let allowed =
            format!("at most {MOST_MATERIALS}; bodies that name the same material share it");
        return Err(Fault::new(trail, found, allowed));
    }
    let mut names = HashSet::new();
    for (name, stated) in materials.named() {
        if !names.insert(name) {
            let allowed = "a name that no other material has";
            return Err(Fault::new(trail.key(name), "it twice".to_owned(), allowed));
        }
        material(trail.key(name), stated, brightest)?;
    }
    Ok(())
}

/// Checks spheres and planes, each with the material that it states, and then the materials that
/// nothing names.
fn validate_bodies(draft: &Draft, brightest: &Brightest) -> Result<(), Fault> {
    let (spheres, planes) = (Trail::Root.key("spheres"), Trail::Root.key("planes"));
    let bodies = draft.spheres.len() + draft.planes.len();
    if bodies > MOST_BODIES {
        let found = format!("{bodies} spheres and planes");
        return Err(Fault::new(spheres, found, format!("at most {MOST_BODIES} of them")));
    }

    // Materials that no body has so far: the first body with one checks it.
    let mut unseen = vec![true; draft.materials.len()];
    for (place, body) in draft.bodies().enumerate() {
        let trail = match body {
            Body::Sphere(_) => spheres.index(place),
            Body::Plane(_) => planes.index(place - draft.spheres.len()),
        };

        // Place and size.
        match body {
            Body::Sphere(sphere) => {
                triple(trail.key("center"), sphere.center, &COORDINATE)?;
                one(trail.key("radius"), sphere.radius, &RADIUS)?;
            }
            Body::Plane(plane) => {
                triple(trail.key("point"), plane.point, &COORDINATE)?;
                direction(trail.key("normal"), plane.normal)?;
            }
        }

        // Material: checked once, with the first body that states it.
        let id = body.material();
        let Some(stated) = draft.materials.get(id) else {
            let found = format!("the id of material {}", id.index());
            let allowed = format!(
                "the id of one of this draft's {} materials, which `materials.add` gives",
                draft.materials.len()
            );
            return Err(Fault::new(trail.key("material"), found, allowed));
        };
        if std::mem::take(&mut unseen[id.index()]) && draft.materials.name(id).is_none() {
            material(trail, stated, brightest)?;
        }
    }

    // Only a program can state a material that has no name and no body.
    let materials = Trail::Root.key("materials");
    for (id, stated) in draft.materials.iter().filter(|(id, _)| unseen[id.index()]) {
        material(materials.index(id.index()), stated, brightest)?;
    }
    Ok(())
}
