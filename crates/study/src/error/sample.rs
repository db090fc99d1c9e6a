//! A picture that can be made again and again.

use catoptric_scene::{Compiled, Film, Grid, Scalar, Scene, View};

use crate::formula::{Formula, pixels};
use crate::tracer::{Renders, TooDeep, Tracer};

/// All that a rendering needs, made once.
pub(super) enum Prepared {
    F32(Work<f32>),
    F64(Work<f64>),
}

pub(super) struct Work<S: Scalar> {
    compiled: Compiled<S>,
    grid: Grid<S>,
    film: Film<S>,
}

impl Prepared {
    /// Prepares a scene that has the formula's numerics.
    pub(super) fn new(formula: Formula, scene: &Scene, view: &View) -> Self {
        match formula {
            Formula::RobustF64 => Self::F64(Work::new(scene, view)),
            _ => Self::F32(Work::new(scene, view)),
        }
    }

    pub(super) fn render(&mut self, tracer: Tracer) -> Result<(), TooDeep> {
        match self {
            Self::F32(work) => work.render(tracer),
            Self::F64(work) => work.render(tracer),
        }
    }

    pub(super) fn pixels(&self) -> Vec<[f64; 3]> {
        match self {
            Self::F32(work) => work.pixels(),
            Self::F64(work) => work.pixels(),
        }
    }
}

impl<S: Renders> Work<S> {
    fn new(scene: &Scene, view: &View) -> Self {
        let grid = Grid::of(view);
        let film = Film::black(grid.width, grid.height);
        Self { compiled: Compiled::of(scene), grid, film }
    }

    fn render(&mut self, tracer: Tracer) -> Result<(), TooDeep> {
        tracer.render(&self.compiled, &self.grid, &mut self.film).map(drop)
    }

    fn pixels(&self) -> Vec<[f64; 3]> {
        pixels(&self.film)
    }
}
