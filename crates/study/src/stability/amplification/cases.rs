//! Cases in which growth is measured.

use catoptric_scene::family::Room;
use catoptric_scene::{Crop, Scene, View};
use glam::DVec3;
use rayon::prelude::*;

use super::orbit::{Aimed, Orbit, RADIUS};
use crate::stability::paths::Arithmetic;

/// Paths through a scene, or through scenes that differ in their eye alone.
pub struct Case {
    /// The case's name.
    pub name: String,
    /// Growth per bounce by a closed form, where there is one.
    pub lambda: Option<f64>,
    /// The length that errors are measured in: the radius of the mirrors.
    pub unit: f64,
    rays: Rays,
}

enum Rays {
    /// Eyes whose rays are aimed to stay near an orbit.
    Aimed { orbit: Box<Orbit>, bounces: usize },
    /// Every pixel of a picture.
    Picture(Box<Scene>),
}

/// The eye rays of all pixels of a view of a scene.
pub(super) struct Bundle {
    pub(super) scene: Scene,
    pub(super) view: View,
    /// Added to each ray's direction.
    pub(super) nudge: DVec3,
    /// The direction in which rays are nudged further; the part of it across each ray counts.
    pub(super) across: DVec3,
}

/// Eyes of an orbit.
const EYES: u32 = 15;

/// Pairs at a distance of 2.01, 2.5, 6 and 10 radii, and the triangle between three spheres at
/// 6 radii.
#[must_use]
pub fn orbits() -> Vec<Case> {
    let pairs =
        [2.01, 2.5, 6.0, 10.0].map(|sigma| Case::of(format!("pair {sigma}"), Orbit::pair(sigma)));
    let three = Case::of("three spheres 6".to_owned(), Orbit::triangle(6.0));
    pairs.into_iter().chain([three]).collect()
}

/// All pixels of a scene's picture, to its depth. `unit`: the length errors are measured in.
#[must_use]
pub fn picture(name: impl Into<String>, scene: Scene, unit: f64) -> Case {
    Case { name: name.into(), lambda: None, unit, rays: Rays::Picture(Box::new(scene)) }
}

impl Case {
    /// Rays aimed at an orbit, for as long as double-double can hold it and a little longer.
    #[must_use]
    pub fn of(name: String, orbit: Orbit) -> Self {
        let bounces = (1e31_f64.ln() / orbit.lambda.ln()) as usize + 1;
        let lambda = Some(orbit.lambda);
        Self { name, lambda, unit: RADIUS, rays: Rays::Aimed { orbit: Box::new(orbit), bounces } }
    }

    /// A closed mirror room of radius about 10 with three spheres, 400 bounces, 16 x 12 rays.
    #[must_use]
    pub fn room() -> Self {
        let room = Room { radius: 10.37, balls: 3, seed: 4, ..Room::default() };
        let mut draft = room.draft().expect("in range");
        let place = [3.713, -2.291, 5.553];
        let moved = |at: &mut [f64; 3]| *at = std::array::from_fn(|i| at[i] + place[i]);
        moved(&mut draft.camera.position);
        moved(&mut draft.camera.look_at);
        draft.lights.iter_mut().for_each(|light| moved(&mut light.position));
        draft.spheres.iter_mut().for_each(|sphere| moved(&mut sphere.center));
        // Every primitive a mirror, or paths would end there.
        draft.materials.iter_mut().for_each(|material| material.reflect = Some(0.9));
        (draft.image.width, draft.image.height) = (16, 12);
        draft.render.max_depth = 400;
        picture("closed room, 3 balls", Scene::new(draft).expect("a valid family"), room.radius)
    }

    /// The f32 formulas that the case is about.
    pub(super) fn f32(&self) -> Arithmetic {
        match &self.rays {
            Rays::Aimed { .. } => Arithmetic::Robust,
            Rays::Picture(scene) => Arithmetic::of(scene),
        }
    }

    /// The scenes whose pixels are the case's paths, and how their rays start.
    pub(super) fn bundles(&self) -> Vec<Bundle> {
        match &self.rays {
            Rays::Aimed { orbit, bounces } => {
                let eye = |index| {
                    let Aimed { scene, nudge } = orbit.aimed(index, *bounces);
                    let first = Crop { x: 0, y: 0, width: 1, height: 1 };
                    let view = View::new(&scene, Some(first), 1).expect("a pixel of the picture");
                    Bundle { scene, view, nudge: DVec3::from_array(nudge), across: orbit.nudge }
                };
                (0..EYES).into_par_iter().map(eye).collect()
            }
            Rays::Picture(scene) => {
                let scene = scene.as_ref().clone();
                let view = View::whole(&scene);
                vec![Bundle {
                    scene,
                    view,
                    nudge: DVec3::ZERO,
                    across: DVec3::new(0.31, 0.72, -0.62),
                }]
            }
        }
    }
}
