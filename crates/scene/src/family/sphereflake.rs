//! A sphere with nine children, each with nine children, ...
//!
//! The construction is Haines' ("A Proposal for Standard Graphics Environments", IEEE
//! Computer Graphics and Applications 7(11), 1987, database `balls`), whose ray counts are
//! published. A child has a third of its parent's radius and touches it from outside, away
//! from the grandparent. In directions: among twelve equal spheres packed around one as
//! closely as can be, cubically, six are on the equator, 60 degrees apart, and three above
//! and below, at a latitude of asin(2/sqrt 6). The children are the upper nine.
//!
//! The description leaves open how a child is turned about its own axis. Here the shortest
//! turn that carries the parent's axis to the child's carries its equator along. That is
//! one of nine fixed turns in the parent's own frame, so no trigonometry is needed.

use super::draws::Draws;
use super::palette::Palette;
use super::parameter::{self, MOST_BALLS, OutOfRange};
use crate::{Draft, Light, Material, Plane, Sphere};

/// Children of a sphere.
const CHILDREN: u32 = 9;
/// Radius of the first sphere, about the origin.
const RADIUS: f64 = 0.5;
/// Height of the ground, which the first sphere touches.
const GROUND: f64 = -RADIUS;
/// Most levels: one more would pass [`MOST_BALLS`].
const MOST_LEVELS: u32 = 6;
const _: () = assert!(matches!(balls(MOST_LEVELS), Some(all) if all <= MOST_BALLS));

/// A frame: its rows are the directions of its x, y and z axes.
type Frame = [[f64; 3]; 3];

/// A sphereflake of 1, 10, 91, 820, 7381, 66430 or 597871 spheres on a matt ground, z upwards.
///
/// The camera, the places of the three lights, the ground and the sky are those of the database
/// `balls`. The first sphere has radius 0.5; max_depth is 5. With four levels, rays can be
/// counted against the published counts. The published depth 5 counts the eye ray, so it is
/// max_depth 4 here; the published ground ends, a square of edge 24.
///
/// The seed decides the colours, one for each level.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphereflake {
    /// Generations after the first sphere, 0 to 6. Default 4.
    pub levels: u32,
    /// Mirror factor k of the flake's spheres, in [0, 1]. Default 0.5.
    pub reflect: f64,
    /// Radius of a sphere that stands for the ground, in [10, 1e12]; `None`, the default,
    /// makes it a plane.
    pub ground_radius: Option<f64>,
    /// Any number. Default 0.
    pub seed: u64,
}

impl Default for Sphereflake {
    fn default() -> Self {
        Self { levels: 4, reflect: 0.5, ground_radius: None, seed: 0 }
    }
}

impl Sphereflake {
    /// The scene: each sphere before its children, and each child's descendants before the next
    /// child; a ground that is a sphere comes before all of them.
    ///
    /// # Errors
    /// The first parameter that is out of its range; nothing has been made then.
    pub fn draft(&self) -> Result<Draft, OutOfRange> {
        parameter::count("levels", self.levels, 0..=MOST_LEVELS)?;
        parameter::reflect(self.reflect)?;
        if let Some(radius) = self.ground_radius {
            parameter::real("ground_radius", radius, 10.0..=1e12)?;
        }
        // Camera, lights and sky as the database has them.
        let mut draft = Draft::default();
        draft.camera.position = [2.1, 1.3, 1.7];
        draft.camera.look_at = [0.0; 3];
        draft.camera.up = [0.0, 0.0, 1.0];
        draft.camera.fov = 45.0;
        draft.render.background = [0.078, 0.361, 0.753];
        // The intensities are ours: together, the lights are a little above 1.
        for position in [[4.0, 3.0, 2.0], [1.0, -4.0, 4.0], [-3.0, 1.0, 5.0]] {
            draft.lights.push(Light { position, intensity: [0.4; 3] });
        }
        // The ground touches the first sphere, whichever shape it has.
        let material = Material { diffuse: 0.8, ..Material::matt([1.0, 0.75, 0.33]) };
        let material = draft.materials.add(material);
        match self.ground_radius {
            Some(radius) => {
                let center = [0.0, 0.0, GROUND - radius];
                draft.spheres.push(Sphere { center, radius, material });
            }
            None => {
                let (point, normal) = ([0.0, 0.0, GROUND], [0.0, 0.0, 1.0]);
                draft.planes.push(Plane { point, normal, material });
            }
        }
        let palette =
            Palette::new(&mut Draws::new(self.seed), [0.5, 0.5, self.reflect], &mut draft);
        // Reserved at once: growing would copy up to half a million spheres again and again.
        let balls = balls(self.levels).expect("the levels are in range");
        draft.spheres.reserve(balls as usize);
        let family = Family { levels: self.levels, turns: turns(), palette };
        let upright = [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]];
        family.add([0.0; 3], RADIUS, upright, 0, &mut draft.spheres);
        Ok(draft)
    }
}

/// Spheres of a flake with `levels` generations after the first: 1 + 9 + 81 + ...; `None` where a
/// u32 cannot hold the number.
const fn balls(levels: u32) -> Option<u32> {
    let (mut all, mut level) = (1_u32, 0);
    while level < levels {
        let Some(descendants) = all.checked_mul(CHILDREN) else { return None };
        let Some(sum) = descendants.checked_add(1) else { return None };
        (all, level) = (sum, level + 1);
    }
    Some(all)
}

/// What all spheres of the flake have in common.
struct Family {
    levels: u32,
    /// Frames of the nine children in their parent's frame; row z is the child's direction.
    turns: [Frame; 9],
    palette: Palette,
}

impl Family {
    /// Adds a sphere and its descendants. Recurses as deep as there are levels.
    fn add(
        &self,
        center: [f64; 3],
        radius: f64,
        frame: Frame,
        level: u32,
        spheres: &mut Vec<Sphere>,
    ) {
        spheres.push(Sphere { center, radius, material: self.palette.at(level as usize) });
        if level == self.levels {
            return;
        }
        let third = radius / 3.0;
        for turn in &self.turns {
            let own = turn.map(|axis| outward(axis, &frame));
            let away = own[2];
            let child = [0, 1, 2].map(|i| center[i] + (radius + third) * away[i]);
            self.add(child, third, own, level + 1, spheres);
        }
    }
}

/// Turns a vector from a frame into the world's axes.
fn outward(v: [f64; 3], frame: &Frame) -> [f64; 3] {
    [0, 1, 2].map(|i| v[0] * frame[0][i] + v[1] * frame[1][i] + v[2] * frame[2][i])
}

/// Frames of the children: what the shortest turn from z to each direction makes of x, y and z.
fn turns() -> [Frame; 9] {
    directions().map(|[a, b, c]| {
        // Rodrigues' formula for the axis z x (a, b, c); c is 0 or above, so 1 + c is not 0.
        let (s, d) = (1.0 + c, a * b / (1.0 + c));
        [[1.0 - a * a / s, -d, -a], [-d, 1.0 - b * b / s, -b], [a, b, c]]
    })
}

/// Directions of the nine children. The axis z is the diagonal of the cubic packing, and latitude
/// asin(2/sqrt 6) has cosine 1/sqrt 3.
fn directions() -> [[f64; 3]; 9] {
    // 15, 75, ... degrees on the equator, 45, 165 and 285 above it: between two of the six.
    let (long, short) =
        ((6.0_f64.sqrt() + 2.0_f64.sqrt()) / 4.0, (6.0_f64.sqrt() - 2.0_f64.sqrt()) / 4.0);
    let half = 0.5_f64.sqrt();
    let (flat, up) = ((1.0_f64 / 3.0).sqrt(), (2.0_f64 / 3.0).sqrt());
    [
        [long, short, 0.0],
        [short, long, 0.0],
        [-half, half, 0.0],
        [-long, -short, 0.0],
        [-short, -long, 0.0],
        [half, -half, 0.0],
        [flat * half, flat * half, up],
        [-flat * long, flat * short, up],
        [flat * short, -flat * long, up],
    ]
}
