//! Where the speed comes from: one change at a time, from the recursion to the engine.

use catoptric_core::Isa;
use catoptric_ladder::RUNGS;
use catoptric_scene::{Compiled, Film, Grid, View};

use super::{Mismatch, Request};
use crate::Watch;
use crate::metrics::differing_pixels;
use crate::report::{Column, Report, Table};
use crate::subject::Subject;
use crate::timing::in_turn;
use crate::tracer::{Threads, Tracer};
use crate::way::Way;

const COLUMNS: &[Column] = &[
    Column { key: "step", heading: "step", meaning: "What is changed, on top of the rows above." },
    Column { key: "threads", heading: "threads", meaning: "Threads that traced." },
    Column { key: "min_ms", heading: "min ms", meaning: "Least time of tracing alone, ms." },
    Column { key: "median_ms", heading: "median ms", meaning: "Median time of tracing alone, ms." },
    Column { key: "factor", heading: "times faster", meaning: "Than the row above." },
    Column { key: "total", heading: "in all", meaning: "Times faster than the first row." },
];

/// Adds the steps on one scene, to its own depth.
///
/// # Errors
/// A step's picture differs from the first one's.
pub(super) fn add(
    report: &mut Report,
    subject: &Subject,
    request: &Request,
    watch: &dyn Watch,
) -> Result<(), Mismatch> {
    watch.say(&format!("{}: where the speed comes from", subject.name));
    let most = request.threads.counts().last().unwrap_or(1);
    let packets = |isa| Way::Tracer(Tracer::Packet(isa));
    let [.., the_loop, _, _] = &RUNGS;
    let mut steps = vec![
        ("the recursion".to_owned(), Way::Tracer(Tracer::Recursive), 1),
        ("a scalar loop with an explicit stack".to_owned(), Way::Rung(the_loop, request.isa), 1),
        ("eight portable lanes, nothing left out".to_owned(), Way::Everything(Isa::Portable), 1),
    ];
    if request.isa != Isa::Portable {
        let lanes = format!("eight lanes of {}", request.isa);
        steps.push((lanes, Way::Everything(request.isa), 1));
    }
    let plan = "what the scene does not need left out".to_owned();
    steps.push((plan, packets(request.isa), 1));
    if most > 1 {
        steps.push((format!("{most} threads"), packets(request.isa), most));
    }
    let counts = steps.iter().map(|(_, _, threads)| *threads);
    let Ok(threads) = Threads::new(counts) else { return Ok(()) };

    let depth = subject.scene.render.max_depth;
    let compiled = Compiled::new(&subject.scene);
    let grid = Grid::new(&View::whole(&subject.scene));
    let mut film = Film::new(grid.width, grid.height);
    let mut first = None;
    for (_, way, count) in &steps {
        let (rendered, _) = threads.time(*count, || way.render(&compiled, &grid, &mut film));
        if rendered.is_err() {
            report.text(format!(
                "{}: a path to depth {depth} is deeper than a stack, so the steps are not compared.",
                subject.name
            ));
            return Ok(());
        }
        let first = first.get_or_insert_with(|| film.clone());
        if differing_pixels(first, &film) > 0 {
            let (engine, scene) = (way.name(), subject.name.clone());
            return Err(Mismatch { scene, depth, engine, threads: *count });
        }
    }
    let times = in_turn(steps.len(), request.repeat, watch, |i| {
        let (_, way, count) = &steps[i];
        Some(threads.time(*count, || way.render(&compiled, &grid, &mut film)).1)
    });

    let caption = format!(
        "Where the speed comes from: {} to depth {depth}, every step with the same bits.",
        subject.name
    );
    let mut table = Table::new("waterfall", COLUMNS, caption);
    let least: Vec<Option<f64>> = times.iter().map(|times| times.min_ms()).collect();
    for (i, (step, _, threads)) in steps.iter().enumerate() {
        let over = |other: Option<f64>| Some(other? / least[i]?);
        table.push([
            step.as_str().into(),
            (*threads).into(),
            least[i].into(),
            times[i].median_ms().into(),
            i.checked_sub(1).and_then(|above| over(least[above])).into(),
            over(least[0]).into(),
        ]);
    }
    report.heading("Where the speed comes from");
    report.table(table);
    Ok(())
}
