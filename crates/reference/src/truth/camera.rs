//! Eye rays.

use catoptric_scene::{Camera, Image, View};

use super::real::Real;
use super::vector::Vector;

/// The camera's basis, and the image plane's half sizes at distance 1.
pub(super) struct Eye<T> {
    pub(super) position: Vector<T>,
    forward: Vector<T>,
    side: Vector<T>,
    up: Vector<T>,
    half_width: T,
    half_height: T,
    image: Image,
}

/// A sub-sample of a pixel: (i, j) of N x N in pixel (x, y) of the crop.
#[derive(Clone, Copy)]
pub(super) struct Sample {
    pub(super) x: u32,
    pub(super) y: u32,
    pub(super) i: u32,
    pub(super) j: u32,
}

impl<T: Real> Eye<T> {
    pub(super) fn new(camera: &Camera, image: Image) -> Self {
        let position = Vector::from(camera.position);
        let forward = (Vector::from(camera.look_at) - position).tamed().unit();
        let side = forward.cross(Vector::from(camera.up).tamed()).unit();
        // The tangent is taken once in f64: it belongs to the scene's definition, so no
        // arithmetic needs a tangent of its own.
        let half_height = T::from((camera.fov.to_radians() / 2.0).tan());
        let aspect = T::from(f64::from(image.width)) / T::from(f64::from(image.height));
        Self {
            position,
            forward,
            side,
            up: side.cross(forward),
            half_width: half_height * aspect,
            half_height,
            image,
        }
    }

    /// The unit direction through a sub-sample, turned by `nudge`: norm(norm(d) + nudge).
    pub(super) fn direction(&self, view: &View, at: Sample, nudge: [f64; 3]) -> Vector<T> {
        let (crop, n) = (view.crop(), view.samples());
        // 2(x + (i + 1/2)/N)/W - 1 on one fraction bar: only whole numbers stand on it.
        let right = centred::<T>(crop.x, at.x, at.i, n, self.image.width);
        let down = centred::<T>(crop.y, at.y, at.j, n, self.image.height);
        let through = self.forward + self.side * (right * self.half_width)
            - self.up * (down * self.half_height);
        (through.unit() + Vector::from(nudge)).unit()
    }
}

/// Centre of sub-pixel `sub` of `n` in pixel `first + at` of `size`: -1 to 1 across the image.
///
/// Both sides of the fraction are whole numbers below 2^26 (samples are at most 256, sizes
/// at most 65 535), so the quotient is the only rounding.
fn centred<T: Real>(first: u32, at: u32, sub: u32, n: u32, size: u32) -> T {
    let [first, at, sub, n, size] = [first, at, sub, n, size].map(f64::from);
    let fine = n * size;
    T::from(2.0 * n * (first + at) + 2.0 * sub + 1.0 - fine) / T::from(fine)
}
