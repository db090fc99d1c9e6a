//! A picture and its rays are compared before its making is timed.
//!
//! What is expected is the recursion's, and where a path is too deep for its stack, that of the
//! ladder's loop, which takes the recursion's steps one ray at a time and needs no native stack.

use catoptric_core::Isa;
use catoptric_ladder::{RUNGS, Rung};
use catoptric_scene::{Compiled, Counts, Film, Grid};

use crate::Watch;
use crate::metrics::differing_pixels;
use crate::timing::{Repeat, Times, in_turn};
use crate::tracer::{Threads, Tracer};
use crate::way::Way;

/// Ways to trace one scene, each on a number of threads.
pub struct Group<'a> {
    /// The scene.
    pub scene: &'a Compiled,
    /// Way and threads.
    pub ways: &'a [(Way, usize)],
}

/// One way on one scene.
pub struct Checked {
    /// What the comparison said.
    pub outcome: Outcome,
    /// None but of a picture that is as expected.
    pub times: Times,
}

/// What came of a comparison.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Outcome {
    /// Every bit and every ray count is as expected.
    Same {
        /// The rays.
        counts: Counts,
        /// Whether they are the recursion's; if not, its stack is too small, and they are the
        /// loop's.
        by_recursion: bool,
    },
    /// A path is deeper than the way's stack.
    TooDeep,
    /// A path is deeper than the recursion and the loop go, so there is nothing to compare with.
    Alone,
}

/// Two that should be the same are not.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Difference {
    /// How many pixels differ in some bit.
    #[error("{0} pixels of its picture are not the recursion's")]
    Pixels(usize),
    /// Some ray count differs.
    #[error("its ray counts are not the recursion's")]
    Rays,
}

impl Outcome {
    /// The rays, where they are as expected.
    #[must_use]
    pub fn counts(&self) -> Option<&Counts> {
        match self {
            Self::Same { counts, .. } => Some(counts),
            Self::TooDeep | Self::Alone => None,
        }
    }
}

/// Renders everything once and compares it; then times what could be compared, all of it in
/// turn. In the order of the groups; fewer where `watch` stops it meanwhile.
///
/// # Errors
/// The first difference, with the indices of its group and its way. Nothing is timed then.
///
/// # Panics
/// If there is no pool of a way's number of threads.
pub fn check_then_time(
    groups: &[Group],
    grid: &Grid,
    threads: &Threads,
    repeat: Repeat,
    watch: &dyn Watch,
) -> Result<Vec<Checked>, (usize, usize, Difference)> {
    let mut film = Film::new(grid.width, grid.height);
    let mut checked = Vec::new();
    let mut jobs = Vec::new();
    // Check every picture before any is timed.
    'groups: for (g, group) in groups.iter().enumerate() {
        if watch.stopped() {
            break;
        }
        let expected = Expected::of(group.scene, grid, threads);
        for (w, &(way, count)) in group.ways.iter().enumerate() {
            if watch.stopped() {
                break 'groups;
            }
            let render = || way.render(group.scene, grid, &mut film);
            let outcome = match (threads.time(count, render).0, &expected) {
                (Err(_), _) => Outcome::TooDeep,
                (Ok(_), None) => Outcome::Alone,
                (Ok(counts), Some(expected)) => {
                    expected.compare(&film, &counts).map_err(|difference| (g, w, difference))?;
                    Outcome::Same { counts, by_recursion: expected.by_recursion }
                }
            };
            checked.push(Checked { outcome, times: Times::default() });
            jobs.push((group.scene, way, count));
        }
    }
    // Time what was traced, all jobs in turn, so that a slow minute of the machine meets all alike.
    let times = in_turn(jobs.len(), repeat, watch, |i| {
        checked[i].outcome.counts()?;
        let (scene, way, count) = jobs[i];
        Some(threads.time(count, || way.render(scene, grid, &mut film)).1)
    });
    for (checked, times) in checked.iter_mut().zip(times) {
        checked.times = times;
    }
    Ok(checked)
}

/// What a picture and its rays must be.
struct Expected {
    film: Film,
    counts: Counts,
    by_recursion: bool,
}

impl Expected {
    /// `None` where a path is deeper than the recursion and the loop go.
    fn of(scene: &Compiled, grid: &Grid, threads: &Threads) -> Option<Self> {
        let mut film = Film::new(grid.width, grid.height);
        let by = [Way::Tracer(Tracer::Recursive), Way::Rung(rung("r3"), Isa::Portable)];
        let mut render = |way: Way| way.render(scene, grid, &mut film).ok();
        let (index, counts) = threads.most().install(|| {
            by.into_iter().enumerate().find_map(|(index, way)| Some((index, render(way)?)))
        })?;
        Some(Self { film, counts, by_recursion: index == 0 })
    }

    fn compare(&self, film: &Film, counts: &Counts) -> Result<(), Difference> {
        match differing_pixels(&self.film, film) {
            0 if self.counts == *counts => Ok(()),
            0 => Err(Difference::Rays),
            pixels => Err(Difference::Pixels(pixels)),
        }
    }
}

/// The ladder's rung of that name.
///
/// # Panics
/// If there is none.
#[must_use]
pub(crate) fn rung(name: &str) -> &'static Rung {
    RUNGS.iter().find(|rung| rung.name == name).expect("a rung of that name")
}
