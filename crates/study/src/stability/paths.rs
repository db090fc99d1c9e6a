//! Paths in each arithmetic, in one form, and where two of them part.

use catoptric_reference::truth::{Precision, Truth, Vertex};
use catoptric_reference::{double, path};
use catoptric_scene::{
    CameraAxes, Compiled, DoubleDouble, Draft, Grid, Numerics, Scalar, Scene, View,
};
use rayon::prelude::*;

/// What a path is computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Arithmetic {
    /// The f32 recursion with the textbook's formulas.
    Textbook,
    /// The f32 recursion with the robust formulas.
    Robust,
    /// The f64 recursion with the robust formulas.
    RobustF64,
    /// Truth's plain formulas in f64.
    F64,
    /// Truth's plain formulas in double-double.
    DoubleDouble,
}

impl Arithmetic {
    /// The f32 recursion as a scene asks for it.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        match scene.render.numerics {
            Numerics::Textbook => Self::Textbook,
            Numerics::Robust => Self::Robust,
        }
    }

    /// The arithmetic's name in tables and legends.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Textbook => "textbook f32",
            Self::Robust => "robust f32",
            Self::RobustF64 => "robust f64",
            Self::F64 => "plain f64",
            Self::DoubleDouble => "double-double",
        }
    }

    /// Bits of a significand.
    #[must_use]
    pub fn bits(self) -> u32 {
        match self {
            Self::Textbook | Self::Robust => 24,
            Self::RobustF64 | Self::F64 => 53,
            Self::DoubleDouble => 106,
        }
    }
}

/// A view of a scene, ready for the paths of its pixels.
pub struct Paths {
    view: View,
    axes: CameraAxes,
    tracer: Tracer,
}

enum Tracer {
    F32(Box<(Compiled, Grid)>),
    F64(Box<(Compiled<f64>, Grid<f64>)>),
    Truth(Box<Truth>),
}

impl Paths {
    /// Prepares a view of a scene for one arithmetic, whatever the scene's own numerics.
    #[must_use]
    pub fn new(scene: &Scene, view: &View, arithmetic: Arithmetic) -> Self {
        let f32 = |numerics| {
            let scene = with_numerics(scene, numerics);
            Tracer::F32(Box::new((Compiled::new(&scene), Grid::new(view))))
        };
        let f64 = |numerics| {
            let scene = with_numerics(scene, numerics);
            Tracer::F64(Box::new((Compiled::of(&scene), Grid::of(view))))
        };
        let truth = |precision| Tracer::Truth(Box::new(Truth::new(scene, precision)));
        let tracer = match arithmetic {
            Arithmetic::Textbook => f32(Numerics::Textbook),
            Arithmetic::Robust => f32(Numerics::Robust),
            Arithmetic::RobustF64 => f64(Numerics::Robust),
            Arithmetic::F64 => truth(Precision::F64),
            Arithmetic::DoubleDouble => truth(Precision::DoubleDouble),
        };
        Self { view: *view, axes: CameraAxes::new(&scene.camera), tracer }
    }

    /// Every hit on the path of pixel (x, y)'s first sub-sample, in the scene's coordinates.
    #[must_use]
    pub fn path(&self, x: u32, y: u32) -> Vec<Vertex> {
        self.nudged(x, y, [0.0; 3])
    }

    /// Follows a path as [`Paths::path`] does, the eye ray's unit direction d replaced by
    /// norm(d + nudge). The recursions leave the nudge out: nudges asked for here are below their
    /// rounding.
    #[must_use]
    pub fn nudged(&self, x: u32, y: u32, nudge: [f64; 3]) -> Vec<Vertex> {
        // Vertices are told in the world's axes: a double, and what it leaves of a double-double.
        let vertex = |stated: u32, point: [f64; 3], lit, followed| {
            let from_origin = self.axes.world_point(point.map(DoubleDouble::from));
            Vertex {
                primitive: stated as usize,
                point: from_origin.map(DoubleDouble::to_f64),
                rest: from_origin.map(DoubleDouble::low),
                lit,
                followed,
            }
        };
        match &self.tracer {
            Tracer::F32(compiled) => {
                let (scene, grid) = compiled.as_ref();
                let [column, row] = first_sample(grid, x, y);
                let steps = path::follow(scene, path::eye_ray(scene, column, row)).into_iter();
                let vertex = |step: path::Step| {
                    let stated = scene.primitives[step.primitive].stated;
                    let point = step.surface.point.as_dvec3();
                    vertex(stated, point.to_array(), step.lit, step.followed)
                };
                steps.map(vertex).collect()
            }
            Tracer::F64(compiled) => {
                let (scene, grid) = compiled.as_ref();
                let [column, row] = first_sample(grid, x, y);
                let ray = double::path::eye_ray(scene, column, row);
                let vertex = |step: double::path::Step| {
                    let stated = scene.primitives[step.primitive].stated;
                    vertex(stated, step.surface.point.to_array(), step.lit, step.followed)
                };
                double::path::follow(scene, ray).into_iter().map(vertex).collect()
            }
            Tracer::Truth(truth) => truth.path_nudged(&self.view, x, y, nudge),
        }
    }
}

/// The place of a pixel's first sub-sample on the image plane.
fn first_sample<S: Scalar>(grid: &Grid<S>, x: u32, y: u32) -> [S; 2] {
    let index = |pixel: u32| (pixel * grid.samples) as usize;
    [grid.columns[index(x)], grid.rows[index(y)]]
}

/// The first bounce at which two paths meet different primitives, or only one of them meets
/// any; 0 is what the eye sees. `None` if they meet the same ones to their ends.
#[must_use]
pub fn parting(a: &[Vertex], b: &[Vertex]) -> Option<usize> {
    let same = a.iter().zip(b).take_while(|(a, b)| a.primitive == b.primitive).count();
    (same < a.len() || same < b.len()).then_some(same)
}

/// The same scene with other formulas.
#[must_use]
pub fn with_numerics(draft: &Draft, numerics: Numerics) -> Scene {
    let mut draft = draft.clone();
    draft.render.numerics = numerics;
    Scene::new(draft).expect("both formulas take the same scenes")
}

/// Asks for every pixel of a view, row by row, in parallel on rayon's current pool.
pub(crate) fn each_pixel<T: Send>(view: &View, ask: impl Fn(u32, u32) -> T + Sync) -> Vec<T> {
    let (width, height) = (view.crop().width, view.crop().height);
    let row = |y| (0..width).map(|x| ask(x, y)).collect::<Vec<_>>();
    (0..height).into_par_iter().flat_map_iter(row).collect()
}
