//! Sources of the speed: one change at a time, from the recursion to the engine.

use catoptric_core::{Isa, Omission, Plan};
use catoptric_report::{Column, Report, Table};
use catoptric_scene::{Compiled, Grid, View};

use super::request::{Mismatch, Request};
use crate::Watch;
use crate::checked::{Group, check_then_time, rung};
use crate::subject::Subject;
use crate::timing::noise;
use crate::tracer::{Threads, Tracer};
use crate::way::Way;

const COLUMNS: &[Column] = &[
    Column { key: "step", heading: "step", meaning: "What is changed, on top of the rows above." },
    Column { key: "threads", heading: "threads", meaning: "Threads that traced." },
    Column { key: "min_ms", heading: "min ms", meaning: "Least time of tracing alone, ms." },
    Column { key: "median_ms", heading: "median ms", meaning: "Median time of tracing alone, ms." },
    Column { key: "runs", heading: "runs", meaning: "How often it was timed, in turn with all." },
    Column { key: "factor", heading: "times faster", meaning: "Than the row above." },
    Column { key: "total", heading: "in all", meaning: "Times faster than the first row." },
];

/// Adds the steps on one scene, to its own depth.
///
/// # Errors
/// A step's picture or ray counts differ from the first one's.
pub(super) fn add(
    report: &mut Report,
    subject: &Subject,
    request: &Request,
    watch: &dyn Watch,
) -> Result<(), Mismatch> {
    watch.say(&format!("{}: where the speed comes from", subject.name));
    let depth = subject.scene.render.max_depth;
    let scene = Compiled::new(&subject.scene);
    let grid = Grid::new(&View::whole(&subject.scene));
    let most = request.threads.counts().last().unwrap_or(1);
    let (steps, ways): (Vec<String>, Vec<(Way, usize)>) =
        steps(&Plan::new(&scene, &grid), request.isa, most).into_iter().unzip();
    report.heading("Where the speed comes from");
    // A machine may refuse the threads; that ends this part and not the study.
    let threads = match Threads::new(ways.iter().map(|(_, threads)| *threads)) {
        Ok(threads) => threads,
        Err(error) => {
            report.text(format!("Not measured: {most} threads cannot be had: {error}."));
            return Ok(());
        }
    };
    // Steps are compared only if all of them give the recursion's picture.
    let groups = [Group { scene: &scene, ways: &ways }];
    let checked = check_then_time(&groups, &grid, &threads, request.repeat, watch);
    let checked = checked.map_err(|(_, i, difference)| {
        let (scene, way, threads) = (subject.name.clone(), steps[i].clone(), ways[i].1);
        Mismatch { scene, depth, way, threads, difference }
    })?;
    if checked.iter().any(|step| step.outcome.counts().is_none()) {
        report.text(format!(
            "{}: a path to depth {depth} is deeper than a stack, so the steps are not compared.",
            subject.name
        ));
        return Ok(());
    }

    // A row for each step, with its gain over the step above and over the first.
    let caption = format!(
        "Where the speed comes from: {} to depth {depth}, every step with the same bits and rays.",
        subject.name
    );
    let mut table = Table::new("waterfall", COLUMNS, caption);
    let least: Vec<Option<f64>> = checked.iter().map(|step| step.times.min_ms()).collect();
    for (i, step) in checked.iter().enumerate() {
        let over = |other: Option<f64>| Some(other? / least[i]?);
        table.push([
            steps[i].as_str().into(),
            ways[i].1.into(),
            least[i].into(),
            step.times.median_ms().into(),
            step.times.runs().into(),
            i.checked_sub(1).and_then(|above| over(least[above])).into(),
            over(least[0]).into(),
        ]);
    }
    report.table(table);
    if let Some(noise) = noise(checked.iter().map(|step| &step.times)) {
        report.text(noise);
    }
    Ok(())
}

/// What is changed, and how it is traced then on how many threads.
fn steps(plan: &Plan, isa: Isa, threads: usize) -> Vec<(String, (Way, usize))> {
    let mut steps = vec![
        ("the recursion".to_owned(), (Way::Tracer(Tracer::Recursive), 1)),
        ("a scalar loop with an explicit stack".to_owned(), (Way::Rung(rung("r3"), isa), 1)),
        ("eight rays in turn, with masks".to_owned(), (Way::Rung(rung("r4"), isa), 1)),
        ("eight portable lanes, nothing left out".to_owned(), (Way::Everything(Isa::Portable), 1)),
    ];
    if isa != Isa::Portable {
        steps.push((format!("eight lanes of {isa}"), (Way::Everything(isa), 1)));
    }
    for (i, omission) in Omission::ALL.iter().enumerate() {
        if plan.omits(*omission) {
            let left_out = match omission {
                Omission::Nested => "spheres inside others",
                Omission::Tiles => "primitives out of a tile's sight",
                Omission::Occluders => "primitives out of a lamp's way",
                Omission::Directions => "directions that nobody asks for",
                Omission::Shadows => "shadows on what no lamp lights",
            };
            let so_far = &ALL[..=i];
            steps.push((format!("{left_out} left out"), (Way::Omitting(isa, so_far), 1)));
        }
    }
    if threads > 1 {
        steps.push((format!("{threads} threads"), (Way::Tracer(Tracer::Packet(isa)), threads)));
    }
    steps
}

static ALL: [Omission; 5] = Omission::ALL;
