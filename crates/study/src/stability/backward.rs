//! Backward error: is the picture the true picture of a scene nearly as stated?
//!
//! Where mirrors amplify, no computation in p bits can be near truth, and the raw error says
//! little. So a pixel is judged by how far truth itself moves when its input does:
//!
//! ratio = error / max(spread, floor), to be at most 4.
//!
//! The floor is what the arithmetic leaves of a sum of a few terms: 3e-6 of the picture's
//! brightness in f32, as many u in f64. Brightness is truth's largest channel, so that lights a
//! thousand times brighter change no ratio; the a-priori bound B of [`crate::light`] would not
//! do, being ten times and more what a scene of mirrors shows.
//!
//! The spread is measured in one of two ways, u being 2^-24 in f32 and 2^-53 in f64:
//!
//! - **by the eye ray**: truth's largest change when the ray's direction is nudged by 1, 2 and
//!   4 u, to the right, to the left, up and down. In a narrow view the direction is known from
//!   the view's middle, so there u is no more than 4 u of half the picture's diagonal: 16 u of
//!   the picture are the most that is excused. Where mirrors send rays another way, whose
//!   directions are known to u and no better, it is u in a narrow view too.
//! - **by all input**: the larger of that and truth's largest change over [`SCENES`] scenes,
//!   all of whose input is moved at once, in ways of chance. Every place is moved by [`MOVED`] u
//!   of its distance from the eye, across a narrow view by as much of what the view shows there
//!   or of its own distance from the view's middle; every radius and normal by up to as much
//!   relatively, and the highlight of shininess p is multiplied by (1 ± [`MOVED`] u)^p, which is
//!   what an error in the length of a unit vector does to the power of a cosine. A sphere with
//!   the eye within half a radius of its surface is moved by its height, curvature and normal at
//!   the eye's foot, not by a part of its radius, or every error on it would be excused. Each
//!   thing is moved by what it and the eye say alone: a far thing excuses nothing of the others.
//!
//! They are the same scenes for every pixel of every picture: none is added for one that fails.
//!
//! A mirrored highlight needs the second: next to its middle the cosine is 1 up to the rounding
//! of two unit vectors' lengths, which no nudge of a direction changes to first order, and the
//! power multiplies that by p. But it is the laxer one: it takes the largest of 64 changes more,
//! and where a path meets an edge within reach of any of them, the whole step is excused.

mod moved;
mod narrow;

use std::sync::OnceLock;

use catoptric_reference::truth::{Precision, TooDeep, Truth};
use catoptric_scene::{Scene, Transfer, View};
use glam::DVec3;
use rayon::prelude::*;

use crate::formula::{Formula, U};
use crate::metrics::{Metrics, difference, larger};
use narrow::narrow;

/// Ratio up to which a pixel passes.
pub const ALLOWED: f64 = 4.0;

/// Nudges of the eye ray, in u.
const NUDGES: [f64; 3] = [1.0, 2.0, 4.0];

/// Scenes with moved input.
pub const SCENES: u64 = 64;

/// Size of the moves of a scene's input, in u.
pub const MOVED: f64 = 4.0;

/// An error of 3e-6, in u of f32.
const FLOOR: f64 = 3e-6 / U;

/// Ratio from which on nothing is left to excuse: the picture is of another scene.
const HOPELESS: f64 = 1000.0;

/// Pixels that are judged together.
const CHUNK: usize = 64;

/// Pixels that stand for a picture where its spreads are asked for.
const SAMPLE: usize = 600;

/// Truth of a scene, and how it moves.
pub struct Judge {
    scene: Scene,
    view: View,
    transfer: Transfer,
    /// Scale of the eye ray's nudges.
    narrow: f64,
    truth: Truth,
    pixels: Vec<[f64; 3]>,
    f32: Moves,
    f64: Moves,
}

/// What truth is moved by.
struct Moves {
    u: f64,
    /// Smallest spread that is allowed for, in the picture's unit.
    floor: f64,
    scenes: OnceLock<Vec<Truth>>,
    /// Spreads by the eye ray and by all input, for each pixel that was asked for.
    spreads: Vec<OnceLock<[f64; 2]>>,
}

/// A picture's backward error.
#[derive(Clone, Copy, Debug)]
pub struct Backward {
    /// Largest ratio, the spread by the eye ray.
    pub by_eye: f64,
    /// Largest ratio, the spread by all input. Never above `by_eye`.
    pub by_input: f64,
    /// Pixels whose ratios are above [`ALLOWED`], by the eye ray and by all input. Not counted
    /// where a ratio is above 1000: the picture is then looked at no further, and the ratios
    /// are lower bounds.
    pub beyond: Option<[u64; 2]>,
    /// The raw error.
    pub raw: Metrics,
}

/// How far truth moves by its eye rays, over a sample of pixels; in floors.
#[derive(Clone, Copy, Debug)]
pub struct Spreads {
    /// The upper median.
    pub median: f64,
    /// The 99th percentile.
    pub p99: f64,
}

impl Backward {
    /// The pixels beyond, in words.
    #[must_use]
    pub fn beyond(&self) -> String {
        match self.beyond {
            Some([eye, input]) => {
                format!("above 4 are {eye} pixels by the eye ray, {input} by all input")
            }
            None => "pixels above 4 not counted".to_owned(),
        }
    }
}

impl Judge {
    /// Renders truth in double-double.
    ///
    /// # Errors
    /// A path that is too deep for truth's recursion.
    pub fn new(scene: &Scene) -> Result<Self, TooDeep> {
        let view = View::whole(scene);
        let truth = Truth::new(scene, Precision::DoubleDouble);
        let pixels = truth.render(&view)?.pixels;
        let brightness = pixels.as_flattened().iter().copied().fold(0.0, larger);
        let moves = |u| Moves::new(u, brightness, pixels.len());
        let (f32, f64) = (moves(Formula::RobustF32.u()), moves(Formula::RobustF64.u()));
        let transfer = scene.image.transfer;
        let narrow = narrow(scene);
        Ok(Self { scene: scene.clone(), view, transfer, narrow, truth, pixels, f32, f64 })
    }

    /// Truth's picture.
    #[must_use]
    pub fn truth(&self) -> &[[f64; 3]] {
        &self.pixels
    }

    /// Judges a picture of the scene by the u of f32.
    ///
    /// # Errors
    /// A path that is too deep for truth's recursion.
    ///
    /// # Panics
    /// If the picture is of another size.
    pub fn judge(&self, found: &[[f64; 3]]) -> Result<Backward, TooDeep> {
        self.judge_by(&self.f32, found)
    }

    /// Judges a picture of the scene by the u of the formula's arithmetic.
    ///
    /// # Errors
    /// A path that is too deep for truth's recursion.
    ///
    /// # Panics
    /// If the picture is of another size.
    pub fn judge_as(&self, formula: Formula, found: &[[f64; 3]]) -> Result<Backward, TooDeep> {
        self.judge_by(self.moves(formula), found)
    }

    /// How far truth moves when its eye rays do by up to 4 u of the formula's arithmetic.
    ///
    /// # Errors
    /// A path that is too deep for truth's recursion.
    pub fn spreads(&self, formula: Formula) -> Result<Spreads, TooDeep> {
        let moves = self.moves(formula);
        let step = self.pixels.len().div_ceil(SAMPLE);
        // Every n-th pixel, n odd, or some columns would stand for all.
        let sample = (0..self.pixels.len()).into_par_iter().step_by(step | 1);
        let spreads = sample.map(|index| Ok(self.by_eye(moves, index)? / moves.floor));
        let mut spreads = spreads.collect::<Result<Vec<_>, TooDeep>>()?;
        spreads.sort_by(f64::total_cmp);
        let at = |share: f64| spreads[((spreads.len() - 1) as f64 * share).ceil() as usize];
        Ok(Spreads { median: at(0.5), p99: at(0.99) })
    }

    fn moves(&self, formula: Formula) -> &Moves {
        match formula {
            Formula::TextbookF32 | Formula::RobustF32 => &self.f32,
            Formula::RobustF64 => &self.f64,
        }
    }

    /// Pixels are taken from the largest error down, until what is left cannot hold the largest
    /// ratio nor one above [`ALLOWED`].
    fn judge_by(&self, moves: &Moves, found: &[[f64; 3]]) -> Result<Backward, TooDeep> {
        let raw = Metrics::over(found, &self.pixels, self.transfer, |_| true);
        let errors = found.iter().zip(&self.pixels).map(|(a, b)| difference(a, b));
        let mut by_error: Vec<_> = errors.enumerate().collect();
        by_error.sort_by(|a, b| b.1.total_cmp(&a.1));

        let mut judged = Backward { by_eye: 0.0, by_input: 0.0, beyond: Some([0; 2]), raw };
        for chunk in by_error.chunks(CHUNK) {
            let most = ratio(chunk[0].1, moves.floor);
            if most <= judged.by_input && most <= ALLOWED {
                break;
            }
            if judged.by_input > HOPELESS {
                judged.beyond = None;
                break;
            }
            let ratios = chunk.par_iter().map(|&(index, error)| self.ratios(moves, index, error));
            for [by_eye, by_input] in ratios.collect::<Result<Vec<_>, _>>()? {
                judged.by_eye = larger(judged.by_eye, by_eye);
                judged.by_input = larger(judged.by_input, by_input);
                if let Some([eye, input]) = &mut judged.beyond {
                    *eye += u64::from(!passes(by_eye));
                    *input += u64::from(!passes(by_input));
                }
            }
        }
        Ok(judged)
    }

    /// Both ratios of a pixel.
    fn ratios(&self, moves: &Moves, index: usize, error: f64) -> Result<[f64; 2], TooDeep> {
        let spreads = match moves.spreads[index].get() {
            Some(spreads) => *spreads,
            None => {
                let spreads = self.both(moves, index)?;
                *moves.spreads[index].get_or_init(|| spreads)
            }
        };
        Ok(spreads.map(|spread| ratio(error, larger(moves.floor, spread))))
    }

    /// A pixel's spreads by the eye ray and by all input.
    fn both(&self, moves: &Moves, index: usize) -> Result<[f64; 2], TooDeep> {
        let [x, y] = self.place(index);
        let by_eye = self.by_eye(moves, index)?;
        let mut by_input = by_eye;
        for truth in moves.scenes(&self.scene) {
            let other = truth.radiance(&self.view, x, y)?;
            by_input = larger(by_input, difference(&other, &self.pixels[index]));
        }
        Ok([by_eye, by_input])
    }

    /// A pixel's spread by the eye ray.
    fn by_eye(&self, moves: &Moves, index: usize) -> Result<f64, TooDeep> {
        let [x, y] = self.place(index);
        let eye_ray = DVec3::from_array(self.truth.direction(&self.view, x, y));
        let (right, up) = eye_ray.any_orthonormal_pair();
        let mut spread = 0.0;
        for way in [right, -right, up, -up] {
            for size in NUDGES {
                let nudge = (size * moves.u * self.narrow * way).to_array();
                let other = self.truth.radiance_nudged(&self.view, x, y, nudge)?;
                spread = larger(spread, difference(&other, &self.pixels[index]));
            }
        }
        Ok(spread)
    }

    fn place(&self, index: usize) -> [u32; 2] {
        let width = self.view.crop().width as usize;
        [index % width, index / width].map(|i| u32::try_from(i).expect("at most 65 535"))
    }
}

impl Moves {
    fn new(u: f64, brightness: f64, pixels: usize) -> Self {
        let spreads = std::iter::repeat_with(OnceLock::new).take(pixels).collect();
        Self { u, floor: FLOOR * u * brightness, scenes: OnceLock::new(), spreads }
    }

    fn scenes(&self, scene: &Scene) -> &[Truth] {
        self.scenes.get_or_init(|| {
            let moved = (0..SCENES).filter_map(|seed| moved::scene(scene, seed, MOVED * self.u));
            moved.map(|scene| Truth::new(&scene, Precision::DoubleDouble)).collect()
        })
    }
}

/// The ratio of an error to a spread; no error is none of any spread.
fn ratio(error: f64, spread: f64) -> f64 {
    if error == 0.0 { 0.0 } else { error / spread }
}

/// Whether a pixel of that ratio passes; NaN does not.
pub(crate) fn passes(ratio: f64) -> bool {
    ratio <= ALLOWED
}
