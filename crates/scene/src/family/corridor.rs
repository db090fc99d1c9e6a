//! Two mirrors that face each other, spheres between them.

use super::draws::Draws;
use super::palette::Palette;
use super::parameter::{self, OutOfRange};
use crate::{Draft, Light, Material, Plane, Sphere};

/// Half the distance between the mirrors.
const HALF: f64 = 4.0;
/// Height y of the floor.
const FLOOR: f64 = -1.0;
/// Part of the floor that the spheres stand on: lower corner (x, z), and size.
const BALLS: ([f64; 2], [f64; 2]) = ([-2.0, -3.5], [4.0, 5.5]);

/// A corridor of mirrors: two that face each other at z = -4 and z = 4 on the axis x = y = 0,
/// a matt floor at y = -1, and spheres on it. The eye stands in front of one mirror and looks
/// at the other; nearly every ray between them runs to the scene's max_depth, which is 32.
///
/// The seed decides colours, radii and places of the spheres on the floor. They keep apart from
/// each other and from the eye.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Corridor {
    /// Spheres on the floor, 0 to [`MOST_BALLS`](super::parameter::MOST_BALLS). Default 5.
    pub balls: u32,
    /// Mirror factor k of the mirrors, in [0, 1]. Default 0.92.
    pub reflect: f64,
    /// Radius of two spheres that stand for the mirrors, in [10, 1e12], seen from outside;
    /// `None`, the default, makes them planes. Rounding puts a sphere off its place by up to
    /// its radius times 2^-53.
    pub mirror_radius: Option<f64>,
    /// Any number. Default 0.
    pub seed: u64,
}

impl Default for Corridor {
    fn default() -> Self {
        Self { balls: 5, reflect: 0.92, mirror_radius: None, seed: 0 }
    }
}

impl Corridor {
    /// The scene. Spheres: mirrors that are spheres, then the ones on the floor. Planes: mirrors,
    /// then the floor.
    ///
    /// # Errors
    /// The first parameter that is out of its range; nothing has been made then.
    pub fn draft(&self) -> Result<Draft, OutOfRange> {
        parameter::balls("balls", self.balls, 0)?;
        parameter::reflect(self.reflect)?;
        if let Some(radius) = self.mirror_radius {
            parameter::real("mirror_radius", radius, 10.0..=1e12)?;
        }
        let mut draft = Draft::default();
        draft.camera.position = [0.4, 0.2, 3.1];
        draft.camera.look_at = [-0.9, -0.4, -4.0];
        draft.camera.fov = 50.0;
        draft.render.max_depth = 32;
        draft.render.background = [0.5, 0.65, 0.9];
        draft.render.ambient = [0.15; 3];
        draft.lights.push(Light { position: [0.3, 4.2, 0.7], intensity: [0.9; 3] });
        self.add_mirrors(&mut draft);
        draft.planes.push(Plane {
            point: [0.0, FLOOR, 0.0],
            normal: [0.0, 1.0, 0.0],
            material: draft.materials.add(Material::matt([0.55, 0.45, 0.35])),
        });
        self.add_balls(&mut draft);
        Ok(draft)
    }

    fn add_mirrors(&self, draft: &mut Draft) {
        let material = draft.materials.add(Material {
            color: [0.1, 0.12, 0.12],
            diffuse: 0.2,
            specular: 0.3,
            shininess: 60.0,
            reflect: Some(self.reflect),
        });
        for side in [-1.0, 1.0] {
            match self.mirror_radius {
                Some(radius) => {
                    let center = [0.0, 0.0, side * (HALF + radius)];
                    draft.spheres.push(Sphere { center, radius, material });
                }
                None => {
                    let (point, normal) = ([0.0, 0.0, side * HALF], [0.0, 0.0, -side]);
                    draft.planes.push(Plane { point, normal, material });
                }
            }
        }
    }

    /// Adds the spheres on the floor, one in each of the first cells of a grid with as many rows as
    /// columns, starting at the far end. Radius and place in the cell are by chance.
    fn add_balls(&self, draft: &mut Draft) {
        let mut draws = Draws::new(self.seed);
        let palette = Palette::new(&mut draws, [0.7, 0.3, 0.3], draft);
        let columns = (1..).find(|m: &u32| u64::from(*m).pow(2) >= u64::from(self.balls));
        let columns = columns.expect("u32::MAX squared is more");
        let (corner, size) = BALLS;
        let cell = size.map(|side| side / f64::from(columns));
        let most = if cell[0] < 1.5 { cell[0] } else { 1.5 };
        for ball in 0..self.balls {
            let radius = most * draws.between(0.2, 0.4);
            let step = [ball % columns, ball / columns];
            let [x, z] = [0, 1].map(|axis| {
                let low = corner[axis] + cell[axis] * f64::from(step[axis]);
                let margin = 0.1 * cell[axis] + radius;
                draws.between(low + margin, low + cell[axis] - margin)
            });
            let center = [x, FLOOR + radius, z];
            draft.spheres.push(Sphere { center, radius, material: palette.any(&mut draws) });
        }
    }
}
