//! A closed mirror sphere, spheres and the eye inside.

use super::cells::Cells;
use super::draws::Draws;
use super::palette::Palette;
use super::parameter::{self, OutOfRange};
use crate::{Draft, Light, Material, Sphere};

/// A closed room: a mirror sphere about the origin; spheres, the eye and the light are inside.
/// No ray escapes, so every path runs to the scene's max_depth, which is 64, and small errors
/// grow from mirror to mirror. The background would show as magenta where a ray leaked.
///
/// The seed decides colours, radii and places of the spheres inside, which fill a cube. They keep
/// apart from each other, from the wall, the eye and the light.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Room {
    /// Radius R of the room, in [1e-3, 1e9]. Default 10.
    pub radius: f64,
    /// Spheres inside the room, 0 to [`MOST_BALLS`](super::parameter::MOST_BALLS). Default 5.
    pub balls: u32,
    /// Mirror factor k of the wall, in [0, 1]. Default 0.9.
    pub reflect: f64,
    /// Any number. Default 0.
    pub seed: u64,
}

impl Default for Room {
    fn default() -> Self {
        Self { radius: 10.0, balls: 5, reflect: 0.9, seed: 0 }
    }
}

impl Room {
    /// The scene: the room's sphere first, then the spheres inside.
    ///
    /// # Errors
    /// The first parameter that is out of its range; nothing has been made then.
    pub fn draft(&self) -> Result<Draft, OutOfRange> {
        parameter::real("radius", self.radius, 1e-3..=1e9)?;
        parameter::balls("balls", self.balls, 0)?;
        parameter::reflect(self.reflect)?;
        let at = |point: [f64; 3]| point.map(|x| x * self.radius);

        let mut draft = Draft::default();
        // Eye and light are inside the room and outside the cube of the spheres.
        draft.camera.position = at([0.13, 0.07, 0.8]);
        draft.camera.look_at = at([-0.04, -0.03, 0.0]);
        draft.camera.fov = 70.0;
        draft.render.max_depth = 64;
        draft.render.background = [1.0, 0.0, 1.0];
        draft.render.ambient = [0.05; 3];
        draft.lights.push(Light { position: at([-0.2, 0.75, 0.25]), intensity: [0.7; 3] });

        // The wall has little diffuse light and highlight beside its mirror.
        let material = Material {
            color: [0.35, 0.4, 0.5],
            diffuse: 0.25,
            specular: 0.1,
            shininess: 8.0,
            reflect: Some(self.reflect),
        };
        let material = draft.materials.add(material);
        draft.spheres.push(Sphere { center: [0.0; 3], radius: self.radius, material });

        let mut draws = Draws::new(self.seed);
        let palette = Palette::new(&mut draws, [0.6, 0.4, 0.4], &mut draft);
        // Half an edge is below 1/sqrt 3 of the radius: the cube's corners are inside the room.
        let cells = Cells::of_cube(self.balls, 1.1 * self.radius);
        for corner in cells.choose(self.balls, &mut draws) {
            let radius = cells.cell() * draws.between(0.2, Cells::MOST_RADIUS);
            let center = cells.place(corner, radius, &mut draws);
            draft.spheres.push(Sphere { center, radius, material: palette.any(&mut draws) });
        }
        Ok(draft)
    }
}
