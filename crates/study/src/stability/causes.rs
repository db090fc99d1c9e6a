//! The error of a picture split by its cause: rounding along the path that truth takes, or a
//! path that flipped. One flipped pixel owns the maximum, so the two are told apart.

use catoptric_reference::truth::Vertex;
use catoptric_report::{Column, Table};
use catoptric_scene::{Scene, View};

use super::paths::{Arithmetic, Paths, each_pixel};
use crate::metrics::Metrics;

/// Why a pixel is not truth's: the first thing, from the eye on, in which its path differs.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Cause {
    /// Nothing: the same primitives, lit by the same lights. What is left is rounding.
    Rounding,
    /// A light shines on one path and not on the other, at the same hit.
    Shadow,
    /// One path meets a primitive where the other meets nothing.
    Silhouette,
    /// The paths meet different primitives.
    Another,
    /// One path is cut by `min_weight` where the other goes on.
    Cut,
}

impl Cause {
    /// All causes, in the order of tables.
    pub const ALL: [Self; 5] =
        [Self::Rounding, Self::Shadow, Self::Silhouette, Self::Another, Self::Cut];

    /// The cause's name in tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Rounding => "rounding along the same path",
            Self::Shadow => "shadow edge",
            Self::Silhouette => "silhouette: hit against miss",
            Self::Another => "another primitive",
            Self::Cut => "cut by least weight",
        }
    }

    /// Compares two paths of one eye ray, from the eye on; the first difference decides.
    #[must_use]
    pub fn of(found: &[Vertex], truth: &[Vertex]) -> Self {
        for (found, truth) in found.iter().zip(truth) {
            if found.primitive != truth.primitive {
                return Self::Another;
            }
            if found.lit != truth.lit {
                return Self::Shadow;
            }
        }
        if found.len() == truth.len() {
            return Self::Rounding;
        }
        // The shorter path ends where a ray met nothing, or where none was sent.
        let common = if found.len() < truth.len() { found } else { truth };
        let cut = common.last().is_some_and(|last| !last.followed);
        if cut { Self::Cut } else { Self::Silhouette }
    }
}

/// A picture's error by cause.
#[derive(Clone, Debug, PartialEq)]
pub struct Causes {
    /// The cause of every pixel's error, row by row.
    pub of_pixels: Vec<Cause>,
    /// Shares in the order of [`Cause::ALL`].
    pub shares: Vec<Share>,
}

/// One cause's share of the error.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Share {
    /// The cause.
    pub cause: Cause,
    /// Pixels of that cause.
    pub pixels: u64,
    /// The error over those pixels alone.
    pub metrics: Metrics,
    /// What they add to the picture's RMSE: the squares of all causes' add up to its square.
    pub rmse: f64,
}

/// Splits the error of a picture in f32, `found`, by cause. The formulas are the scene's
/// own; `truth` is the picture in double-double.
///
/// # Panics
/// If the pictures are not of the view's size, or the view has more than one ray a pixel.
#[must_use]
pub fn causes(scene: &Scene, view: &View, found: &[[f64; 3]], truth: &[[f64; 3]]) -> Causes {
    assert_eq!(view.samples(), 1, "a pixel of one ray has one path");
    let paths = Paths::new(scene, view, Arithmetic::of(scene));
    let true_paths = Paths::new(scene, view, Arithmetic::DoubleDouble);
    let of_pixels = each_pixel(view, |x, y| Cause::of(&paths.path(x, y), &true_paths.path(x, y)));
    assert_eq!((found.len(), truth.len()), (of_pixels.len(), of_pixels.len()), "the view's size");

    let share = |cause| {
        let own = |picture: &[[f64; 3]]| {
            let pixels = picture.iter().zip(&of_pixels).filter(|(_, c)| **c == cause);
            pixels.map(|(pixel, _)| *pixel).collect::<Vec<_>>()
        };
        let metrics = Metrics::of(&own(found), &own(truth));
        let pixels = of_pixels.iter().filter(|c| **c == cause).count();
        let rmse = metrics.rmse * (pixels as f64 / of_pixels.len() as f64).sqrt();
        Share { cause, pixels: pixels as u64, metrics, rmse }
    };
    let shares = Cause::ALL.map(share).to_vec();
    Causes { of_pixels, shares }
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "Scene", meaning: "The scene, and its formulas." },
    Column {
        key: "cause",
        heading: "Cause",
        meaning: "The first thing in which a pixel's path differs from truth's.",
    },
    Column { key: "pixels", heading: "Pixels", meaning: "Pixels of that cause." },
    Column {
        key: "off_by_more",
        heading: "Off by more",
        meaning: "Of those, pixels off by more than one 8-bit level.",
    },
    Column { key: "max", heading: "Max", meaning: "Their largest error of a channel, linear." },
    Column {
        key: "rmse",
        heading: "RMSE",
        meaning: "What they add to the picture's RMSE, as the root of their share of its square.",
    },
];

/// Rows of several pictures, a row a cause; causes without pixels are left out.
#[must_use]
pub fn table(pictures: &[(String, Causes)]) -> Table {
    let caption = "The error split by cause: rounding along the same path, or a path that flipped.";
    let mut table = Table::new("error-by-cause", COLUMNS, caption);
    for (scene, causes) in pictures {
        for share in causes.shares.iter().filter(|share| share.pixels > 0) {
            table.push([
                scene.clone().into(),
                share.cause.name().into(),
                share.pixels.into(),
                share.metrics.off_by_more.into(),
                share.metrics.max.into(),
                share.rmse.into(),
            ]);
        }
    }
    table
}
