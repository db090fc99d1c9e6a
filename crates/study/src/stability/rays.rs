//! Single rays through the formulas: any ray, not only those of a picture.

use catoptric_reference::{double, path, ray};
use catoptric_scene::{Compiled, Draft};
use glam::DVec3;

use super::exact::{narrow, widen};
use crate::formula::Formula;

/// A scene without repeated surfaces, for rays that start relative to its eye, in the world's
/// axes.
pub(crate) enum Rays {
    F32(Compiled),
    F64(Compiled<f64>),
}

/// A ray's start and direction, and the primitive that it leaves. For a formula in f32 the numbers
/// are rounded to f32. The formulas take the direction for a unit vector: it is one up to its
/// rounding.
#[derive(Clone, Copy)]
pub(crate) struct Start {
    pub(crate) origin: [f64; 3],
    pub(crate) direction: [f64; 3],
    pub(crate) left: Option<usize>,
}

/// What a ray meets.
pub(crate) struct Met {
    pub(crate) primitive: usize,
    /// How far the ray goes.
    pub(crate) distance: f64,
    /// The point that is met, relative to the eye.
    pub(crate) point: [f64; 3],
    /// The start of the next ray, and what it leaves.
    pub(crate) start: [f64; 3],
    pub(crate) left: Option<usize>,
    /// Whether each light lights that point.
    pub(crate) lit: Vec<bool>,
}

impl Rays {
    pub(crate) fn new(formula: Formula, draft: &Draft) -> Self {
        // Single rays go their own way: a camera with the world's axes leaves their numbers as they
        // are.
        let mut draft = draft.clone();
        let [x, y, z] = draft.camera.position;
        (draft.camera.look_at, draft.camera.up) = ([x, y, z.next_down() - 1.0], [0.0, 1.0, 0.0]);
        let scene = formula.scene(&draft);
        match formula {
            Formula::RobustF64 => Self::F64(Compiled::of(&scene)),
            Formula::TextbookF32 | Formula::RobustF32 => Self::F32(Compiled::new(&scene)),
        }
    }

    /// The first hit of a ray that leaves no surface.
    pub(crate) fn first(&self, origin: [f64; 3], direction: [f64; 3]) -> Option<Met> {
        self.follow(Start { origin, direction, left: None }).into_iter().next()
    }

    /// Everything that a ray meets.
    pub(crate) fn follow(&self, start: Start) -> Vec<Met> {
        let Start { origin, direction, left } = start;
        match self {
            Self::F32(scene) => {
                // The start is rounded to f32 first, as every number of that formula is.
                let (origin, direction) = (narrow(origin), narrow(direction));
                let steps = path::follow(scene, ray::Ray { origin, direction, left });
                let met = |step: path::Step| Met {
                    primitive: step.primitive,
                    distance: step.distance.into(),
                    point: widen(step.surface.point),
                    start: widen(step.surface.start),
                    left: step.surface.left,
                    lit: step.lit,
                };
                steps.into_iter().map(met).collect()
            }
            Self::F64(scene) => {
                let (origin, direction) = (DVec3::from(origin), DVec3::from(direction));
                let ray = double::ray::Ray { origin, direction, left };
                let met = |step: double::path::Step| Met {
                    primitive: step.primitive,
                    distance: step.distance,
                    point: step.surface.point.into(),
                    start: step.surface.start.into(),
                    left: step.surface.left,
                    lit: step.lit,
                };
                double::path::follow(scene, ray).into_iter().map(met).collect()
            }
        }
    }
}
