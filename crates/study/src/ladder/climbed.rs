//! Rungs on one scene, compared and then timed.

use catoptric_core::Settings;
use catoptric_ladder::{FORWARD, RUNGS, Rung, native_stack};
use catoptric_reference::path::{eye_ray, follow};
use catoptric_scene::{Compiled, Film, Grid, View};
use rayon::prelude::*;

use super::request::Request;
use crate::Watch;
use crate::metrics::differing_pixels;
use crate::subject::Subject;
use crate::timing::{Times, in_turn};
use crate::tracer::STACK_LIMIT;

/// The rungs on one scene.
pub(super) struct Climbed {
    /// Rows from r0 up; the aside last.
    pub(super) rows: Vec<Row>,
    /// The rung whose picture the others are compared with: the first that holds the paths.
    pub(super) judge: Option<&'static str>,
    /// Reflections of the deepest path.
    pub(super) deepest: usize,
}

/// One rung on one scene.
pub(super) struct Row {
    pub(super) rung: &'static Rung,
    /// Rays of all kinds; `None` where a path is too deep for it.
    pub(super) rays: Option<u64>,
    /// Share of pixels; `None` where there is nothing to compare with. The recursion is what it
    /// is; another judge does not judge itself.
    pub(super) different: Option<f64>,
    pub(super) native_stack: Option<usize>,
    pub(super) times: Times,
}

impl Climbed {
    pub(super) fn new(subject: &Subject, request: &Request, watch: &dyn Watch) -> Self {
        let compiled = Compiled::new(&subject.scene);
        let grid = Grid::new(&View::whole(&subject.scene));
        let mut film = Film::new(grid.width, grid.height);
        let pool = request.threads.most();
        let (deepest, at) = pool.install(|| deepest(&compiled, &grid));

        // Render every rung and compare with the first that holds the paths.
        let settings = Settings { isa: request.isa, stack_limit: STACK_LIMIT };
        let mut judge: Option<(&'static str, Film)> = None;
        let mut rows = Vec::new();
        for rung in RUNGS.iter().chain([&FORWARD]) {
            if watch.stopped() {
                break;
            }
            let counts = pool.install(|| (rung.render)(&compiled, &grid, &mut film, settings)).ok();
            let different = match &judge {
                _ if counts.is_none() => None,
                Some((_, expected)) => Some(share_that_differs(expected, &film)),
                None => {
                    judge = Some((rung.name, film.clone()));
                    (rung.name == "r0").then_some(0.0)
                }
            };
            // Measure the native stack at the pixel with the deepest path.
            let (watched, bytes) = pool.install(|| {
                native_stack(|watch| (rung.watch)(&compiled, &grid, at, settings, watch))
            });
            rows.push(Row {
                rung,
                rays: counts.map(|counts| counts.total()),
                different,
                native_stack: watched.ok().map(|_| bytes),
                times: Times::default(),
            });
        }
        // Time the rungs that rendered, all in turn.
        let times = in_turn(rows.len(), request.repeat, watch, |i| {
            rows[i].rays?;
            let render = || (rows[i].rung.render)(&compiled, &grid, &mut film, settings);
            Some(request.threads.time(1, render).1)
        });
        for (row, times) in rows.iter_mut().zip(times) {
            row.times = times;
        }
        Self { rows, judge: judge.map(|(name, _)| name), deepest }
    }

    /// How many times as fast as another rung.
    pub(super) fn over(&self, other: &str, row: &Row) -> Option<f64> {
        let other = self.rows.iter().find(|row| row.rung.name == other)?;
        Some(other.times.min_ms()? / row.times.min_ms()?)
    }
}

impl Row {
    /// Whether it breaks its promise.
    pub(super) fn is_wrong(&self) -> bool {
        self.rung.bit_identical && self.different.is_some_and(|share| share > 0.0)
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
