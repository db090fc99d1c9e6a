//! The eye's basis, and the direction of each eye ray.

use super::{nearest3, unit};
use crate::direction::{cross, tamed};
use crate::{Draft, Scalar, Wider};

/// The constants of the direction d = norm(forward + column·right + row·up).
///
/// Units: the image plane at distance 1, all three scaled by one power of two so that the
/// largest is at most 1 (which changes no bit of d and keeps extreme fields of view in range).
#[derive(Clone, Copy, Debug)]
pub struct EyeRays<S: Scalar = f32> {
    /// Straight ahead.
    pub forward: S::Vec3,
    /// From the image's middle to its right edge.
    pub right: S::Vec3,
    /// From the image's middle to its top edge.
    pub up: S::Vec3,
}

impl<S: Scalar> EyeRays<S> {
    /// f = norm(look_at - position), s = norm(f x up), u = s x f, h = tan(fov/2). The tangent is
    /// taken in f64 for every scalar: it is part of what the scene means.
    pub(super) fn new(scene: &Draft) -> Self {
        let camera = &scene.camera;
        let ahead = |i: usize| S::Wider::difference(camera.look_at[i], camera.position[i]);
        let f = unit(std::array::from_fn(ahead));
        let s = unit(cross(f, unit(tamed(camera.up).map(S::Wider::from))));
        let u = cross(s, f);
        let h = S::Wider::from((camera.fov.to_radians() / 2.0).tan());
        let [width, height] = [scene.image.width, scene.image.height].map(f64::from);
        let wide = h * (S::Wider::from(width) / S::Wider::from(height));
        let scale = power_of_two_above(if wide > h { wide } else { h });
        Self {
            forward: nearest3::<S, _>(f.map(|x| x / scale)),
            right: nearest3::<S, _>(s.map(|x| x * wide / scale)),
            up: nearest3::<S, _>(u.map(|x| x * h / scale)),
        }
    }
}

/// The least power of two that is not below x, nor below 1.
fn power_of_two_above<W: Wider>(x: W) -> W {
    let mut power = W::from(1.0);
    while power < x {
        power = power + power;
    }
    power
}
