//! The condition map: how far each pixel's colour moves when its eye ray does by a few
//! roundings. A pixel on which any arithmetic must err shows before any arithmetic is tried.
//!
//! Two answers, both from double-double:
//! - **amplified**: the colour's derivative by the eye ray's direction, times u = 2^-24. It is
//!   what a path amplifies and knows nothing of edges.
//! - **moved**: the largest change of the colour over nudges of [`REACH`] u in four directions
//!   across the ray. A silhouette, a shadow's edge or another sphere within that reach shows
//!   as its full step, and where a derivative promises more than colours can differ, as in
//!   deep mirror rooms, this does not.
//!
//! The colour is asked, not the path: a path that is amplified and then weighs nothing, or
//! meets one even colour, does no harm. What is not foretold: edges in other directions than
//! the four; what a formula does worse than rounding its input; and, in deep closed rooms,
//! which of the many edges within reach the rounding along the path meets: there nudges of
//! the eye ray are samples of chance.

mod shade;

use catoptric_reference::truth::{Precision, TooDeep, Truth};
use catoptric_report::{Cell, Column, Picture, Table};
use catoptric_scene::{Scene, View};
use glam::DVec3;

use super::paths::each_pixel;
use crate::formula::U;
use crate::metrics::{Metrics, difference, larger};

/// How many u of nudge an edge is looked for in, as in the backward ratio.
pub const REACH: f64 = 4.0;

/// An error of up to so many times a pixel's value counts as foretold.
pub const FACTOR: f64 = 4.0;

/// The maps' names in rows and pictures.
pub const AMPLIFIED: &str = "amplified";
/// See [`AMPLIFIED`].
pub const MOVED: &str = "moved";

/// Nudge of the derivative: edges this near are rare, and a colour's last bit, 1e-16, divided
/// by it is small against 1.
const STEP: f64 = 1.0 / (1_u64 << 33) as f64;

/// How far each pixel's colour may move.
#[derive(Clone, Debug, PartialEq)]
pub struct Condition {
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// Row by row: |dColour/dDirection| u, the largest channel.
    pub amplified: Vec<f64>,
    /// Row by row: the largest change of a channel within reach.
    pub moved: Vec<f64>,
}

/// What a map foretold of a picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Foretold {
    /// Pixels off by more than one 8-bit level.
    pub wrong: u64,
    /// Wrong pixels whose error is at most [`FACTOR`] times their value.
    pub foretold: u64,
    /// Pixels that could be wrong: [`FACTOR`] times their value is more than one level.
    pub flagged: u64,
    /// Flagged pixels that are wrong.
    pub flagged_wrong: u64,
}

/// The condition map of a view: seven colours of truth a pixel.
///
/// # Errors
/// A path too deep for truth's recursion.
pub fn condition(scene: &Scene, view: &View) -> Result<Condition, TooDeep> {
    let truth = Truth::new(scene, Precision::DoubleDouble);
    let pixel = |x, y| {
        let eye_ray = DVec3::from_array(truth.direction(view, x, y));
        let (right, up) = eye_ray.any_orthonormal_pair();
        let colour = truth.radiance(view, x, y)?;
        let change = |nudge: DVec3| {
            let moved = truth.radiance_nudged(view, x, y, nudge.to_array())?;
            Ok(difference(&colour, &moved))
        };
        let (a, b) = (change(STEP * right)?, change(STEP * up)?);
        let amplified = (a * a + b * b).sqrt() / STEP * U;
        let nudges = [right, -right, up, -up].map(|across| REACH * U * across);
        let moved = nudges.into_iter().map(change).collect::<Result<Vec<_>, _>>()?;
        Ok((amplified, moved.into_iter().fold(0.0, larger)))
    };
    let pixels = each_pixel(view, pixel).into_iter().collect::<Result<Vec<_>, _>>()?;
    let (amplified, moved) = pixels.into_iter().unzip();
    Ok(Condition { width: view.crop().width, height: view.crop().height, amplified, moved })
}

/// Compares a map with what a picture got wrong.
///
/// # Panics
/// If the pictures and the map are not of one size.
#[must_use]
pub fn foretold(map: &[f64], found: &[[f64; 3]], truth: &[[f64; 3]]) -> Foretold {
    assert_eq!((map.len(), found.len()), (truth.len(), truth.len()), "pictures of one size");
    let mut sum = Foretold { wrong: 0, foretold: 0, flagged: 0, flagged_wrong: 0 };
    for ((value, found), truth) in map.iter().zip(found).zip(truth) {
        let error = Metrics::of(&[*found], &[*truth]);
        let wrong = error.off_by_more > 0 || error.not_finite > 0;
        let flagged = FACTOR * value > 1.0 / 255.0;
        sum.wrong += u64::from(wrong);
        sum.foretold += u64::from(wrong && error.not_finite == 0 && error.max <= FACTOR * value);
        sum.flagged += u64::from(flagged);
        sum.flagged_wrong += u64::from(flagged && wrong);
    }
    sum
}

impl Foretold {
    /// The share of wrong pixels that were foretold; `None` if there is none.
    #[must_use]
    pub fn recall(&self) -> Option<f64> {
        (self.wrong > 0).then(|| self.foretold as f64 / self.wrong as f64)
    }

    /// The share of flagged pixels that are wrong; `None` if there is none.
    #[must_use]
    pub fn precision(&self) -> Option<f64> {
        (self.flagged > 0).then(|| self.flagged_wrong as f64 / self.flagged as f64)
    }
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "Scene", meaning: "The scene, and its formulas." },
    Column {
        key: "map",
        heading: "Map",
        meaning: "amplified: derivative times u. moved: the change within 4 u, edges too.",
    },
    Column { key: "wrong", heading: "Wrong", meaning: "Pixels off by more than one 8-bit level." },
    Column {
        key: "foretold",
        heading: "Foretold",
        meaning: "Of the wrong pixels, those whose error is at most 4 times their value.",
    },
    Column {
        key: "recall",
        heading: "Recall",
        meaning: "Foretold over wrong, 0 to 1; the share of wrong pixels that the map foretold.",
    },
    Column {
        key: "flagged",
        heading: "Flagged",
        meaning: "Pixels of which 4 times their value is more than one level.",
    },
    Column {
        key: "precision",
        heading: "Precision",
        meaning: "Flagged pixels that are wrong over flagged pixels, 0 to 1.",
    },
];

/// Rows of several pictures: the name, the map's name, and what it foretold.
#[must_use]
pub fn table(pictures: &[(String, &'static str, Foretold)]) -> Table {
    let caption =
        "What the condition map, made without trying f32, foretold of f32's wrong pixels.";
    let mut table = Table::new("condition", COLUMNS, caption);
    for (scene, map, found) in pictures {
        table.push([
            scene.clone().into(),
            (*map).into(),
            found.wrong.into(),
            found.foretold.into(),
            found.recall().map_or("no wrong pixel".into(), Cell::from),
            found.flagged.into(),
            found.precision().into(),
        ]);
    }
    table
}

/// Both maps as pictures, `amplified` first: the logarithm from 1e-8 (dark) to 1 (bright), in
/// viridis.
#[must_use]
pub fn pictures(scene: &str, condition: &Condition, zoom: u32) -> [Picture; 2] {
    let colour = |value: &f64| shade::viridis((value.log10() + 8.0) / 8.0);
    let maps = [
        (AMPLIFIED, "the derivative of its colour by the eye ray, times u", &condition.amplified),
        (MOVED, "the largest change of its colour within 4 u, edges too", &condition.moved),
    ];
    maps.map(|(map, what, values)| Picture {
        name: format!("condition-{scene}-{map}"),
        caption: format!("{scene}, {map}: of each pixel {what}; from 1e-8 (dark) to 1 (bright), by powers of ten."),
        width: condition.width,
        height: condition.height,
        pixels: values.iter().map(colour).collect(),
        zoom,
    })
}
