//! Cost against depth: what each further reflection takes, by engine and number of threads.
//!
//! Every picture is compared bit for bit with the recursion's, and its ray counts too, before
//! its making is timed.

mod levels;
mod packing;
mod plots;
mod request;
mod row;
mod waterfall;

use catoptric_report::{Report, Table};
use catoptric_scene::{Compiled, Grid, View};

use crate::Watch;
use crate::checked::{Group, check_then_time};
use crate::subject::Subject;
use crate::timing::noise;
use crate::way::Way;
pub use request::{Mismatch, Request};
use row::{COLUMNS, Row, words};

/// The depths that are asked for unless others are.
pub const DEPTHS: [u32; 11] = [0, 1, 2, 3, 4, 5, 8, 16, 32, 64, 128];

/// Measures all of it.
///
/// # Errors
/// A picture or a ray count differs from the recursion's.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Report, Mismatch> {
    let mut report = Report::new("depth", "Cost against depth");
    let mut table = Table::new(
        "depth",
        COLUMNS,
        "Time of tracing alone by scene, engine, depth and threads, all of a scene run in turn.",
    );
    let mut parts = Vec::new();
    // Measure scene by scene. The table of all comes before the words on each.
    for subject in request.subjects {
        if watch.stopped() {
            break;
        }
        watch.say(&format!("{}: checking every picture, then timing", subject.name));
        let rows = measure(subject, request, watch)?;
        for row in &rows {
            row.push(&mut table, &rows);
        }
        parts.push((subject, rows));
    }
    report.table(table);
    // Words, plots and levels of each scene.
    let mut levels = levels::table();
    for (subject, rows) in &parts {
        report.heading(&subject.name);
        report.text(words(rows));
        if let Some(noise) = noise(rows.iter().map(|row| &row.times)) {
            report.text(noise);
        }
        plots::add(&mut report, &subject.name, rows);
        if !watch.stopped() {
            levels::add(&mut report, &mut levels, subject, rows, request);
        }
    }
    report.heading("What happens at each depth");
    report.table(levels);
    // The waterfall is of the first scene alone.
    if let Some((subject, _)) = parts.first()
        && !watch.stopped()
    {
        waterfall::add(&mut report, subject, request, watch)?;
    }
    report.complete = !watch.stopped();
    Ok(report)
}

fn measure(subject: &Subject, request: &Request, watch: &dyn Watch) -> Result<Vec<Row>, Mismatch> {
    let compiled: Vec<_> =
        request.depths.iter().map(|&depth| Compiled::new(&subject.to_depth(depth))).collect();
    let on = |&way: &Way| request.threads.counts().map(move |threads| (way, threads));
    let ways: Vec<_> = request.ways.iter().flat_map(on).collect();
    let group = |scene| Group { scene, ways: &ways };
    let groups: Vec<_> = compiled.iter().map(group).collect();
    let grid = Grid::new(&View::whole(&subject.scene));
    let checked = check_then_time(&groups, &grid, request.threads, request.repeat, watch);
    let checked = checked.map_err(|(group, way, difference)| {
        let (way, threads) = ways[way];
        let (scene, depth) = (subject.name.clone(), request.depths[group]);
        Mismatch { scene, depth, way: way.name().to_owned(), threads, difference }
    })?;
    let measured = request.depths.iter().flat_map(|depth| ways.iter().map(move |way| (depth, way)));
    let row = |((&depth, &(way, threads)), checked): (_, crate::checked::Checked)| {
        let (outcome, times) = (checked.outcome, checked.times);
        Row { scene: subject.name.clone(), way, depth, threads, outcome, times }
    };
    Ok(measured.zip(checked).map(row).collect())
}
