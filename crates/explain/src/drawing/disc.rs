//! Spheres as a view shows them.

use catoptric_scene::{Scene, Sphere};

use super::axes::Axes;
use super::svg::css;

/// A sphere as the view shows it.
pub(super) struct Disc {
    pub(super) stated: usize,
    pub(super) center: [f64; 2],
    pub(super) radius: f64,
    pub(super) color: String,
}

/// All spheres of the scene, in its order.
pub(super) fn discs(scene: &Scene, axes: &Axes) -> Vec<Disc> {
    let eye = scene.camera.position;
    let disc = |(stated, sphere): (usize, &Sphere)| Disc {
        stated,
        center: axes.project(std::array::from_fn(|i| sphere.center[i] - eye[i])),
        radius: sphere.radius,
        color: css(scene.materials[sphere.material].color),
    };
    scene.spheres.iter().enumerate().map(disc).collect()
}
