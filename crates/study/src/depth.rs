//! Cost against depth: what each further reflection takes, by engine and number of threads.
//!
//! Every picture is compared bit for bit with the recursion's before its making is timed.

mod levels;
mod plots;
mod waterfall;

use catoptric_core::Isa;
use catoptric_scene::{Compiled, Counts, Film, Grid, View};

use crate::Watch;
use crate::metrics::differing_pixels;
use crate::report::{Cell, Column, Report, Table};
use crate::subject::Subject;
use crate::timing::{Repeat, Times, in_turn};
use crate::tracer::{Threads, Tracer};

/// The depths that are asked for unless others are.
pub const DEPTHS: [u32; 11] = [0, 1, 2, 3, 4, 5, 8, 16, 32, 64, 128];

/// What is measured.
pub struct Request<'a> {
    /// Scenes, in order.
    pub subjects: &'a [Subject],
    /// Values of `max_depth`.
    pub depths: &'a [u32],
    /// Who traces.
    pub tracers: &'a [Tracer],
    /// On how many threads.
    pub threads: &'a Threads,
    /// How often.
    pub repeat: Repeat,
    /// The engine's instruction set.
    pub isa: Isa,
}

/// Two pictures that should have the same bits do not.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "{scene} to depth {depth}: the {engine} engine's picture is not the recursion's on {threads} threads; nothing was timed"
)]
pub struct Mismatch {
    /// The scene's name.
    pub scene: String,
    /// Its `max_depth`.
    pub depth: u32,
    /// Who made the picture.
    pub engine: &'static str,
    /// On how many threads.
    pub threads: usize,
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "engine", heading: "engine", meaning: "Who traced: recursive or packet." },
    Column { key: "depth", heading: "depth", meaning: "max_depth: reflections followed." },
    Column { key: "threads", heading: "threads", meaning: "Threads that traced." },
    Column { key: "min_ms", heading: "min ms", meaning: "Least time of tracing alone, ms." },
    Column { key: "median_ms", heading: "median ms", meaning: "Median time of tracing alone, ms." },
    Column { key: "rays", heading: "rays", meaning: "Logical rays: eye, mirrored and shadow." },
    Column { key: "ns_per_ray", heading: "ns a ray", meaning: "min_ms over rays, in ns." },
    Column {
        key: "speedup",
        heading: "speed-up",
        meaning: "The recursion's min_ms on one thread, to the same depth, over this one.",
    },
    Column {
        key: "efficiency",
        heading: "efficiency",
        meaning: "Parallel: the same engine's min_ms on one thread over threads times this one.",
    },
    Column { key: "runs", heading: "runs", meaning: "How often it was timed, in turn with all." },
    Column { key: "note", heading: "note", meaning: "Why there is no time." },
];

/// Measures all of it.
///
/// # Errors
/// A picture differs from the recursion's.
pub fn run(request: &Request, watch: &dyn Watch) -> Result<Report, Mismatch> {
    let mut report = Report::new("depth", "Cost against depth");
    let mut table = Table::new(
        "depth",
        COLUMNS,
        "Time of tracing alone by scene, engine, depth and threads, all of a scene run in turn.",
    );
    let mut parts = Vec::new();
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
    let mut levels = levels::table();
    for (subject, rows) in &parts {
        report.heading(&subject.name);
        report.text(words(rows));
        plots::add(&mut report, &subject.name, rows);
        if !watch.stopped() {
            levels::add(&mut report, &mut levels, subject, rows, request);
        }
    }
    report.heading("What happens at each depth");
    report.table(levels);
    if let Some((subject, _)) = parts.first()
        && !watch.stopped()
    {
        waterfall::add(&mut report, subject, request, watch)?;
    }
    report.complete = !watch.stopped();
    Ok(report)
}

/// One engine on one scene to one depth.
struct Row {
    scene: String,
    tracer: Tracer,
    depth: u32,
    threads: usize,
    counts: Option<Counts>,
    times: Times,
}

fn measure(subject: &Subject, request: &Request, watch: &dyn Watch) -> Result<Vec<Row>, Mismatch> {
    let scenes: Vec<_> =
        request.depths.iter().map(|&depth| (depth, subject.to_depth(depth))).collect();
    let compiled: Vec<_> = scenes.iter().map(|(_, scene)| Compiled::new(scene)).collect();
    let view = View::whole(&subject.scene);
    let grid = Grid::new(&view);
    let mut film = Film::new(grid.width, grid.height);

    let mut rows = Vec::new();
    let mut compiled_of = Vec::new();
    for ((depth, _), compiled) in scenes.iter().zip(&compiled) {
        if watch.stopped() {
            break;
        }
        let expected = expected(compiled, &grid, request);
        for &tracer in request.tracers {
            for threads in request.threads.counts() {
                let (counts, _) =
                    request.threads.time(threads, || tracer.render(compiled, &grid, &mut film));
                let same = |expected: &Film| differing_pixels(expected, &film) == 0;
                if counts.is_ok() && !expected.as_ref().is_none_or(same) {
                    let (scene, depth) = (subject.name.clone(), *depth);
                    return Err(Mismatch { scene, depth, engine: tracer.name(), threads });
                }
                rows.push(Row {
                    scene: subject.name.clone(),
                    tracer,
                    depth: *depth,
                    threads,
                    counts: counts.ok(),
                    times: Times::default(),
                });
                compiled_of.push(compiled);
            }
        }
    }
    let times = in_turn(rows.len(), request.repeat, watch, |i| {
        let (row, compiled) = (&rows[i], compiled_of[i]);
        row.counts.as_ref()?;
        let render = || row.tracer.render(compiled, &grid, &mut film);
        let (_, time) = request.threads.time(row.threads, render);
        Some(time)
    });
    for (row, times) in rows.iter_mut().zip(times) {
        row.times = times;
    }
    Ok(rows)
}

/// The recursion's picture; past the depth of its stack the portable engine's, which needs
/// none; `None` past that one's too.
fn expected(compiled: &Compiled, grid: &Grid, request: &Request) -> Option<Film> {
    let mut film = Film::new(grid.width, grid.height);
    let render = |tracer: Tracer| tracer.render(compiled, grid, &mut film);
    let tracers = [Tracer::Recursive, Tracer::Packet(Isa::Portable)];
    let rendered =
        request.threads.most().install(|| tracers.into_iter().map(render).any(|r| r.is_ok()));
    rendered.then_some(film)
}

impl Row {
    fn rays(&self) -> Option<u64> {
        self.counts.as_ref().map(Counts::total)
    }

    fn ns_per_ray(&self) -> Option<f64> {
        Some(self.times.min_ms()? * 1e6 / self.rays()? as f64)
    }

    /// The least time of another engine or number of threads over this one's.
    fn faster_than(&self, rows: &[Self], tracer: Tracer, threads: usize) -> Option<f64> {
        let other =
            rows.iter().find(|r| (r.tracer, r.threads, r.depth) == (tracer, threads, self.depth));
        Some(other?.times.min_ms()? / self.times.min_ms()?)
    }

    fn push(&self, table: &mut Table, rows: &[Self]) {
        let efficiency = self.faster_than(rows, self.tracer, 1).map(|f| f / self.threads as f64);
        let note = match (&self.counts, self.times.runs()) {
            (None, _) => "a path is deeper than the stack".into(),
            (Some(_), 0) => "interrupted".into(),
            _ => Cell::Nothing,
        };
        table.push([
            self.scene.as_str().into(),
            self.tracer.name().into(),
            self.depth.into(),
            self.threads.into(),
            self.times.min_ms().into(),
            self.times.median_ms().into(),
            self.rays().into(),
            self.ns_per_ray().into(),
            self.faster_than(rows, Tracer::Recursive, 1).into(),
            efficiency.into(),
            self.times.runs().into(),
            note,
        ]);
    }
}

/// What the rows of a scene show.
fn words(rows: &[Row]) -> String {
    let deepest = rows.iter().max_by_key(|row| (row.depth, row.tracer, row.threads));
    let best = deepest.and_then(|row| Some((row, row.faster_than(rows, Tracer::Recursive, 1)?)));
    let Some((row, factor)) = best else {
        return "Not every engine was timed.".to_owned();
    };
    let last = row.counts.as_ref().map_or(0, |counts| counts.depths.len().saturating_sub(1));
    let (depth, threads) = (row.depth, row.threads);
    format!(
        "Allowed {depth} reflections, the deepest ray has {last}. There the packet engine on \
         {threads} threads is {factor:.1} times as fast as the recursion on one."
    )
}
