//! The scene with all its input moved at once.

use catoptric_scene::family::Draws;
use catoptric_scene::{Draft, Scene};

use crate::metrics::larger;
use crate::stability::generic::{across, along, direction, dot, norm, unit};

/// Moved by `size`, see [`super`]; `None` where that leaves a range.
pub(super) fn scene(scene: &Scene, seed: u64, size: f64) -> Option<Scene> {
    let draws = &mut Draws::new(1 + seed);
    let mut draft = scene.clone().into_draft();
    let (eye, extent) = (draft.camera.position, extent(&draft));
    let distance = |x: [f64; 3]| norm(std::array::from_fn(|i| x[i] - eye[i]));
    for light in &mut draft.lights {
        let reach = distance(light.position);
        light.position = along(light.position, direction(draws), size * reach);
    }
    for sphere in &mut draft.spheres {
        let from_eye: [f64; 3] = std::array::from_fn(|i| sphere.center[i] - eye[i]);
        let far = norm(from_eye);
        if sphere.radius < 2.0 * extent {
            sphere.center = along(sphere.center, direction(draws), size * far);
            sphere.radius *= 1.0 + size * draws.between(-1.0, 1.0);
            continue;
        }
        // What is seen of it is a surface with a normal: one is moved, the other turned about
        // the eye, where f64 can state a turn that keeps the surface at its distance.
        let toward = unit(from_eye);
        let turn = if 4.0 * f64::EPSILON * far < size * extent { size } else { 0.0 };
        let turned = unit(along(toward, across(draws, toward), turn));
        if turn > 0.0 {
            sphere.center = along(eye, turned, far);
        }
        sphere.center = along(sphere.center, direction(draws), size * extent);
    }
    for plane in &mut draft.planes {
        let reach = size * distance(plane.point);
        plane.point = along(plane.point, direction(draws), reach);
        let normal = unit(plane.normal);
        plane.normal = along(normal, across(draws, normal), size);
    }
    let materials = draft.spheres.iter_mut().map(|sphere| &mut sphere.material);
    let materials = materials.chain(draft.planes.iter_mut().map(|plane| &mut plane.material));
    for material in materials {
        material.reflect = Some(material.mirror());
        let exponent = material.shininess * if draws.unit() < 0.5 { -1.0 } else { 1.0 };
        material.specular *= (1.0 + size).powf(exponent);
    }
    Scene::new(draft).ok()
}

/// How far the surfaces are from the eye, at most.
fn extent(draft: &Draft) -> f64 {
    let from_eye =
        |x: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| x[i] - draft.camera.position[i]) };
    let spheres = draft.spheres.iter().map(|s| (norm(from_eye(s.center)) - s.radius).abs());
    let planes = draft.planes.iter().map(|p| dot(unit(p.normal), from_eye(p.point)).abs());
    spheres.chain(planes).fold(0.0, larger)
}
