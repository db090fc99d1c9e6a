//! The scene with all its input moved at once.
//!
//! A thing is moved by what its own constants can be rounded by, seen from the eye. How large the
//! rest of the scene is plays no part, or one far thing would excuse errors on all others.

use catoptric_scene::family::Draws;
use catoptric_scene::{Draft, Plane, Scene, Sphere};

use super::narrow::narrow;
use crate::metrics::larger;
use crate::stability::exact;
use crate::stability::generic::{across, along, direction, dot, norm, unit};

/// Moved by `size`, see [`super`]; `None` where that leaves a range.
pub(super) fn scene(scene: &Scene, seed: u64, size: f64) -> Option<Scene> {
    let draws = &mut Draws::new(1 + seed);
    let mut draft = scene.clone().into_draft();
    let eye = Eye::new(&draft, size);
    for light in &mut draft.lights {
        light.position = eye.moved(draws, light.position);
    }
    for sphere in &mut draft.spheres {
        eye.move_sphere(draws, sphere);
    }
    for plane in &mut draft.planes {
        eye.move_plane(draws, plane);
    }
    draft.remake_materials(|material| {
        material.reflect = Some(material.mirror());
        let exponent = material.shininess * if draws.unit() < 0.5 { -1.0 } else { 1.0 };
        material.specular *= (1.0 + size).powf(exponent);
    });
    Scene::new(draft).ok()
}

/// The eye that things are moved as seen from, and by how much.
struct Eye {
    position: [f64; 3],
    forward: [f64; 3],
    /// What a direction across the view is moved by, in `size`.
    narrow: f64,
    size: f64,
}

impl Eye {
    fn new(draft: &Draft, size: f64) -> Self {
        let position = draft.camera.position;
        let forward = unit(std::array::from_fn(|i| draft.camera.look_at[i] - position[i]));
        Self { position, forward, narrow: narrow(draft), size }
    }

    fn to(&self, x: [f64; 3]) -> [f64; 3] {
        std::array::from_fn(|i| x[i] - self.position[i])
    }

    /// A place moved by `size` of its distance; across a narrow view by no more than that of what
    /// the view shows there, or of how far it is beside the view's axis.
    fn moved(&self, draws: &mut Draws, x: [f64; 3]) -> [f64; 3] {
        let way = direction(draws);
        let v = self.to(x);
        let beside = norm(along(v, self.forward, -dot(v, self.forward)));
        let far = norm(v);
        let across = larger(self.narrow * far, beside);
        let ahead = dot(way, self.forward);
        let beside = along(way, self.forward, -ahead);
        let shift = along(beside.map(|part| across * part), self.forward, far * ahead);
        along(x, shift, self.size)
    }

    /// A unit vector turned by `size` towards another one across it. The part along a narrow
    /// view is turned by no more than a rounding of it and of what crosses the view.
    fn turned(&self, v: [f64; 3], across: [f64; 3]) -> [f64; 3] {
        let ahead = dot(across, self.forward);
        let most = larger(self.narrow, dot(v, self.forward).abs());
        let kept = if ahead.abs() > most { most * ahead.signum() } else { ahead };
        unit(along(v, along(across, self.forward, kept - ahead), self.size))
    }

    fn move_sphere(&self, draws: &mut Draws, sphere: &mut Sphere) {
        let center = exact::between(sphere.center, self.position);
        let far = exact::length(center);
        // Its height over the eye, below 0 for an eye inside; nothing cancels in it.
        let height = (far - sphere.radius.into()).to_f64();
        if sphere.radius < 2.0 * height.abs() {
            sphere.center = self.moved(draws, sphere.center);
            sphere.radius *= 1.0 + self.size * draws.between(-1.0, 1.0);
            return;
        }
        // What is seen of it is a surface with a height, a normal and a curvature. All three are
        // moved, where f64 can state the surface so exactly.
        let far = far.to_f64();
        if far == 0.0 || 4.0 * f64::EPSILON * far >= self.size * height.abs() {
            let way = direction(draws);
            sphere.center = along(sphere.center, way, self.size * height.abs());
            return;
        }
        let toward = unit(center.map(catoptric_scene::DoubleDouble::to_f64));
        let turned = self.turned(toward, across(draws, toward));
        let grown = self.size * draws.between(-1.0, 1.0) * sphere.radius;
        let raised = self.size * draws.between(-1.0, 1.0) * height;
        sphere.center = along(self.position, turned, far + grown + raised);
        sphere.radius += grown;
    }

    /// The foot of the eye's perpendicular is moved along it, and the normal turned about it; where
    /// the plane is stated plays no part.
    fn move_plane(&self, draws: &mut Draws, plane: &mut Plane) {
        let normal = unit(plane.normal);
        let to_point = exact::between(plane.point, self.position);
        let height = exact::dot(exact::vector(normal), to_point).to_f64();
        let raised = height * (1.0 + self.size * draws.between(-1.0, 1.0));
        plane.normal = self.turned(normal, across(draws, normal));
        plane.point = along(self.position, plane.normal, raised);
    }
}
