//! Spheres on a cubic grid.

use super::draws::Draws;
use super::palette::Palette;
use super::parameter::{self, MOST_BALLS, OutOfRange};
use crate::{Draft, Light, Sphere};

/// The cube root of [`MOST_BALLS`].
const MOST_EDGE: u32 = 100;
const _: () = assert!(MOST_EDGE * MOST_EDGE * MOST_EDGE <= MOST_BALLS);

/// A cube of n x n x n equal spheres about the origin, one unit apart, seen from outside.
///
/// Every ray has many candidates, none nearer than the next: the scene is for measuring cost by
/// number of bodies. max_depth is the format's default.
///
/// The seed decides colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Lattice {
    /// Spheres along an edge, 1 to 100: n^3 in all, at most [`MOST_BALLS`]. Default 5.
    pub edge: u32,
    /// Radius of all spheres, in [1e-6, 0.5]; at 0.5 they touch. Default 0.4.
    pub radius: f64,
    /// Mirror factor k of all spheres, in [0, 1]. Default 0.3.
    pub reflect: f64,
    /// Any number. Default 0.
    pub seed: u64,
}

impl Default for Lattice {
    fn default() -> Self {
        Self { edge: 5, radius: 0.4, reflect: 0.3, seed: 0 }
    }
}

impl Lattice {
    /// The scene: spheres in order of z, then y, then x, the least first.
    ///
    /// # Errors
    /// The first parameter that is out of its range; nothing has been made then.
    pub fn draft(&self) -> Result<Draft, OutOfRange> {
        parameter::count("edge", self.edge, 1..=MOST_EDGE)?;
        parameter::real("radius", self.radius, 1e-6..=0.5)?;
        parameter::reflect(self.reflect)?;

        let half = f64::from(self.edge) / 2.0;
        let at = |point: [f64; 3]| point.map(|x| x * half);
        let mut draft = Draft::default();
        draft.camera.position = at([2.1, 1.7, 4.1]);
        draft.camera.look_at = at([0.0, -0.1, 0.0]);
        draft.camera.fov = 40.0;
        draft.render.background = [0.25, 0.35, 0.5];
        draft.lights.push(Light { position: at([3.0, 6.0, 4.0]), intensity: [0.9; 3] });

        let mut draws = Draws::new(self.seed);
        let palette = Palette::new(&mut draws, [0.7, 0.3, self.reflect], &mut draft);
        // All coordinates are half-integers or integers, hence exact.
        let coordinate = |step: u32| f64::from(step) + 0.5 - half;
        for z in 0..self.edge {
            for y in 0..self.edge {
                for x in 0..self.edge {
                    let center = [x, y, z].map(coordinate);
                    let material = palette.any(&mut draws);
                    draft.spheres.push(Sphere { center, radius: self.radius, material });
                }
            }
        }
        Ok(draft)
    }
}
