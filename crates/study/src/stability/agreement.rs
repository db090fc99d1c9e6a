//! Path agreement: how many paths still meet the primitives that truth's path meets.

use catoptric_report::{Cell, Column, Plot, Scale, Series, Table};
use catoptric_scene::{Scene, View};

use super::paths::{Arithmetic, Paths, each_pixel, parting};

/// Arithmetics whose paths are compared with those of double-double.
pub const COMPARED: [Arithmetic; 4] =
    [Arithmetic::Textbook, Arithmetic::Robust, Arithmetic::RobustF64, Arithmetic::F64];

/// How many eye rays' paths differ from truth's, by bounce.
#[derive(Clone, Debug, PartialEq)]
pub struct Agreement {
    /// Eye rays: one a pixel.
    pub paths: u64,
    /// Entry d: truth's paths that have a hit at bounce d; 0 is what the eye sees.
    pub reaching: Vec<u64>,
    /// Paths that have parted, by arithmetic. Entry d: paths whose sequence of primitives differs
    /// from truth's at bounce d or before. One entry longer than `reaching`: at the last one all
    /// of truth's paths have ended.
    pub parted: Vec<(Arithmetic, Vec<u64>)>,
}

/// Follows the eye ray of every pixel (of its first sub-sample) in each of the arithmetics
/// and in double-double.
#[must_use]
pub fn agreement(scene: &Scene, view: &View, compared: &[Arithmetic]) -> Agreement {
    let truth = Paths::new(scene, view, Arithmetic::DoubleDouble);
    let others: Vec<_> = compared.iter().map(|&a| Paths::new(scene, view, a)).collect();
    // For every pixel: how long truth's path is, and where each other one parts from it.
    let pixels = each_pixel(view, |x, y| {
        let path = truth.path(x, y);
        let partings: Vec<_> = others.iter().map(|o| parting(&o.path(x, y), &path)).collect();
        (path.len(), partings)
    });

    let longest = pixels.iter().map(|(hits, _)| *hits).max().unwrap_or(0);
    let count = |flags: &mut dyn Iterator<Item = bool>| flags.filter(|flag| *flag).count() as u64;
    let reaching =
        (0..longest).map(|d| count(&mut pixels.iter().map(|(hits, _)| *hits > d))).collect();
    let parted = compared.iter().enumerate().map(|(i, &arithmetic)| {
        let by = |d| {
            let partings = pixels.iter().map(|(_, partings)| partings[i]);
            count(&mut partings.map(|parting| parting.is_some_and(|at| at <= d)))
        };
        (arithmetic, (0..=longest).map(by).collect())
    });
    Agreement { paths: pixels.len() as u64, reaching, parted: parted.collect() }
}

impl Agreement {
    /// The share of all paths that differ at bounce d or before; 0 without paths.
    #[must_use]
    pub fn share(&self, parted: &[u64], bounce: usize) -> f64 {
        let parted = parted.get(bounce).or(parted.last()).copied().unwrap_or(0);
        if self.paths == 0 { 0.0 } else { parted as f64 / self.paths as f64 }
    }
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "Scene", meaning: "The scene." },
    Column { key: "arithmetic", heading: "Arithmetic", meaning: "Formulas and precision." },
    Column {
        key: "bounce",
        heading: "Bounce",
        meaning: "Hits before this one; 0 is what the eye sees.",
    },
    Column {
        key: "reaching",
        heading: "Paths of truth",
        meaning: "Paths of truth that have a hit at this bounce.",
    },
    Column {
        key: "parted",
        heading: "Parted",
        meaning: "Paths whose sequence of primitives differs from truth's at this bounce or before.",
    },
    Column { key: "share", heading: "Share", meaning: "Parted paths over all paths, 0 to 1." },
];

/// Rows of several scenes: bounces 0 to 4, then about every doubling, and the last.
#[must_use]
pub fn table(scenes: &[(String, Agreement)]) -> Table {
    let caption = "Paths that no longer meet the primitives that truth's path meets, by bounce.";
    let mut table = Table::new("path-agreement", COLUMNS, caption);
    for (scene, agreement) in scenes {
        for (arithmetic, parted) in &agreement.parted {
            let last = parted.len().saturating_sub(1);
            let shown = |d: usize| d <= 4 || d == last || matches!(d, 6 | 8 | 12 | 16 | 24 | 32);
            for bounce in (0..=last).filter(|&d| shown(d) || d.is_power_of_two()) {
                table.push([
                    scene.clone().into(),
                    arithmetic.name().into(),
                    bounce.into(),
                    agreement.reaching.get(bounce).copied().unwrap_or(0).into(),
                    parted.get(bounce).copied().map_or(Cell::Nothing, Cell::from),
                    agreement.share(parted, bounce).into(),
                ]);
            }
        }
    }
    table
}

/// Curves of one scene: the share of parted paths against the bounce.
#[must_use]
pub fn plot(scene: &str, agreement: &Agreement) -> Plot {
    let series = agreement.parted.iter().map(|(arithmetic, parted)| Series {
        name: arithmetic.name().to_owned(),
        points: (0..parted.len()).map(|d| (d as f64, agreement.share(parted, d))).collect(),
        dashed: false,
    });
    Plot {
        name: format!("path-agreement-{scene}"),
        title: format!("Path agreement: {scene}"),
        caption: "Share of paths that differ from truth's at a bounce or before; none, where a \
                  curve is missing."
            .to_owned(),
        x: "bounce".to_owned(),
        y: "share of paths that parted".to_owned(),
        x_scale: Scale::Linear,
        y_scale: Scale::Log,
        series: series.collect(),
    }
}
