//! What the ladder's study says: a row a rung, and a sentence or two a scene.

use catoptric_ladder::FORWARD;
use catoptric_report::{Cell, Column, Table};

use super::climbed::{Climbed, Row};

pub(super) const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "rung", heading: "rung", meaning: "Its name; forward is the aside." },
    Column { key: "title", heading: "what it is", meaning: "In a few words." },
    Column {
        key: "bit_identical",
        heading: "same bits",
        meaning: "Whether its picture is the recursion's, compared as bits; where a path is too \
                  deep for the recursion, r3's, which is then compared with nothing.",
    },
    Column {
        key: "different",
        heading: "different",
        meaning: "Share of pixels that differ from that picture's in some bit.",
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
        meaning: "Bytes of native stack from the call that traces the picture's deepest path \
                  down to the lowest event.",
    },
    Column {
        key: "level_bytes",
        heading: "a mirror",
        meaning: "Bytes a ray and mirror that it keeps outside the native stack.",
    },
    Column {
        key: "own_stack_bytes",
        heading: "own stack",
        meaning: "Those bytes for one ray on the deepest path: level_bytes times its mirrors.",
    },
    Column {
        key: "peak_stack_bytes",
        heading: "peak stack",
        meaning: "Native and own stack together.",
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

impl Climbed {
    /// Adds a row a rung.
    pub(super) fn push(&self, table: &mut Table, scene: &str) {
        for (i, row) in self.rows.iter().enumerate() {
            let rung = row.rung;
            // The aside stands on no rung.
            let below = i.checked_sub(1).filter(|_| rung.name != FORWARD.name);
            let over_previous = below.and_then(|i| self.over(self.rows[i].rung.name, row));
            let own_stack = row.native_stack.map(|_| rung.level_bytes * self.deepest);
            let peak_stack = row.native_stack.zip(own_stack).map(|(native, own)| native + own);
            let ns = || Some(row.times.min_ms()? * 1e6 / row.rays? as f64);
            table.push([
                scene.into(),
                rung.name.into(),
                rung.title.into(),
                row.different.map(|share| share == 0.0).into(),
                row.different.into(),
                row.times.min_ms().into(),
                row.times.median_ms().into(),
                ns().into(),
                over_previous.into(),
                self.over("r0", row).into(),
                row.native_stack.into(),
                rung.level_bytes.into(),
                own_stack.into(),
                peak_stack.into(),
                rung.lines_of_code().into(),
                row.times.runs().into(),
                self.note(row),
            ]);
        }
    }

    /// What a reader of the rows should know.
    pub(super) fn words(&self) -> String {
        let engine = self.rows.iter().find(|row| row.rung.name == "r5");
        let factor = engine.and_then(|engine| self.over("r0", engine));
        let speed = factor.map_or_else(String::new, |factor| {
            format!(" The engine is {factor:.1} times as fast as the recursion, on one thread.")
        });
        let wrong = self.rows.iter().any(Row::is_wrong);
        let bits = if wrong {
            "NOT every rung that promises the recursion's bits has them."
        } else if self.judge == Some("r0") {
            "Every rung that promises the recursion's bits has them."
        } else if self.judge != Some("r3") {
            "No rung but the engine holds it, so nothing is compared."
        } else {
            "The recursion's stack does not hold it, so the others are compared with r3, and every \
             one that promises the same bits has them."
        };
        format!("The deepest path has {} reflections. {bits}{speed}", self.deepest)
    }

    /// Why a row has no time, what it was compared with, or what is wrong.
    fn note(&self, row: &Row) -> Cell {
        match (row.rays, row.times.runs(), self.judge) {
            _ if row.is_wrong() => "FAILS".into(),
            (None, ..) => "a path is deeper than its stack".into(),
            (Some(_), 0, _) => "interrupted".into(),
            (.., Some(judge)) if judge != "r0" && judge != row.rung.name => {
                format!("compared with {judge}: the recursion's stack does not hold a path").into()
            }
            _ => Cell::Nothing,
        }
    }
}
