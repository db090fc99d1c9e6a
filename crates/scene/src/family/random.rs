//! A cloud of spheres.

use super::cells::Cells;
use super::draws::Draws;
use super::palette::Palette;
use super::parameter::{self, OutOfRange};
use crate::error::number;
use crate::{Draft, Light, Material, Plane, Sphere};

/// Whether spheres may overlap.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Placement {
    /// No two spheres meet: each has a cell of its own, of edge 2.5 times the largest radius.
    /// The default.
    #[default]
    Apart,
    /// Centres stand anywhere in the same cube: spheres may overlap and lie inside one another.
    Anywhere,
}

/// A cloud of spheres in a cube about the origin, above a matt floor, seen from outside.
/// Radii are log-uniform, so each decade has as many spheres as the next. max_depth is the
/// format's default.
///
/// The seed decides colours, radii and places.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Random {
    /// Spheres, 0 to [`MOST_BALLS`](super::parameter::MOST_BALLS). Default 100.
    pub balls: u32,
    /// Smallest radius, in [1e-9, 1e9], at most `max_radius`. Default 0.1.
    pub min_radius: f64,
    /// Largest radius, in [1e-9, 1e9]. Default 1.
    pub max_radius: f64,
    /// Whether spheres may overlap. Default: no.
    pub placement: Placement,
    /// Mirror factor k of the spheres, in [0, 1]. Default 0.3.
    pub reflect: f64,
    /// Any number. Default 0.
    pub seed: u64,
}

impl Default for Random {
    fn default() -> Self {
        Self {
            balls: 100,
            min_radius: 0.1,
            max_radius: 1.0,
            placement: Placement::default(),
            reflect: 0.3,
            seed: 0,
        }
    }
}

impl Random {
    /// The scene: the spheres, ordered by their cells where they keep apart.
    ///
    /// # Errors
    /// The first parameter that is out of its range; nothing has been made then.
    pub fn draft(&self) -> Result<Draft, OutOfRange> {
        parameter::balls("balls", self.balls, 0)?;
        parameter::real("max_radius", self.max_radius, 1e-9..=1e9)?;
        parameter::real("min_radius", self.min_radius, 1e-9..=1e9)?;
        // Either radius may be legal alone; only together are they a range.
        if self.min_radius > self.max_radius {
            return Err(OutOfRange {
                parameter: "min_radius",
                found: number(self.min_radius),
                allowed: format!(
                    "at most the largest radius, which is {}",
                    number(self.max_radius)
                ),
            });
        }
        parameter::reflect(self.reflect)?;

        let cells = Cells::of_edge(self.balls, self.max_radius / Cells::MOST_RADIUS);
        // No sphere of the cloud reaches further than this from the origin, along an axis. Eye,
        // lights and floor scale with it, so every cloud fills the picture alike.
        let half = cells.half() + self.max_radius;
        let at = |point: [f64; 3]| point.map(|x| x * half);
        let mut draft = Draft::default();
        draft.camera.position = at([1.9, 1.2, 3.6]);
        draft.camera.look_at = at([0.0, -0.1, 0.0]);
        draft.camera.fov = 40.0;
        draft.render.background = [0.35, 0.5, 0.75];
        draft.lights.push(Light { position: at([8.0, 20.0, 12.0]), intensity: [0.7; 3] });
        draft.lights.push(Light { position: at([-16.0, 12.0, 8.0]), intensity: [0.25; 3] });
        // The floor is below every sphere, so it cuts none.
        draft.planes.push(Plane {
            point: at([0.0, -1.1, 0.0]),
            normal: [0.0, 1.0, 0.0],
            material: draft.materials.add(Material::matt([0.5, 0.5, 0.48])),
        });
        self.add_balls(&cells, &mut draft);
        Ok(draft)
    }

    fn add_balls(&self, cells: &Cells, draft: &mut Draft) {
        let mut draws = Draws::new(self.seed);
        let palette = Palette::new(&mut draws, [0.7, 0.3, self.reflect], draft);
        let mut ball = |corner: Option<[f64; 3]>, draws: &mut Draws| {
            let radius = draws.log_between(self.min_radius, self.max_radius);
            let center = match corner {
                Some(corner) => cells.place(corner, radius, draws),
                None => [0; 3].map(|_| draws.between(-cells.half(), cells.half())),
            };
            draft.spheres.push(Sphere { center, radius, material: palette.any(draws) });
        };
        match self.placement {
            Placement::Apart => {
                for corner in cells.choose(self.balls, &mut draws) {
                    ball(Some(corner), &mut draws);
                }
            }
            Placement::Anywhere => (0..self.balls).for_each(|_| ball(None, &mut draws)),
        }
    }
}
