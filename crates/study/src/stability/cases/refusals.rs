//! What is not a scene: each is refused by an error that names the key.

use catoptric_scene::{Draft, Light, Material, Plane, Scene, Sphere};

use super::super::finding::{Effort, Finding, Findings};
use super::scenes::mirror;

/// A number of a draft, the key that an error names it by, and values that are not allowed.
type Number = (&'static str, fn(&mut Draft) -> &mut f64, &'static [f64]);

const NONE: &[f64] = &[f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const NOT_NEGATIVE: &[f64] = &[-1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const POSITIVE: &[f64] = &[0.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY, 1e-30, 1e20];
const ANGLE: &[f64] = &[0.0, -30.0, 180.0, 360.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
const FACTOR: &[f64] = &[2.0, -1.0, f64::NAN, f64::INFINITY, f64::NEG_INFINITY];

const NUMBERS: &[Number] = &[
    (
        "spheres[0].reflect",
        |d| d.materials[d.spheres[0].material].reflect.get_or_insert(0.0),
        FACTOR,
    ),
    ("spheres[0].specular", specular_as_mirror, FACTOR),
    ("spheres[0].radius", |d| &mut d.spheres[0].radius, POSITIVE),
    ("spheres[0].center[1]", |d| &mut d.spheres[0].center[1], NONE),
    ("spheres[0].color[0]", |d| &mut d.materials[d.spheres[0].material].color[0], NOT_NEGATIVE),
    ("spheres[0].diffuse", |d| &mut d.materials[d.spheres[0].material].diffuse, NOT_NEGATIVE),
    ("spheres[0].shininess", |d| &mut d.materials[d.spheres[0].material].shininess, NOT_NEGATIVE),
    ("planes[0].point[2]", |d| &mut d.planes[0].point[2], NONE),
    ("planes[0].normal[0]", |d| &mut d.planes[0].normal[0], NONE),
    ("lights[0].position[0]", |d| &mut d.lights[0].position[0], NONE),
    ("lights[0].intensity[2]", |d| &mut d.lights[0].intensity[2], NOT_NEGATIVE),
    ("camera.position[0]", |d| &mut d.camera.position[0], NONE),
    ("camera.look_at[2]", |d| &mut d.camera.look_at[2], NONE),
    ("camera.up[1]", |d| &mut d.camera.up[1], NONE),
    ("camera.fov", |d| &mut d.camera.fov, ANGLE),
    ("render.background[0]", |d| &mut d.render.background[0], NOT_NEGATIVE),
    ("render.ambient[1]", |d| &mut d.render.ambient[1], NOT_NEGATIVE),
    ("render.min_weight", |d| &mut d.render.min_weight, NOT_NEGATIVE),
];

/// Without `reflect`, `specular` is the mirror's factor.
fn specular_as_mirror(draft: &mut Draft) -> &mut f64 {
    let material = &mut draft.materials[draft.spheres[0].material];
    material.reflect = None;
    &mut material.specular
}

/// A key, and a change that makes it wrong.
type Change = (&'static str, fn(&mut Draft));

/// Directions and points that a camera or a plane cannot have.
const DIRECTIONS: &[Change] = &[
    ("planes[0].normal", |d| d.planes[0].normal = [0.0; 3]),
    ("camera.up", |d| d.camera.up = [0.0; 3]),
    ("camera.up", |d| d.camera.up = [0.0, 0.0, -3.0]),
    ("camera.look_at", |d| d.camera.look_at = d.camera.position),
    ("image.width", |d| d.image.width = 0),
    ("image.height", |d| d.image.height = 0),
];

/// An input that must be refused.
pub(crate) struct Refusal {
    /// The key that is wrong, with its value.
    pub(crate) stated: String,
    /// The message; `None` if it was not refused.
    pub(crate) message: Option<String>,
    /// Whether the error names that key.
    pub(crate) named: bool,
}

/// Every input of the case.
pub(crate) fn all() -> Vec<Refusal> {
    let mut refusals = Vec::new();
    let mut try_one = |key: &str, stated: String, draft: Draft| {
        let error = Scene::new(draft).err();
        let named = error.as_ref().is_some_and(|error| error.key().as_deref() == Some(key));
        refusals.push(Refusal { stated, message: error.map(|error| error.to_string()), named });
    };
    for (key, number, values) in NUMBERS {
        for value in *values {
            let mut draft = valid();
            *number(&mut draft) = *value;
            try_one(key, format!("{key} = {value:?}"), draft);
        }
    }
    for (key, change) in DIRECTIONS {
        let mut draft = valid();
        change(&mut draft);
        try_one(key, format!("{key} of no use"), draft);
    }
    refusals
}

/// A scene with one of everything.
fn valid() -> Draft {
    let mut draft = Draft::default();
    draft.lights.push(Light { position: [3.1, 9.7, 2.3], intensity: [1.0; 3] });
    draft.spheres.push(Sphere {
        center: [0.3, -0.2, -20.1],
        radius: 4.1,
        material: draft.materials.add(mirror(0.5)),
    });
    let material = Material::matt([0.5; 3]);
    draft.planes.push(Plane {
        point: [0.0, -5.3, 0.0],
        normal: [0.1, 1.0, 0.2],
        material: draft.materials.add(material),
    });
    draft
}

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    let refusals = all();
    let tested = format!(
        "{} inputs: k, radius, centre, light, direction, field of view and the rest that are 0, negative, NaN, infinite, too small or too large; each in a scene that is valid without it ({})",
        refusals.len(),
        if Scene::new(valid()).is_ok() { "checked" } else { "WHICH IT IS NOT" }
    );
    let wrong: Vec<_> = refusals.iter().filter(|r| !r.named).map(|r| r.stated.as_str()).collect();
    let wrong_count = wrong.len() + usize::from(Scene::new(valid()).is_err());
    let sentence = if wrong.is_empty() {
        "Each refused by an error that names its key.".to_owned()
    } else {
        format!("Not refused by name: {}.", wrong.join(", "))
    };
    findings.push("refusals", None, &tested, wrong_count as f64, sentence);
    findings.done()
}
