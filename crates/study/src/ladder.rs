//! The ladder: what each step from the recursion to the engine costs and buys.
//!
//! Every rung's picture is compared with the recursion's, bit for bit, before it is timed. All
//! are timed on one thread.

use catoptric_core::Isa;
use catoptric_ladder::{FORWARD, NativeStack, RUNGS, Rung};
use catoptric_reference::path::{eye_ray, follow};
use catoptric_scene::{Compiled, Film, Grid, View};
use rayon::prelude::*;

use crate::Watch;
use crate::metrics::differing_pixels;
use crate::report::{Cell, Column, Report, Table};
use crate::subject::Subject;
use crate::timing::{Repeat, Times, in_turn};
use crate::tracer::{Threads, Tracer};
use crate::way::Way;

/// What is measured.
pub struct Request<'a> {
    /// Scenes, in order.
    pub subjects: &'a [Subject],
    /// A pool of one thread.
    pub threads: &'a Threads,
    /// How often.
    pub repeat: Repeat,
    /// The engine's instruction set.
    pub isa: Isa,
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "rung", heading: "rung", meaning: "Its name; forward is the aside." },
    Column { key: "title", heading: "what it is", meaning: "In a few words." },
    Column {
        key: "bit_identical",
        heading: "same bits",
        meaning: "Whether its picture is the recursion's, compared as bits.",
    },
    Column {
        key: "different",
        heading: "different",
        meaning: "Share of pixels that differ from the recursion's in some bit.",
    },
    Column { key: "min_ms", heading: "min ms", meaning: "Least time of tracing alone, ms." },
    Column { key: "median_ms", heading: "median ms", meaning: "Median time of tracing alone, ms." },
    Column {
        key: "ns_per_ray",
        heading: "ns a ray",
        meaning: "min_ms over rays of all kinds, in ns.",
    },
    Column {
        key: "over_previous",
        heading: "times faster",
        meaning: "Than the rung before it, by min_ms.",
    },
    Column {
        key: "over_r0",
        heading: "in all",
        meaning: "Times faster than the recursion, by min_ms.",
    },
    Column {
        key: "native_stack_bytes",
        heading: "native stack",
        meaning: "Bytes of native stack that the events of the picture's deepest path span, from \
                  the highest to the lowest.",
    },
    Column {
        key: "level_bytes",
        heading: "a level",
        meaning: "Bytes a ray and level that it keeps outside the native stack.",
    },
    Column {
        key: "lines",
        heading: "lines",
        meaning: "Lines of code in its file, without what rungs share; the engine's is the \
                  packet loop alone.",
    },
    Column { key: "runs", heading: "runs", meaning: "How often it was timed, in turn with all." },
    Column { key: "note", heading: "note", meaning: "Why there is no time, or what is wrong." },
];

/// Measures all of it. The report says that something failed where a rung that promises the
/// recursion's bits has others.
#[must_use]
pub fn run(request: &Request, watch: &dyn Watch) -> Report {
    let mut report = Report::new("ladder", "The ladder: from the recursion to the engine");
    let mut table =
        Table::new("ladder", COLUMNS, "Every rung on one thread, all of a scene run in turn.");
    let mut words = Vec::new();
    for subject in request.subjects {
        if watch.stopped() {
            break;
        }
        watch.say(&format!("{}: checking every rung's picture, then timing", subject.name));
        let climbed = Climbed::new(subject, request, watch);
        report.failed |= climbed.rows.iter().any(Row::is_wrong);
        climbed.push(&mut table, &subject.name);
        words.push((subject.name.as_str(), climbed.words()));
    }
    report.table(table);
    for (name, words) in words {
        report.heading(name);
        report.text(words);
    }
    report.complete = !watch.stopped();
    report
}

/// The rungs on one scene.
struct Climbed {
    /// From r0 up; the aside last.
    rows: Vec<Row>,
    /// Reflections of the deepest path.
    deepest: usize,
}

/// One rung on one scene.
struct Row {
    rung: &'static Rung,
    /// Of all kinds; `None` where a path is too deep for it.
    rays: Option<u64>,
    /// Share of pixels; `None` where there is nothing to compare with.
    different: Option<f64>,
    native_stack: Option<usize>,
    times: Times,
}

/// The instruction set is the study's and not the rung's own choice.
fn way(rung: &'static Rung, isa: Isa) -> Way {
    if rung.name == "r5" { Way::Tracer(Tracer::Packet(isa)) } else { Way::Rung(rung) }
}

impl Climbed {
    fn new(subject: &Subject, request: &Request, watch: &dyn Watch) -> Self {
        let compiled = Compiled::new(&subject.scene);
        let grid = Grid::new(&View::whole(&subject.scene));
        let mut film = Film::new(grid.width, grid.height);
        let pool = request.threads.most();
        let (deepest, at) = pool.install(|| deepest(&compiled, &grid));

        let mut expected: Option<Film> = None;
        let mut rows = Vec::new();
        for rung in RUNGS.iter().chain([&FORWARD]) {
            if watch.stopped() {
                break;
            }
            let way = way(rung, request.isa);
            let counts = pool.install(|| way.render(&compiled, &grid, &mut film)).ok();
            if counts.is_some() && expected.is_none() {
                expected = Some(film.clone());
            }
            let different = expected.as_ref().filter(|_| counts.is_some());
            let mut stack = NativeStack::default();
            let watched = pool.install(|| (rung.watch)(&compiled, &grid, at, &mut stack));
            rows.push(Row {
                rung,
                rays: counts.map(|counts| counts.total()),
                different: different.map(|expected| share_that_differs(expected, &film)),
                native_stack: watched.ok().map(|_| stack.bytes()),
                times: Times::default(),
            });
        }
        let times = in_turn(rows.len(), request.repeat, watch, |i| {
            rows[i].rays?;
            let way = way(rows[i].rung, request.isa);
            let render = || way.render(&compiled, &grid, &mut film);
            Some(request.threads.time(1, render).1)
        });
        for (row, times) in rows.iter_mut().zip(times) {
            row.times = times;
        }
        Self { rows, deepest }
    }

    /// How many times as fast as another rung.
    fn over(&self, other: &str, row: &Row) -> Option<f64> {
        let other = self.rows.iter().find(|row| row.rung.name == other)?;
        Some(other.times.min_ms()? / row.times.min_ms()?)
    }

    fn push(&self, table: &mut Table, scene: &str) {
        for (i, row) in self.rows.iter().enumerate() {
            let rung = row.rung;
            // The aside stands on no rung.
            let below = i.checked_sub(1).filter(|_| rung.name != FORWARD.name);
            let over_previous = below.and_then(|i| self.over(self.rows[i].rung.name, row));
            let ns = || Some(row.times.min_ms()? * 1e6 / row.rays? as f64);
            table.push([
                scene.into(),
                rung.name.into(),
                rung.title.into(),
                row.different.map(|share| if share == 0.0 { "yes" } else { "no" }).into(),
                row.different.into(),
                row.times.min_ms().into(),
                row.times.median_ms().into(),
                ns().into(),
                over_previous.into(),
                self.over("r0", row).into(),
                row.native_stack.into(),
                rung.level_bytes.into(),
                rung.lines_of_code().into(),
                row.times.runs().into(),
                row.note(),
            ]);
        }
    }

    fn words(&self) -> String {
        let engine = self.rows.iter().find(|row| row.rung.name == "r5");
        let factor = engine.and_then(|engine| self.over("r0", engine));
        let speed = factor.map_or_else(String::new, |factor| {
            format!(" The engine is {factor:.1} times as fast as the recursion, on one thread.")
        });
        let wrong = self.rows.iter().any(Row::is_wrong);
        let bits = if wrong {
            "NOT every rung that promises the recursion's bits has them."
        } else {
            "Every rung that promises the recursion's bits, and was rendered, has them."
        };
        format!("The deepest path has {} reflections. {bits}{speed}", self.deepest)
    }
}

impl Row {
    /// Whether it breaks its promise.
    fn is_wrong(&self) -> bool {
        self.rung.bit_identical && self.different.is_some_and(|share| share > 0.0)
    }

    fn note(&self) -> Cell {
        match (self.rays, self.times.runs()) {
            _ if self.is_wrong() => "FAILS".into(),
            (None, _) => "a path is deeper than its stack".into(),
            (Some(_), 0) => "interrupted".into(),
            _ => Cell::Nothing,
        }
    }
}

/// The share of pixels that differ in some bit.
fn share_that_differs(expected: &Film, found: &Film) -> f64 {
    differing_pixels(expected, found) as f64 / expected.pixels().len() as f64
}

/// Reflections of the deepest path, and the first column and row of an eye ray that has it.
fn deepest(scene: &Compiled, grid: &Grid) -> (usize, (usize, usize)) {
    let reflections = |column, row| {
        let steps = follow(scene, eye_ray(scene, column, row));
        steps.iter().filter(|step| step.followed).count()
    };
    let of_row = |(y, &row): (usize, &f32)| {
        let columns = grid.columns.iter().enumerate();
        let paths = columns.map(|(x, &column)| (reflections(column, row), (x, y)));
        paths.reduce(deeper).expect("a picture has columns")
    };
    let rows = grid.rows.par_iter().enumerate().map(of_row);
    rows.reduce_with(deeper).expect("a picture has rows")
}

/// The first of equals.
fn deeper<T>(a: (usize, T), b: (usize, T)) -> (usize, T) {
    if b.0 > a.0 { b } else { a }
}
