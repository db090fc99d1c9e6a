//! The camera's own axes, in which a scene is compiled, and the direction of each eye ray.

use super::constants::unit;
use crate::direction::{cross, tamed};
use crate::{Camera, DoubleDouble, Draft, Scalar, Wider};

/// The camera's own axes: x to the right, y to the top of the picture, z towards the viewer, the
/// eye at the origin. The default camera's are the world's.
///
/// A scene that is turned into them before it is rounded looks the same from wherever it is seen: a
/// ray straight ahead has no rounding to share with what lies across, and a narrow view from afar,
/// askew to the world's axes, keeps all its digits. Formed in double-double, 30 digits.
#[derive(Clone, Copy, Debug)]
pub struct CameraAxes {
    position: [f64; 3],
    /// Three unit vectors at right angles, in the world's axes.
    axes: [[DoubleDouble; 3]; 3],
}

impl CameraAxes {
    /// The axes of a valid scene's camera: f = norm(look_at - position), s = norm(f x up) and
    /// u = s x f make s, u and -f.
    #[must_use]
    pub fn new(camera: &Camera) -> Self {
        let position = camera.position;
        let ahead = |i: usize| DoubleDouble::difference(camera.look_at[i], position[i]);
        let f = unit(std::array::from_fn(ahead));
        let s = unit(cross(f, unit(tamed(camera.up).map(DoubleDouble::from))));
        Self { position, axes: [s, cross(s, f), f.map(|x| -x)] }
    }

    /// A point of the world, relative to the eye and in the camera's axes.
    #[must_use]
    pub fn point(&self, point: [f64; 3]) -> [DoubleDouble; 3] {
        self.turned(std::array::from_fn(|i| DoubleDouble::difference(point[i], self.position[i])))
    }

    /// A direction of the world in the camera's axes.
    ///
    /// The turn's own rounding, at most 2^-100 of the vector's length, is taken out again by a grid
    /// sixteen times as wide. So a component that is a short number in these axes is exactly that
    /// number, and one halfway between two scalars goes to the even one, however the scene is
    /// turned.
    #[must_use]
    pub fn turned(&self, v: [DoubleDouble; 3]) -> [DoubleDouble; 3] {
        let turned = self.axes.map(|axis| axis[0] * v[0] + axis[1] * v[1] + axis[2] * v[2]);
        let longest = turned.iter().fold(0.0, |longest: f64, x| longest.max(x.to_f64().abs()));
        turned.map(|x| x.on_grid_of(longest))
    }

    /// The inverse of [`CameraAxes::point`]: a point in the camera's axes, in the world's.
    #[must_use]
    pub fn world_point(&self, point: [DoubleDouble; 3]) -> [DoubleDouble; 3] {
        let from_eye = self.turned_back(point);
        std::array::from_fn(|i| from_eye[i] + DoubleDouble::from(self.position[i]))
    }

    /// The inverse of [`CameraAxes::turned`]: a direction in the camera's axes, in the world's.
    #[must_use]
    pub fn turned_back(&self, v: [DoubleDouble; 3]) -> [DoubleDouble; 3] {
        let [s, u, b] = self.axes;
        std::array::from_fn(|i| s[i] * v[0] + u[i] * v[1] + b[i] * v[2])
    }
}

/// The constants of the direction d = norm(column·half_width, row·half_height, -distance), in the
/// camera's axes; column and row are positions on the image plane, from -1 to 1.
///
/// Units: the image plane at distance 1, all three scaled by one power of two so that the
/// largest is at most 1 (which changes no bit of d and keeps extreme fields of view in range).
#[derive(Clone, Copy, Debug)]
pub struct EyeRays<S: Scalar = f32> {
    /// Distance from the image's middle to its right edge.
    pub half_width: S,
    /// Distance from the image's middle to its top edge.
    pub half_height: S,
    /// Distance from the eye to the image plane.
    pub distance: S,
}

impl<S: Scalar> EyeRays<S> {
    /// h = tan(fov/2) is half the height. The tangent is taken in f64 for every scalar: it is part
    /// of what the scene means.
    pub(super) fn new(scene: &Draft) -> Self {
        let h = S::Wider::from((scene.camera.fov.to_radians() / 2.0).tan());
        let [width, height] = [scene.image.width, scene.image.height].map(f64::from);
        let wide = h * (S::Wider::from(width) / S::Wider::from(height));
        let scale = power_of_two_above(if wide > h { wide } else { h });
        let nearest = |x: S::Wider| S::nearest((x / scale).into());
        Self {
            half_width: nearest(wide),
            half_height: nearest(h),
            distance: nearest(S::Wider::from(1.0)),
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
