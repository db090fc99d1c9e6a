//! How well an eye ray's direction is known.

use catoptric_scene::{Body, Draft};

/// What an eye ray's direction is known to, in u: 1, or 4 times half the picture's diagonal at
/// distance 1 where that is less and no mirror sends rays another way.
pub(super) fn narrow(scene: &Draft) -> f64 {
    let mirrors = |body: Body<'_>| scene.materials[body.material()].mirror() > 0.0;
    if scene.render.max_depth > 0 && scene.bodies().any(mirrors) {
        return 1.0;
    }
    let half_height = (scene.camera.fov.to_radians() / 2.0).tan();
    let aspect = f64::from(scene.image.width) / f64::from(scene.image.height);
    let across = 4.0 * half_height * (1.0 + aspect * aspect).sqrt();
    if across < 1.0 { across } else { 1.0 }
}
