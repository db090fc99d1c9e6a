//! The eye's basis, and the direction of each eye ray.

use glam::Vec3;

use super::{rounded3, unit};
use crate::Draft;
use crate::direction::cross;

/// The constants of the direction d = norm(forward + column·right + row·up).
///
/// Units: the image plane at distance 1, all three scaled by one power of two so that the
/// largest is at most 1 (which changes no bit of d and keeps extreme fields of view in range).
#[derive(Clone, Copy, Debug)]
pub struct EyeRays {
    /// Straight ahead.
    pub forward: Vec3,
    /// From the image's middle to its right edge.
    pub right: Vec3,
    /// From the image's middle to its top edge.
    pub up: Vec3,
}

impl EyeRays {
    /// f = norm(look_at - position), s = norm(f x up), u = s x f, h = tan(fov/2), in f64.
    pub(super) fn new(scene: &Draft) -> Self {
        let camera = &scene.camera;
        let f = unit(std::array::from_fn(|i| camera.look_at[i] - camera.position[i]));
        let s = unit(cross(f, unit(camera.up)));
        let u = cross(s, f);
        let h = (camera.fov.to_radians() / 2.0).tan();
        let wide = h * (f64::from(scene.image.width) / f64::from(scene.image.height));
        let scale = power_of_two_above(if wide > h { wide } else { h });
        Self {
            forward: rounded3(f.map(|x| x / scale)),
            right: rounded3(s.map(|x| x * wide / scale)),
            up: rounded3(u.map(|x| x * h / scale)),
        }
    }
}

/// The least power of two that is not below x, nor below 1.
fn power_of_two_above(x: f64) -> f64 {
    let mut power = 1.0;
    while power < x {
        power *= 2.0;
    }
    power
}
