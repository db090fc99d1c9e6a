//! Spheres that touch.

use super::draws::Draws;
use super::palette::Palette;
use super::parameter::{self, OutOfRange};
use super::turn::turn;
use crate::{Draft, Light, Sphere};

/// Who touches whom.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Arrangement {
    /// A cluster, each touches every other: 2, 3 or 4 spheres. The default.
    #[default]
    Cluster,
    /// A ring, each touches two others: 3 spheres or more.
    Ring,
    /// A straight chain, along x: 2 spheres or more.
    Chain,
}

/// Mirror spheres of one radius that touch each other, about the origin, under a bright sky.
/// Between them mirror images repeat without end; the scene's max_depth is 50.
///
/// The centres of spheres that touch are two radii apart, as far as f64 can state centres:
/// the distance is off by less than 2^-50 of the largest coordinate. The seed decides
/// colours.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Kissing {
    /// Who touches whom. Default: a cluster.
    pub arrangement: Arrangement,
    /// Spheres: 2 to 4 in a cluster; from 3 in a ring and from 2 in a chain, to
    /// [`MOST_BALLS`](super::parameter::MOST_BALLS). Default 4.
    pub spheres: u32,
    /// Radius of all spheres, in [1e-6, 1e6]. Default 1.
    pub radius: f64,
    /// Mirror factor k of all spheres, in [0, 1]. Default 0.95.
    pub reflect: f64,
    /// Any number. Default 0.
    pub seed: u64,
}

impl Default for Kissing {
    fn default() -> Self {
        let arrangement = Arrangement::default();
        Self { arrangement, spheres: 4, radius: 1.0, reflect: 0.95, seed: 0 }
    }
}

impl Kissing {
    /// The scene: the spheres along the ring or chain.
    ///
    /// # Errors
    /// The first parameter that is out of its range; nothing has been made then.
    pub fn draft(&self) -> Result<Draft, OutOfRange> {
        // No more than four spheres can each touch every other.
        match self.arrangement {
            Arrangement::Cluster => parameter::count("spheres", self.spheres, 2..=4)?,
            Arrangement::Ring => parameter::balls("spheres", self.spheres, 3)?,
            Arrangement::Chain => parameter::balls("spheres", self.spheres, 2)?,
        }
        parameter::real("radius", self.radius, 1e-6..=1e6)?;
        parameter::reflect(self.reflect)?;

        let mut draws = Draws::new(self.seed);
        let (centers, reach) = match self.arrangement {
            Arrangement::Cluster => self.cluster(),
            Arrangement::Ring => self.ring(),
            Arrangement::Chain => self.chain(),
        };
        let mut draft = Draft::default();
        let palette = Palette::new(&mut draws, [0.6, 0.5, self.reflect], &mut draft);
        // All spheres fit into the view: tan 20 degrees is 0.36.
        let extent = reach + self.radius;
        draft.camera.position = [0.1 * extent, 0.15 * extent, 3.2 * extent];
        draft.camera.look_at = [0.0; 3];
        draft.camera.fov = 40.0;
        draft.render.max_depth = 50;
        draft.render.background = [0.25, 0.32, 0.42];
        draft.render.ambient = [0.05; 3];
        let light = [4.0, 5.5, 6.0].map(|x| x * extent);
        draft.lights.push(Light { position: light, intensity: [0.8; 3] });
        // The colours take turns along the ring or chain.
        let spheres = centers.into_iter().enumerate();
        draft.spheres = spheres
            .map(|(index, center)| Sphere {
                center,
                radius: self.radius,
                material: palette.at(index),
            })
            .collect();
        Ok(draft)
    }

    /// Centres about the origin and the largest of their distances from it: a segment, an
    /// equilateral triangle, or a tetrahedron, of edge 2r. The fourth sphere is behind.
    fn cluster(&self) -> (Vec<[f64; 3]>, f64) {
        let r = self.radius;
        if self.spheres == 2 {
            return (vec![[-r, 0.0, 0.0], [r, 0.0, 0.0]], r);
        }
        let foot = r / 3.0_f64.sqrt();
        let height = if self.spheres == 4 { r / 6.0_f64.sqrt() } else { 0.0 };
        let mut centers = vec![[-r, -foot, height], [r, -foot, height], [0.0, 2.0 * foot, height]];
        if self.spheres == 4 {
            centers.push([0.0, 0.0, -3.0 * height]);
            return (centers, 3.0 * height);
        }
        (centers, 2.0 * foot)
    }

    /// Centres on a circle about the origin, seen from its axis. The chords between neighbours are
    /// 2r long, so the circle's radius is r / sin(half a turn / n).
    fn ring(&self) -> (Vec<[f64; 3]>, f64) {
        let n = u64::from(self.spheres);
        let circle = self.radius / turn(1, 2 * n).1;
        let center = |k| {
            let (cos, sin) = turn(k, n);
            [circle * cos, circle * sin, 0.0]
        };
        ((0..n).map(center).collect(), circle)
    }

    /// Centres on the x axis, two radii apart: odd or even multiples of r, rounded once.
    fn chain(&self) -> (Vec<[f64; 3]>, f64) {
        let last = f64::from(self.spheres - 1);
        let center = |k| [self.radius * (2.0 * f64::from(k) - last), 0.0, 0.0];
        ((0..self.spheres).map(center).collect(), self.radius * last)
    }
}
