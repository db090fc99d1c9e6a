//! What rounding the input costs.

use catoptric_scene::{Numerics, View};
use catoptric_study::metrics::Metrics;
use catoptric_study::stability::input::{InputError, input_rounding, rounded_input, table};

use super::scenes::{matt, pictures, scene, seen, workshop};

#[test]
fn numbers_that_f32_holds_cost_nothing() {
    let mut draft = seen([16, 12], 30.0, [4.0, 8.0, 2.0], &[matt([0.5, -0.25, -6.0], 1.5)]);
    draft.render.ambient = [0.125; 3];
    draft.materials[draft.spheres[0].material].color = [0.5, 0.25, 0.75];
    // Recentred they are small numbers, wherever the scene is.
    let place = [1e7, -3e7, 5e8];
    let moved = |at: &mut [f64; 3]| *at = std::array::from_fn(|i| at[i] + place[i]);
    moved(&mut draft.camera.position);
    moved(&mut draft.camera.look_at);
    moved(&mut draft.lights[0].position);
    moved(&mut draft.spheres[0].center);
    let scene = scene(draft);
    let (found, truth) = pictures(&scene);
    let parts = input_rounding(&scene, &View::whole(&scene), &found, &truth).expect("valid");
    assert!(parts.input.max < 1e-15, "{:?}", parts.input);
    assert_eq!(parts.all, Metrics::of(&found, &truth));
    assert!(parts.computation.max > 1e-9);
}

/// A ground of radius 10 000 at no neat place: its surface moves by up to an ulp of 10 000,
/// which the robust form, compiled from the unrounded numbers, does not pay.
#[test]
fn a_large_sphere_pays_and_the_robust_form_does_not() {
    let mut draft = workshop(48, 36, Numerics::Robust).into_draft();
    draft.spheres[0].center = [0.137_11, -10_004.000_233_7, -20.031_7];
    let scene = scene(draft);
    let (found, truth) = pictures(&scene);
    let parts = input_rounding(&scene, &View::whole(&scene), &found, &truth).expect("valid");
    assert!(parts.input.rmse > 10.0 * parts.all.rmse, "{parts:?}");
    assert_eq!(table(&[("workshop".into(), parts)]).rows.len(), 3);
}

#[test]
fn a_scene_that_f32_cannot_state_is_an_error() {
    let mut draft = seen([1, 1], 30.0, [0.0, 9.0, 0.0], &[matt([0.0, 0.0, -5.0], 1.0)]);
    draft.camera.look_at = [0.0, 0.0, -1e-44];
    let kept = rounded_input(&scene(draft.clone()));
    assert!(kept.is_ok(), "f32 holds 1e-44: {kept:?}");
    // The eye looks at itself.
    draft.camera.look_at = [0.0, 0.0, -1e-46];
    let scene = scene(draft);
    let (found, truth) = pictures(&scene);
    let error = input_rounding(&scene, &View::whole(&scene), &found, &truth);
    assert!(matches!(error, Err(InputError::Scene(_))), "{error:?}");
}
