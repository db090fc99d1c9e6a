//! What happens at each depth: rays, hits, and how many of eight still live.

use catoptric_reference::path::{eye_ray, follow};
use catoptric_report::{Column, Plot, Report, Scale, Series, Table};
use catoptric_scene::{Compiled, Counts, DepthCount, Grid, View};
use rayon::prelude::*;

use super::packing::Lengths;
use super::request::Request;
use super::row::Row;
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
        key: "alive_neighbours",
        heading: "of 8 neighbours",
        meaning: "Mean number of rays alive among eight neighbours in a row of which one is.",
    },
    Column {
        key: "alive_packet",
        heading: "of 8 in a packet",
        meaning: "Mean number of rays in the engine's packets, which it packs anew at each \
                  depth; not known past depth 1024.",
    },
];

/// The rays of each depth, by scene.
pub(super) fn table() -> Table {
    Table::new(
        "levels",
        COLUMNS,
        "Rays of each depth, as many reflections allowed as were measured at most. A lane whose \
         ray has ended computes what nobody reads: a packet of eight neighbours that stays \
         together would keep as many alive as the first of the two columns says. The engine \
         packs the rays of a tile anew at each depth; the second says how many its packets hold.",
    )
}

/// Adds a scene's rays of each depth to the table, and plots of them.
pub(super) fn add(
    report: &mut Report,
    table: &mut Table,
    subject: &Subject,
    rows: &[Row],
    request: &Request,
) {
    let deepest = rows.iter().filter(|row| row.counts().is_some()).max_by_key(|row| row.depth);
    let Some((depth, counts)) = deepest.and_then(|row| Some((row.depth, row.counts()?))) else {
        return;
    };
    let compiled = Compiled::new(&subject.to_depth(depth));
    let grid = Grid::new(&View::whole(&subject.scene));
    let lengths = request.threads.most().install(|| lengths(&compiled, &grid));
    let (neighbours, packets) = (lengths.among_neighbours(), lengths.in_packets());
    for (depth, count) in counts.depths.iter().enumerate() {
        table.push([
            subject.name.as_str().into(),
            depth.into(),
            count.rays.into(),
            count.hits.into(),
            count.shadow.into(),
            neighbours.get(depth).copied().into(),
            packets.get(depth).copied().into(),
        ]);
    }
    report.plot(rays(&subject.name, counts));
    report.plot(alive(&subject.name, neighbours, packets));
}

fn rays(scene: &str, counts: &Counts) -> Plot {
    let curve = |name: &str, value: fn(&DepthCount) -> u64| Series {
        name: name.to_owned(),
        points: over_depth(counts.depths.iter().map(|count| value(count) as f64)),
        dashed: false,
    };
    Plot {
        name: format!("depth-{scene}-rays"),
        title: format!("{scene}: rays of each depth"),
        caption: "Where rays end early, a higher max_depth costs nothing.".to_owned(),
        x: "depth".to_owned(),
        y: "rays".to_owned(),
        x_scale: Scale::Doublings,
        y_scale: Scale::Log,
        series: vec![curve("rays", |c| c.rays), curve("hits", |c| c.hits)],
    }
}

fn alive(scene: &str, neighbours: Vec<f64>, packets: Vec<f64>) -> Plot {
    let curve = |name: &str, means: Vec<f64>| Series {
        name: name.to_owned(),
        points: over_depth(means.into_iter()),
        dashed: false,
    };
    Plot {
        name: format!("depth-{scene}-alive"),
        title: format!("{scene}: rays alive, of eight"),
        caption: "Eight neighbours that stay together, of whom one is alive, and the packets of \
                  the engine, which packs the rays of a tile anew at each depth: the last packet \
                  of each tile alone is not full."
            .to_owned(),
        x: "depth".to_owned(),
        y: "rays alive, mean".to_owned(),
        x_scale: Scale::Doublings,
        y_scale: Scale::Linear,
        series: vec![curve("neighbours", neighbours), curve("packets", packets)],
    }
}

fn over_depth(values: impl Iterator<Item = f64>) -> Vec<(f64, f64)> {
    (0..).map(f64::from).zip(values).collect()
}

/// How many rays each path has, the one that meets nothing among them.
fn lengths(scene: &Compiled, grid: &Grid) -> Lengths {
    let length = |column: f32, row: f32| {
        let steps = follow(scene, eye_ray(scene, column, row));
        steps.len() + usize::from(steps.last().is_none_or(|step| step.followed))
    };
    let row = |&row: &f32| grid.columns.iter().map(move |&column| length(column, row));
    let rays = grid.rows.par_iter().flat_map_iter(row).collect();
    Lengths { width: grid.columns.len(), rays }
}
