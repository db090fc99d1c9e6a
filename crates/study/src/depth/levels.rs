//! What happens at each depth: rays, hits, and how many of eight neighbours still live.

use catoptric_reference::path::{eye_ray, follow};
use catoptric_scene::{Compiled, DepthCount, Grid, View};
use rayon::prelude::*;

use super::{Request, Row};
use crate::report::{Column, Plot, Report, Scale, Series, Table};
use crate::subject::Subject;

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "depth", heading: "depth", meaning: "Reflections behind the ray." },
    Column {
        key: "rays",
        heading: "rays",
        meaning: "Rays traced at this depth, shadow rays apart.",
    },
    Column { key: "hits", heading: "hits", meaning: "Of those, rays that met something." },
    Column { key: "shadow", heading: "shadow rays", meaning: "Towards lit sides, logical." },
    Column {
        key: "alive",
        heading: "alive of 8",
        meaning: "Mean number of living rays in packets of eight neighbours of which one lives.",
    },
];

/// Neighbours in a row that a packet holds.
const LANES: usize = 8;

/// The rays of each depth, by scene.
pub(super) fn table() -> Table {
    Table::new(
        "levels",
        COLUMNS,
        "Rays of each depth, as many reflections allowed as were measured at most. Lanes of a \
         packet that have ended compute what nobody reads: alive is what is left to win by \
         moving rays together.",
    )
}

/// Adds a scene's rays of each depth to the table, and a plot of them.
pub(super) fn add(
    report: &mut Report,
    table: &mut Table,
    subject: &Subject,
    rows: &[Row],
    request: &Request,
) {
    let deepest = rows.iter().filter(|row| row.counts.is_some()).max_by_key(|row| row.depth);
    let Some(Row { counts: Some(counts), depth, .. }) = deepest else { return };
    let compiled = Compiled::new(&subject.to_depth(*depth));
    let grid = Grid::new(&View::whole(&subject.scene));
    let alive = request.threads.most().install(|| alive(&compiled, &grid));
    for (depth, count) in counts.depths.iter().enumerate() {
        table.push([
            subject.name.as_str().into(),
            depth.into(),
            count.rays.into(),
            count.hits.into(),
            count.shadow.into(),
            alive.get(depth).copied().into(),
        ]);
    }
    let curve = |name: &str, value: fn(&DepthCount) -> u64| Series {
        name: name.to_owned(),
        points: (0..).zip(&counts.depths).map(|(d, c)| (f64::from(d), value(c) as f64)).collect(),
        dashed: false,
    };
    report.plot(Plot {
        name: format!("depth-{}-rays", subject.name),
        title: format!("{}: rays of each depth", subject.name),
        caption: "Where rays end early, a higher max_depth costs nothing.".to_owned(),
        x: "depth".to_owned(),
        y: "rays".to_owned(),
        x_scale: Scale::Linear,
        y_scale: Scale::Log,
        series: vec![curve("rays", |c| c.rays), curve("hits", |c| c.hits)],
    });
}

/// For each depth, the mean number of living rays in packets of which at least one lives.
fn alive(scene: &Compiled, grid: &Grid) -> Vec<f64> {
    let row = |&row: &f32| {
        let mut living: Vec<(u64, u64)> = Vec::new();
        for columns in grid.columns.chunks(LANES) {
            let lengths = columns.iter().map(|&column| rays(scene, column, row));
            let lengths: Vec<usize> = lengths.collect();
            let deepest = lengths.iter().copied().max().unwrap_or(0);
            if living.len() < deepest {
                living.resize(deepest, (0, 0));
            }
            for (depth, (packets, rays)) in living.iter_mut().enumerate().take(deepest) {
                *packets += 1;
                *rays += lengths.iter().filter(|&&length| length > depth).count() as u64;
            }
        }
        living
    };
    let add = |mut sum: Vec<(u64, u64)>, part: Vec<(u64, u64)>| {
        if sum.len() < part.len() {
            sum.resize(part.len(), (0, 0));
        }
        for (sum, part) in sum.iter_mut().zip(part) {
            *sum = (sum.0 + part.0, sum.1 + part.1);
        }
        sum
    };
    let living = grid.rows.par_iter().map(row).reduce(Vec::new, add);
    living.into_iter().map(|(packets, rays)| rays as f64 / packets as f64).collect()
}

/// How many rays a path has, the one that meets nothing among them.
fn rays(scene: &Compiled, column: f32, row: f32) -> usize {
    let steps = follow(scene, eye_ray(scene, column, row));
    steps.len() + usize::from(steps.last().is_none_or(|step| step.followed))
}
