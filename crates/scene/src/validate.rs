//! The ranges of the scene format: what makes a draft a scene.
//!
//! Checks run in the order of the format, so that a message is about the first key that is
//! wrong, and later checks may rely on earlier ones.

pub mod allowed;
mod camera;
mod material;

use crate::direction::unit;
use crate::error::{Fault, Trail, number};
use crate::{Draft, Material, SceneError};
use allowed::{AMOUNT, Allowed, COMPONENT, COORDINATE, LIGHT, RADIUS, SIDE};
use material::Brightest;

/// Spheres and planes that a scene may have: the engine's stack counts their materials in 22 bits.
pub const MOST_PRIMITIVES: usize = 4_000_000;

/// All of a draft.
pub(crate) fn validate(draft: &Draft) -> Result<(), SceneError> {
    validate_settings(draft)?;
    validate_bodies(draft)?;
    Ok(())
}

/// What comes before the materials: picture, camera, rendering, lights.
pub(crate) fn validate_settings(draft: &Draft) -> Result<(), Fault> {
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

/// Materials that have a name, in the light of a draft whose settings are valid.
pub(crate) fn validate_materials(
    draft: &Draft,
    materials: &[(String, Material)],
) -> Result<(), Fault> {
    let brightest = Brightest::of(draft);
    let trail = Trail::Root.key("materials");
    materials
        .iter()
        .try_for_each(|(name, stated)| material::material(trail.key(name), stated, &brightest))
}

/// Spheres and planes, in the light of a draft whose settings are valid.
fn validate_bodies(draft: &Draft) -> Result<(), Fault> {
    let spheres = Trail::Root.key("spheres");
    let bodies = draft.spheres.len() + draft.planes.len();
    if bodies > MOST_PRIMITIVES {
        let found = format!("{bodies} spheres and planes");
        return Err(Fault::new(spheres, found, format!("at most {MOST_PRIMITIVES} of them")));
    }
    let brightest = Brightest::of(draft);
    for (index, sphere) in draft.spheres.iter().enumerate() {
        let trail = spheres.index(index);
        triple(trail.key("center"), sphere.center, &COORDINATE)?;
        one(trail.key("radius"), sphere.radius, &RADIUS)?;
        material::material(trail, &sphere.material, &brightest)?;
    }
    let planes = Trail::Root.key("planes");
    for (index, plane) in draft.planes.iter().enumerate() {
        let trail = planes.index(index);
        triple(trail.key("point"), plane.point, &COORDINATE)?;
        direction(trail.key("normal"), plane.normal)?;
        material::material(trail, &plane.material, &brightest)?;
    }
    Ok(())
}

/// One number in its range.
fn one(trail: Trail<'_>, x: f64, allowed: &Allowed) -> Result<(), Fault> {
    if allowed.holds(x) { Ok(()) } else { Err(Fault::new(trail, number(x), allowed.text)) }
}

/// Three numbers, each in that range; the message is about the one that is not.
fn triple(trail: Trail<'_>, v: [f64; 3], allowed: &Allowed) -> Result<(), Fault> {
    v.into_iter().enumerate().try_for_each(|(axis, x)| one(trail.index(axis), x, allowed))
}

/// A direction of any length but zero, as a unit vector.
fn direction(trail: Trail<'_>, v: [f64; 3]) -> Result<[f64; 3], Fault> {
    triple(trail, v, &COMPONENT)?;
    unit(v).ok_or_else(|| Fault::new(trail, list(v), "a direction that is not zero"))
}

/// Three numbers as messages show them.
fn list(v: [f64; 3]) -> String {
    format!("[{}]", v.map(number).join(", "))
}
