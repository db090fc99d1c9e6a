//! Truth: the picture of the robust model in nearly exact arithmetic.
//!
//! A second small recursion, apart from the f32 one: it starts from the scene as stated, in
//! the scene's own coordinates, with the plainest formulas, in f64 or in double-double, and
//! shares nothing with the f32 recursion but the scene. So errors of compiling, recentring
//! and rounding to f32 all show as differences from it. It computes the robust model
//! whatever the scene's `numerics` says: the textbook formulas are measured against it too.
//!
//! ```text
//! trace(ray, depth, weight):
//!     nearest hit, or the background                      meet.rs
//!     local = ambient + Phong of each light seen          trace.rs, power.rs
//!     local + k · trace(mirrored ray, depth + 1, weight · k)
//! ```
//!
//! Accuracy: a hit at distance t of a sphere of radius r costs about |o - c|²·e / sqrt(disc)
//! with e = 1e-16 in f64 and 5e-32 in double-double, and each mirror amplifies what it is
//! given. On the workshop scene to depth 32 f64 is within 1.4e-12 of double-double, 3.7e-11
//! with a mirroring ground; on spheres of 1e8 and more, and in closed mirror rooms, only
//! double-double is truth.
//!
//! The precision is a value and not a type parameter, so that both instances are compiled
//! here, with this crate's optimisation, and their stack frames are the ones stated.

mod camera;
mod depth;
mod meet;
mod model;
mod power;
mod real;
mod trace;
mod vector;

use std::array::from_fn;

use catoptric_scene::{Counts, DoubleDouble, Film, Scene, View};
use rayon::prelude::*;

use camera::Sample;
pub use depth::{DEPTH_ALLOWED, STACK_BYTES, STACK_PER_LEVEL, TooDeep};
use meet::Ray;
use model::Model;
use real::Real;
use vector::Vector;

/// The arithmetic of truth.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub enum Precision {
    /// f64, 53 bits.
    F64,
    /// Double-double, about 106 bits.
    DoubleDouble,
}

/// A scene ready to be traced in one of the precisions.
pub struct Truth {
    model: AnyModel,
}

enum AnyModel {
    F64(Model<f64>),
    DoubleDouble(Model<DoubleDouble>),
}

/// A picture of truth.
#[derive(Clone, Debug, PartialEq)]
pub struct TruthFilm {
    /// Columns of the view's crop.
    pub width: u32,
    /// Rows of the view's crop.
    pub height: u32,
    /// Linear RGB, unclamped, row by row from the top left; rounded once to f64.
    pub pixels: Vec<[f64; 3]>,
    /// Rays by depth, all sub-samples together.
    pub counts: Counts,
}

/// A hit on a path.
#[derive(Clone, Debug, PartialEq)]
pub struct Vertex {
    /// Index of the primitive: spheres in file order, then planes.
    pub primitive: usize,
    /// The hit in the scene's coordinates, rounded once to f64.
    pub point: [f64; 3],
    /// What that rounding left out: `point + rest` is the hit in truth's arithmetic, so two
    /// paths can be told apart that differ by less than an ulp. 0 in f64.
    pub rest: [f64; 3],
    /// Whether each light, in file order, lights the hit: n·l > 0, nothing between.
    pub lit: Vec<bool>,
    /// Whether the mirrored ray is traced. On the last hit, true means that this ray met nothing.
    pub followed: bool,
}

impl Truth {
    /// Takes the scene as stated; nothing is rounded but by the chosen arithmetic.
    #[must_use]
    pub fn new(scene: &Scene, precision: Precision) -> Self {
        let model = match precision {
            Precision::F64 => AnyModel::F64(Model::new(scene)),
            Precision::DoubleDouble => AnyModel::DoubleDouble(Model::new(scene)),
        };
        Self { model }
    }

    /// The view's picture, its rows in parallel on rayon's current pool. Equal for every
    /// number of threads.
    ///
    /// # Errors
    /// A path that reflects more than [`DEPTH_ALLOWED`] times.
    pub fn render(&self, view: &View) -> Result<TruthFilm, TooDeep> {
        match &self.model {
            AnyModel::F64(model) => model.render(view),
            AnyModel::DoubleDouble(model) => model.render(view),
        }
    }

    /// Linear RGB of pixel (x, y) of the view's crop: the mean of its sub-samples.
    ///
    /// # Errors
    /// A path that reflects more than [`DEPTH_ALLOWED`] times.
    pub fn radiance(&self, view: &View, x: u32, y: u32) -> Result<[f64; 3], TooDeep> {
        self.radiance_nudged(view, x, y, [0.0; 3])
    }

    /// Linear RGB as [`Truth::radiance`] gives it, with every eye ray's unit direction d replaced
    /// by norm(d + nudge): shows how far the picture moves when its input does.
    ///
    /// # Errors
    /// A path that reflects more than [`DEPTH_ALLOWED`] times.
    pub fn radiance_nudged(
        &self,
        view: &View,
        x: u32,
        y: u32,
        nudge: [f64; 3],
    ) -> Result<[f64; 3], TooDeep> {
        let counts = &mut Counts::default();
        match &self.model {
            AnyModel::F64(model) => model.pixel(view, x, y, nudge, counts),
            AnyModel::DoubleDouble(model) => model.pixel(view, x, y, nudge, counts),
        }
    }

    /// The unit direction of the eye ray of pixel (x, y)'s first sub-sample, rounded to f64.
    #[must_use]
    pub fn direction(&self, view: &View, x: u32, y: u32) -> [f64; 3] {
        let at = Sample { x, y, i: 0, j: 0 };
        match &self.model {
            AnyModel::F64(model) => model.eye.direction(view, at, [0.0; 3]).to_f64(),
            AnyModel::DoubleDouble(model) => model.eye.direction(view, at, [0.0; 3]).to_f64(),
        }
    }

    /// Every hit on the path of pixel (x, y)'s first sub-sample, from the eye on, as deep as
    /// the picture follows it. Takes no stack, so no depth is too large.
    #[must_use]
    pub fn path(&self, view: &View, x: u32, y: u32) -> Vec<Vertex> {
        self.path_nudged(view, x, y, [0.0; 3])
    }

    /// Every hit as [`Truth::path`] gives it, with the eye ray's unit direction d replaced by
    /// norm(d + nudge).
    #[must_use]
    pub fn path_nudged(&self, view: &View, x: u32, y: u32, nudge: [f64; 3]) -> Vec<Vertex> {
        match &self.model {
            AnyModel::F64(model) => model.path(view, x, y, nudge),
            AnyModel::DoubleDouble(model) => model.path(view, x, y, nudge),
        }
    }
}

impl TruthFilm {
    /// The picture rounded to f32.
    #[must_use]
    #[expect(clippy::cast_possible_truncation, reason = "this is the rounding")]
    pub fn to_film(&self) -> Film {
        let mut film = Film::new(self.width, self.height);
        for (rounded, pixel) in film.pixels_mut().iter_mut().zip(&self.pixels) {
            *rounded = pixel.map(|channel| channel as f32);
        }
        film
    }
}

impl<T: Real> Model<T> {
    fn render(&self, view: &View) -> Result<TruthFilm, TooDeep> {
        let (width, height) = (view.crop().width, view.crop().height);
        let row = |y| {
            let mut counts = Counts::default();
            let pixel = |x| self.pixel(view, x, y, [0.0; 3], &mut counts);
            let pixels = (0..width).map(pixel).collect::<Result<Vec<_>, _>>()?;
            Ok((pixels, counts))
        };
        let rows = (0..height).into_par_iter().map(row).collect::<Result<Vec<_>, _>>()?;

        let mut counts = Counts::default();
        let mut pixels = Vec::with_capacity(width as usize * height as usize);
        for (row, part) in &rows {
            pixels.extend_from_slice(row);
            counts.add(part);
        }
        Ok(TruthFilm { width, height, pixels, counts })
    }

    fn pixel(
        &self,
        view: &View,
        x: u32,
        y: u32,
        nudge: [f64; 3],
        counts: &mut Counts,
    ) -> Result<[f64; 3], TooDeep> {
        let n = view.samples();
        let mut sum = [T::from(0.0); 3];
        for (j, i) in (0..n).flat_map(|j| (0..n).map(move |i| (j, i))) {
            let ray = self.eye_ray(view, Sample { x, y, i, j }, nudge);
            let seen = self.trace(&ray, 0, T::from(1.0), counts)?;
            sum = from_fn(|c| sum[c] + seen[c]);
        }
        Ok(sum.map(|channel| (channel / T::from(f64::from(n * n))).to_f64()))
    }

    fn path(&self, view: &View, x: u32, y: u32, nudge: [f64; 3]) -> Vec<Vertex> {
        let mut vertices = Vec::new();
        let mut ray = self.eye_ray(view, Sample { x, y, i: 0, j: 0 }, nudge);
        let mut weight = T::from(1.0);
        for depth in 0.. {
            let Some(hit) = self.nearest(&ray) else { break };
            let primitive = self.primitives[hit.index].id;
            let point = hit.point.to_f64();
            let rest = (hit.point - Vector::from(point)).to_f64();
            let next = self.reflected(&ray, &hit, depth, weight);
            let (lit, followed) = (self.lit(&hit), next.is_some());
            vertices.push(Vertex { primitive, point, rest, lit, followed });
            let Some(next) = next else { break };
            (ray, weight) = next;
        }
        vertices
    }

    fn eye_ray(&self, view: &View, at: Sample, nudge: [f64; 3]) -> Ray<T> {
        let direction = self.eye.direction(view, at, nudge);
        Ray { origin: self.eye.position, direction, leaves: None }
    }
}
