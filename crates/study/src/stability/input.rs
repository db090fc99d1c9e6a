//! What rounding the input costs, apart from the computation.

use catoptric_reference::truth::{Precision, TooDeep, Truth};
use catoptric_report::{Column, Table};
use catoptric_scene::{Draft, Scene, SceneError, View};

use crate::metrics::Metrics;

/// The error of a picture in two parts. They need not add up: the robust forms are compiled
/// from the unrounded numbers, and may be nearer to truth than to the truth of rounded ones.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct InputRounding {
    /// Truth of the rounded scene against truth: what any computation from those numbers owes.
    pub input: Metrics,
    /// The picture against truth of the rounded scene.
    pub computation: Metrics,
    /// The picture against truth.
    pub all: Metrics,
}

/// Why the parts cannot be told.
#[derive(Debug, thiserror::Error)]
pub enum InputError {
    /// The rounded scene is not valid.
    #[error("rounded to f32 the scene is not valid: {0}")]
    Scene(#[from] SceneError),
    /// Truth of the rounded scene needs more stack.
    #[error(transparent)]
    TooDeep(#[from] TooDeep),
}

/// Measures `found`, a picture in f32, against `truth`, the same picture in double-double, and
/// against the truth of [`rounded_input`].
///
/// # Errors
/// The rounded scene is not valid, or a path in it is too deep.
///
/// # Panics
/// If the pictures are not of the view's size.
pub fn input_rounding(
    scene: &Scene,
    view: &View,
    found: &[[f64; 3]],
    truth: &[[f64; 3]],
) -> Result<InputRounding, InputError> {
    let rounded = rounded_input(scene)?;
    let of_rounded = Truth::new(&rounded, Precision::DoubleDouble).render(view)?.pixels;
    Ok(InputRounding {
        input: Metrics::of(&of_rounded, truth),
        computation: Metrics::of(found, &of_rounded),
        all: Metrics::of(found, truth),
    })
}

/// The scene as a program would hold it that recentres on the eye and rounds every stated
/// number once to f32. Its truth against truth is what rounding the input costs.
///
/// The robust forms are compiled from the unrounded numbers and may cost less.
///
/// # Errors
/// The scene is not valid any more: a number that f64 tells apart from its neighbour and f32
/// does not.
pub fn rounded_input(scene: &Scene) -> Result<Scene, SceneError> {
    let eye = scene.camera.position;
    let place = |p: [f64; 3]| std::array::from_fn(|i| rounded(p[i] - eye[i]));
    let mut draft: Draft = scene.clone().into_draft();
    // The camera, with the eye at the origin.
    draft.camera.look_at = place(draft.camera.look_at);
    draft.camera.position = [0.0; 3];
    draft.camera.up = draft.camera.up.map(rounded);
    draft.camera.fov = rounded(draft.camera.fov);
    draft.render.background = draft.render.background.map(rounded);
    draft.render.ambient = draft.render.ambient.map(rounded);
    draft.render.min_weight = rounded(draft.render.min_weight);
    // Places are rounded relative to the eye, as the engine does, and sizes as stated.
    for light in &mut draft.lights {
        light.position = place(light.position);
        light.intensity = light.intensity.map(rounded);
    }
    for sphere in &mut draft.spheres {
        sphere.center = place(sphere.center);
        sphere.radius = rounded(sphere.radius);
    }
    for plane in &mut draft.planes {
        plane.point = place(plane.point);
        plane.normal = plane.normal.map(rounded);
    }
    // Materials have no place: their numbers are rounded as stated.
    for material in draft.materials.iter_mut() {
        material.color = material.color.map(rounded);
        material.diffuse = rounded(material.diffuse);
        material.specular = rounded(material.specular);
        material.shininess = rounded(material.shininess);
        material.reflect = material.reflect.map(rounded);
    }
    Scene::new(draft)
}

#[expect(clippy::cast_possible_truncation, reason = "this is the rounding")]
fn rounded(x: f64) -> f64 {
    f64::from(x as f32)
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "Scene", meaning: "The scene, and its formulas." },
    Column { key: "part", heading: "Part", meaning: "Which picture is compared with which." },
    Column {
        key: "off_by_more",
        heading: "Off by more",
        meaning: "Pixels off by more than one 8-bit level.",
    },
    Column { key: "max", heading: "Max", meaning: "Largest error of a channel, linear." },
    Column { key: "rmse", heading: "RMSE", meaning: "Root of the mean squared error, linear." },
];

/// Three rows a picture.
#[must_use]
pub fn table(pictures: &[(String, InputRounding)]) -> Table {
    let caption = "What rounding the stated numbers to f32, recentred on the eye, costs by itself, \
                   and the picture against truth of the rounded and of the stated scene.";
    let mut table = Table::new("input-rounding", COLUMNS, caption);
    for (scene, parts) in pictures {
        let rows = [
            ("truth of the rounded input against truth", parts.input),
            ("picture against truth of the rounded input", parts.computation),
            ("picture against truth", parts.all),
        ];
        for (part, metrics) in rows {
            table.push([
                scene.clone().into(),
                part.into(),
                metrics.off_by_more.into(),
                metrics.max.into(),
                metrics.rmse.into(),
            ]);
        }
    }
    table
}
