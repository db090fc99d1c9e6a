//! Backward error: is the picture the true picture of a scene nearly as stated?
//!
//! Where mirrors amplify, no f32 computation can be near truth, and the raw error says little.
//! So a pixel is judged by how far truth itself moves when its input does:
//!
//! ratio = error / max(spread, 3e-6), to be at most 4.
//!
//! 3e-6 is what f32 leaves of a sum of a few terms near 1. The spread is measured in one of two
//! ways, and both ratios are reported:
//!
//! - **by the eye ray**: its direction is nudged by 1, 2 and 4 u, u = 2^-24, in four directions;
//! - **by all input**: beside that, every place is moved by up to m u of its distance from the
//!   eye, every radius and normal by as much relatively, and the highlight of shininess p is
//!   multiplied by (1 ± m u)^p, which is what an error of m u in the length of a unit vector
//!   does to the power of a cosine. A sphere that is large against the scene is moved by m u of
//!   the scene's extent, not of its own radius, or every error on it would be excused. For a
//!   pixel whose path meets n surfaces, m is up to 4 sqrt(n): each reflection rounds anew, and
//!   along a path that amplifies nothing, such as one close to a mirror wall, n roundings lead
//!   sqrt(n) times further from truth than one change of the scene does.
//!
//! A mirrored highlight needs the second: next to its middle the cosine is 1 up to the rounding
//! of two unit vectors' lengths, which no nudge of a direction changes to first order, and the
//! power multiplies that by p.

use catoptric_reference::truth::{Precision, TooDeep, Truth};
use catoptric_scene::family::Draws;
use catoptric_scene::{Draft, Scene, Transfer, View};
use rayon::prelude::*;

use super::exact::U;
use super::generic::{across, along, direction, dot, norm, unit};
use crate::metrics::Metrics;

/// What f32 leaves of a local sum.
pub const FLOOR: f64 = 3e-6;

/// Ratio up to which a pixel passes.
pub const ALLOWED: f64 = 4.0;

/// Ratio from which on nothing is left to excuse: the picture is of another scene.
const HOPELESS: f64 = 1000.0;

/// Scenes with moved input that every pixel in question is compared with.
const FEW: usize = 4;

/// As many that a pixel is compared with before it fails: between mirrors, one of many moves
/// is what takes a path to the other side of an edge.
const MANY: u64 = 200;

/// By how many u the scenes are moved, one after the other.
const SIZES: [f64; 6] = [1.0, 2.0, 4.0, 8.0, 16.0, 32.0];

/// Pixels that are judged together.
const CHUNK: usize = 64;

/// Truth of a scene, and how it moves.
pub struct Judge {
    view: View,
    transfer: Transfer,
    truth: Truth,
    /// Truth of moved scenes, each with its m.
    moved: Vec<(f64, Truth)>,
    nudges: Vec<[f64; 3]>,
    pixels: Vec<[f64; 3]>,
}

/// A picture's backward error.
#[derive(Clone, Copy, Debug)]
pub struct Backward {
    /// Largest ratio, the spread by the eye ray.
    pub by_eye: f64,
    /// Largest ratio, the spread by all input. Never above `by_eye`. More and more scenes are
    /// tried only until a pixel passes, so that a value close to 4 says no more than that.
    pub by_input: f64,
    /// Pixels whose ratios are above [`ALLOWED`], by the eye ray and by all input. Not counted
    /// where a ratio is above 1000: the picture is then looked at no further, and the ratios
    /// are lower bounds.
    pub beyond: Option<[u64; 2]>,
    /// The raw error.
    pub raw: Metrics,
}

impl Backward {
    /// The other ratio and the pixels beyond, in words.
    #[must_use]
    pub fn beside(&self, other: f64) -> String {
        match self.beyond {
            Some([eye, input]) => format!(
                "the other ratio is {other:.3}; above 4 are {eye} pixels by the eye ray, {input} by all input"
            ),
            None => format!("the other ratio is {other:.0}; pixels above 4 not counted"),
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
        let moved = (0..MANY).filter_map(|seed| {
            let size = SIZES[usize::try_from(seed).expect("few seeds") % SIZES.len()];
            let scene = moved(scene, seed, size * U)?;
            Some((size, Truth::new(&scene, Precision::DoubleDouble)))
        });
        let moved = moved.collect();
        let draws = &mut Draws::new(0);
        let nudges = (0..4).flat_map(|_| {
            let way = direction(draws);
            [1.0, 2.0, 4.0].map(|size| way.map(|x| x * size * U))
        });
        let transfer = scene.image.transfer;
        Ok(Self { view, transfer, truth, moved, nudges: nudges.collect(), pixels })
    }

    /// Truth's picture.
    #[must_use]
    pub fn truth(&self) -> &[[f64; 3]] {
        &self.pixels
    }

    /// Judges a picture of the scene.
    ///
    /// Pixels are taken from the largest error down, until what is left cannot hold the largest
    /// ratio.
    ///
    /// # Errors
    /// A path that is too deep for truth's recursion.
    ///
    /// # Panics
    /// If the picture is of another size.
    pub fn judge(&self, found: &[[f64; 3]]) -> Result<Backward, TooDeep> {
        let raw = Metrics::over(found, &self.pixels, self.transfer, |_| true);
        let errors = found.iter().zip(&self.pixels).map(|(a, b)| difference(a, b));
        let mut by_error: Vec<_> = errors.enumerate().collect();
        by_error.sort_by(|a, b| b.1.total_cmp(&a.1));

        let mut judged = Backward { by_eye: 0.0, by_input: 0.0, beyond: Some([0; 2]), raw };
        for chunk in by_error.chunks(CHUNK) {
            let most = chunk[0].1 / FLOOR;
            if most <= judged.by_input && most <= ALLOWED {
                break;
            }
            if judged.by_input > HOPELESS {
                judged.beyond = None;
                break;
            }
            let ratios = chunk.par_iter().map(|&(index, error)| self.ratios(index, error));
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
    fn ratios(&self, index: usize, error: f64) -> Result<[f64; 2], TooDeep> {
        let width = self.view.crop().width as usize;
        let at = |i: usize| u32::try_from(i).expect("a side is at most 65 535");
        let (x, y) = (at(index % width), at(index / width));
        let mut by_eye = FLOOR;
        for &nudge in &self.nudges {
            let other = self.truth.radiance_nudged(&self.view, x, y, nudge)?;
            by_eye = larger(by_eye, difference(&other, &self.pixels[index]));
        }
        let mut by_input = by_eye;
        let surfaces = self.truth.path(&self.view, x, y).len();
        let most = ALLOWED * (surfaces as f64).sqrt();
        let moved = self.moved.iter().filter(|(size, _)| *size <= most || *size <= ALLOWED);
        for (tried, (_, truth)) in moved.enumerate() {
            let ratio = error / by_input;
            if tried >= FEW && (passes(ratio) || ratio > HOPELESS) {
                break;
            }
            let other = truth.radiance(&self.view, x, y)?;
            by_input = larger(by_input, difference(&other, &self.pixels[index]));
        }
        Ok([error / by_eye, error / by_input])
    }
}

/// Whether a pixel of that ratio passes; NaN does not.
fn passes(ratio: f64) -> bool {
    ratio <= ALLOWED
}

/// The largest difference of a channel; NaN if one is NaN.
fn difference(a: &[f64; 3], b: &[f64; 3]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, larger)
}

/// The larger; NaN if one is NaN.
fn larger(a: f64, b: f64) -> f64 {
    if a >= b || a.is_nan() { a } else { b }
}

/// The scene with all its input moved by `size`; `None` where that leaves a range.
fn moved(scene: &Scene, seed: u64, size: f64) -> Option<Scene> {
    let draws = &mut Draws::new(1 + seed);
    let mut draft = scene.clone().into_draft();
    let (eye, extent) = (draft.camera.position, extent(&draft));
    let distance = |x: [f64; 3]| norm(std::array::from_fn(|i| x[i] - eye[i]));
    for light in &mut draft.lights {
        let reach = distance(light.position);
        light.position = along(light.position, direction(draws), size * reach);
    }
    for sphere in &mut draft.spheres {
        let large = sphere.radius >= 2.0 * extent;
        let reach = if large { extent } else { distance(sphere.center) };
        sphere.center = along(sphere.center, direction(draws), size * reach);
        if !large {
            sphere.radius *= 1.0 + size * draws.between(-1.0, 1.0);
        }
    }
    for plane in &mut draft.planes {
        let reach = size * distance(plane.point);
        plane.point = along(plane.point, direction(draws), reach);
        let normal = unit(plane.normal);
        plane.normal = along(normal, across(draws, normal), size);
    }
    let materials = draft.spheres.iter_mut().map(|sphere| &mut sphere.material);
    let materials = materials.chain(draft.planes.iter_mut().map(|plane| &mut plane.material));
    for material in materials {
        material.reflect = Some(material.mirror());
        let exponent = material.shininess * if draws.unit() < 0.5 { -1.0 } else { 1.0 };
        material.specular *= (1.0 + size).powf(exponent);
    }
    Scene::new(draft).ok()
}

/// How far the surfaces are from the eye, at most.
fn extent(draft: &Draft) -> f64 {
    let from_eye =
        |x: [f64; 3]| -> [f64; 3] { std::array::from_fn(|i| x[i] - draft.camera.position[i]) };
    let spheres = draft.spheres.iter().map(|s| (norm(from_eye(s.center)) - s.radius).abs());
    let planes = draft.planes.iter().map(|p| dot(unit(p.normal), from_eye(p.point)).abs());
    spheres.chain(planes).fold(0.0, larger)
}
