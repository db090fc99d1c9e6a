//! One engine on one scene to one depth.

use catoptric_report::{Cell, Column, Table};
use catoptric_scene::Counts;

use crate::checked::Outcome;
use crate::timing::Times;
use crate::tracer::Tracer;
use crate::way::Way;

pub(super) const COLUMNS: &[Column] = &[
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
    Column {
        key: "note",
        heading: "note",
        meaning: "Why there is no time, or what it was compared with if not with the recursion.",
    },
];

pub(super) struct Row {
    pub(super) scene: String,
    pub(super) way: Way,
    pub(super) depth: u32,
    pub(super) threads: usize,
    pub(super) outcome: Outcome,
    pub(super) times: Times,
}

impl Row {
    pub(super) fn counts(&self) -> Option<&Counts> {
        self.outcome.counts()
    }

    pub(super) fn ns_per_ray(&self) -> Option<f64> {
        Some(self.times.min_ms()? * 1e6 / self.counts()?.total() as f64)
    }

    /// The least time of another engine or number of threads over this one's.
    pub(super) fn faster_than(&self, rows: &[Self], engine: &str, threads: usize) -> Option<f64> {
        let other = rows
            .iter()
            .find(|r| (r.way.name(), r.threads, r.depth) == (engine, threads, self.depth));
        Some(other?.times.min_ms()? / self.times.min_ms()?)
    }

    fn note(&self) -> Cell {
        match (&self.outcome, self.times.runs()) {
            (Outcome::TooDeep, _) => "a path is deeper than the stack".into(),
            (Outcome::Alone, _) => {
                "not timed: a path is deeper than all that it could be compared with".into()
            }
            (Outcome::Same { .. }, 0) => "interrupted".into(),
            (Outcome::Same { by_recursion: false, .. }, _) => {
                "compared with the ladder's loop: too deep for the recursion".into()
            }
            (Outcome::Same { .. }, _) => Cell::Nothing,
        }
    }

    pub(super) fn push(&self, table: &mut Table, rows: &[Self]) {
        let alone = self.faster_than(rows, self.way.name(), 1);
        table.push([
            self.scene.as_str().into(),
            self.way.name().into(),
            self.depth.into(),
            self.threads.into(),
            self.times.min_ms().into(),
            self.times.median_ms().into(),
            self.counts().map(Counts::total).into(),
            self.ns_per_ray().into(),
            self.faster_than(rows, Tracer::Recursive.name(), 1).into(),
            alone.map(|factor| factor / self.threads as f64).into(),
            self.times.runs().into(),
            self.note(),
        ]);
    }
}

/// What the rows of a scene show.
pub(super) fn words(rows: &[Row]) -> String {
    let checked = || rows.iter().filter(|row| row.counts().is_some());
    let Some(depth) = checked().map(|row| row.depth).max() else {
        return "No picture of any of these depths could be made and compared.".to_owned();
    };
    let deepest: Vec<&Row> = checked().filter(|row| row.depth == depth).collect();
    let rays = deepest[0].counts().map_or(0, |counts| counts.depths.len());
    let said =
        format!("Allowed {depth} reflections, the deepest ray has {}.", rays.saturating_sub(1));
    let recursion = Tracer::Recursive.name();
    if rows.iter().all(|row| row.way.name() != recursion) {
        return said + " The recursion was not asked for, so there is no speed-up over it.";
    }
    // The engine on the most threads, or the recursion where nothing else was asked for.
    let most = deepest.iter().max_by_key(|row| (row.way.name() != recursion, row.threads));
    let Some(row) = most.filter(|row| (row.way.name(), row.threads) != (recursion, 1)) else {
        return said + " Nothing but the recursion on one thread was asked for.";
    };
    let Some(factor) = row.faster_than(rows, recursion, 1) else {
        return said + " Not all of that depth was timed.";
    };
    let who = match row.way.name() {
        name if name == recursion => "the recursion".to_owned(),
        name => format!("the {name} engine"),
    };
    let threads = if row.threads == 1 { "1 thread" } else { &format!("{} threads", row.threads) };
    format!("{said} There {who} on {threads} is {factor:.1} times as fast as the recursion on one.")
}
