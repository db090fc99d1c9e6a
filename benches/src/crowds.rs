//! Scenes of any number of balls, for what is done before the first ray.

use std::f64::consts::TAU;

use catoptric_scene::{Draft, Light, Material, Sphere};

/// A way to place balls.
#[derive(Clone, Copy, Debug)]
pub enum Crowd {
    /// Of four sizes, in a thick shell, as the atoms of a virus are; a lamp beside the eye.
    Atoms,
    /// Around one centre, each inside all larger ones; a lamp beside the eye.
    OneCentre,
    /// Atoms, and as many lamps outside of them as their number has a square root.
    Lamps,
}

impl Crowd {
    /// All of them.
    pub const ALL: [Self; 3] = [Self::Atoms, Self::OneCentre, Self::Lamps];

    /// What it is called in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Atoms => "atoms",
            Self::OneCentre => "one-centre",
            Self::Lamps => "lamps",
        }
    }

    /// So many balls.
    #[must_use]
    pub fn draft(self, balls: u32) -> Draft {
        let mut draft = Draft::default();
        draft.camera.position = [0.0, 0.0, 1100.0];
        draft.camera.look_at = [0.0; 3];
        draft.camera.fov = 38.0;
        let material = draft.materials.add(Material::matt([0.6, 0.6, 0.7]));
        draft.spheres = (0..balls)
            .map(|i| match self {
                Self::OneCentre => {
                    let radius = 100.0 * f64::from(i + 1) / f64::from(balls);
                    Sphere { center: [0.0; 3], radius, material }
                }
                Self::Atoms | Self::Lamps => {
                    // The plastic ratio's multiples: evenly over [0, 1), and apart from those of
                    // the angle.
                    let far = 200.0 + 130.0 * (f64::from(i) * 0.754_877_666_246_693).fract();
                    let radius = [1.7, 1.52, 1.7, 1.55][i as usize % 4];
                    Sphere { center: on_sphere(i, balls, far), radius, material }
                }
            })
            .collect();
        let lamps = if matches!(self, Self::Lamps) { balls.isqrt() } else { 1 };
        draft.lights = (0..lamps)
            .map(|i| Light {
                position: if lamps == 1 {
                    [900.0, 1100.0, 1500.0]
                } else {
                    on_sphere(i, lamps, 400.0)
                },
                intensity: [1.0 / f64::from(lamps); 3],
            })
            .collect();
        draft
    }
}

/// The i-th of `count` points on a sphere around the origin, evenly spread.
fn on_sphere(i: u32, count: u32, radius: f64) -> [f64; 3] {
    let height = 1.0 - (2.0 * f64::from(i) + 1.0) / f64::from(count);
    let (sin, cos) = (f64::from(i) * 0.381_966_011_250_105 * TAU).sin_cos();
    let aside = (1.0 - height * height).sqrt();
    [radius * aside * cos, radius * height, radius * aside * sin]
}
