//! Error against run time: what a depth, a weight cut, samples, formulas and precision cost,
//! and what they bring.
//!
//! The practice is that of work-precision diagrams (Hairer and Wanner, Solving Ordinary
//! Differential Equations II, 1996): truth first, then one knob at a time, error over time on
//! logarithmic axes; what fails or is beaten is listed and not dropped.

mod enough;
mod front;
mod plots;
mod sample;
mod sweep;
mod truth;

use crate::Watch;
use crate::report::{Column, Report, Table};
use crate::subject::Subject;
use crate::timing::Repeat;
use crate::tracer::{Threads, Tracer};
pub use enough::{Enough, enough};
use sweep::{Row, Sweep};

/// What is measured.
pub struct Request<'a> {
    /// Scenes, in order.
    pub subjects: &'a [Subject],
    /// Who traces.
    pub tracer: Tracer,
    /// Pools; the largest one makes truth.
    pub threads: &'a Threads,
    /// On how many threads each setting is timed; one of the pools has that many.
    pub timed_on: usize,
    /// How often each setting is timed.
    pub repeat: Repeat,
    /// An RMSE for which the cheapest setting is named.
    pub target: Option<f64>,
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "sweep", heading: "knob", meaning: "What is varied: depth, weight or samples." },
    Column { key: "setting", heading: "setting", meaning: "max_depth, min_weight, or N of N x N." },
    Column { key: "formula", heading: "formula", meaning: "Formulas and precision." },
    Column { key: "min_ms", heading: "min ms", meaning: "Least time of tracing alone, ms." },
    Column { key: "median_ms", heading: "median ms", meaning: "Median time of tracing alone, ms." },
    Column { key: "rmse", heading: "RMSE", meaning: "Over all channels, linear, against truth." },
    Column { key: "max", heading: "max", meaning: "Largest error of a channel, linear." },
    Column { key: "p999", heading: "99.9 %", meaning: "99.9th percentile of a pixel's error." },
    Column { key: "off", heading: "levels off", meaning: "Pixels whose 8-bit levels differ." },
    Column {
        key: "off_by_more",
        heading: "off > 1",
        meaning: "Pixels with levels that differ by more than one.",
    },
    Column {
        key: "truncation",
        heading: "truncation",
        meaning: "Largest error that the setting makes in exact arithmetic.",
    },
    Column {
        key: "flipped",
        heading: "flipped",
        meaning: "Pixels whose path is not truth's: another primitive, or another lamp in view.",
    },
    Column {
        key: "rounding",
        heading: "rounding",
        meaning: "Largest error against truth at the same setting, without flipped pixels.",
    },
    Column {
        key: "max_unflipped",
        heading: "max, unflipped",
        meaning: "Largest error against truth, without flipped pixels: to be within the bound.",
    },
    Column {
        key: "bound",
        heading: "bound",
        meaning: "A-priori bound of the truncation, plus the rounding at full depth.",
    },
    Column { key: "front", heading: "front", meaning: "Whether nothing cheaper has less RMSE." },
    Column { key: "runs", heading: "runs", meaning: "How often it was timed, in turn with all." },
];

/// Measures all of it.
pub fn run(request: &Request, watch: &dyn Watch) -> Report {
    let mut report = Report::new("error", "Error against run time");
    let mut table = Table::new(
        "error",
        COLUMNS,
        "Error against truth and time of tracing, one knob at a time. Truth is in double-double \
         at a depth past which nothing changes; of samples, in f64 with 16 x 16 of them.",
    );
    let mut floors = truth::floors();
    let mut parts = Vec::new();
    for subject in request.subjects {
        if watch.stopped() {
            break;
        }
        let measured = sweep::measure(subject, request, watch);
        for (index, row) in measured.rows.iter().enumerate() {
            push(&mut table, &subject.name, row, front::is_on(&measured.rows, index));
        }
        truth::push(&mut floors, &subject.name, &measured);
        parts.push((subject, measured));
    }
    report.table(table);
    for (subject, measured) in &parts {
        report.heading(&subject.name);
        report.text(&measured.about);
        for line in front::words(&measured.rows, request.target) {
            report.text(line);
        }
        plots::add(&mut report, &subject.name, &measured.rows);
    }
    report.heading("Floors");
    report.table(floors);
    report.complete = !watch.stopped();
    report
}

fn push(table: &mut Table, scene: &str, row: &Row, on_front: bool) {
    let metrics = &row.error;
    let setting = match row.sweep {
        Sweep::Weight => row.setting.into(),
        Sweep::Depth | Sweep::Samples => (row.setting as u64).into(),
    };
    table.push([
        scene.into(),
        row.sweep.name().into(),
        setting,
        row.formula.name().into(),
        row.times.min_ms().into(),
        row.times.median_ms().into(),
        metrics.rmse.into(),
        metrics.max.into(),
        metrics.p999.into(),
        metrics.off.into(),
        metrics.off_by_more.into(),
        row.parts.map(|parts| parts.truncation.max).into(),
        row.parts.map(|parts| parts.flipped).into(),
        row.parts.map(|parts| parts.rounding.max).into(),
        row.parts.map(|parts| parts.error.max).into(),
        row.parts.map(|parts| parts.bound).into(),
        if on_front { "yes" } else { "no" }.into(),
        row.times.runs().into(),
    ]);
}
