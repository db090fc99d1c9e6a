//! What `--stats` writes: one JSON object.

use std::time::Duration;

use catoptric_core::Plan;
use catoptric_scene::Counts;
use serde::Serialize;

/// The object. Every key is always there.
#[derive(Debug, Serialize)]
pub(super) struct Stats<'a> {
    /// `catoptric-stats`.
    pub(super) schema: &'static str,
    /// Grows when a key changes its meaning or goes.
    pub(super) version: u32,
    /// The scene as the command line named it; `-` for stdin.
    pub(super) scene: &'a str,
    /// `packet` or `recursive`.
    pub(super) engine: &'static str,
    /// `robust` or `textbook`; truth is robust whatever the scene says.
    pub(super) numerics: &'static str,
    /// `f32`, `f64` or `dd`.
    pub(super) precision: &'static str,
    /// Columns that were rendered: the crop's, if there is one.
    pub(super) width: u32,
    /// Rows that were rendered.
    pub(super) height: u32,
    /// Reflections that would have been followed.
    pub(super) max_depth: u32,
    /// Threads that traced.
    pub(super) threads: usize,
    /// `portable` or `avx2`; null for the recursive engine, which has one path for all.
    pub(super) isa: Option<&'static str>,
    pub(super) time_ms: Times,
    pub(super) rays: Rays,
    /// Counts by depth, 0 first, as deep as rays went.
    pub(super) depths: Vec<Depth>,
    /// What the packet engine made of the scene; null for the recursive one. `catoptric explain`
    /// says it in words.
    pub(super) plan: Option<Planned>,
}

/// The packet engine's plan.
#[derive(Debug, Serialize)]
pub(super) struct Planned {
    /// Reflections that can occur, at most `max_depth`.
    pub(super) depth: u32,
    /// Work that is left out because no bit depends on it.
    pub(super) omitted: Vec<&'static str>,
    /// Whether there is a linear film: PNG and PPM need none.
    pub(super) film: bool,
    pub(super) features: Used,
}

/// What the scene and the request use.
#[derive(Debug, Serialize)]
pub(super) struct Used {
    balls: usize,
    large_spheres: usize,
    planes: usize,
    around: usize,
    nested: usize,
    mirrors: usize,
    lamps: usize,
    hidden_lamps: usize,
    coloured_lamps: bool,
    highlight: bool,
    fractional_shininess: bool,
    weight_cut: bool,
    samples: u32,
}

impl Planned {
    pub(super) fn of(plan: &Plan, film: bool) -> Self {
        let omitted = plan.omissions().iter().map(|omission| omission.name()).collect();
        let features = plan.features();
        let features = Used {
            balls: features.spheres,
            large_spheres: features.large_spheres,
            planes: features.planes,
            around: features.around,
            nested: features.nested,
            mirrors: features.mirrors,
            lamps: features.lights,
            hidden_lamps: features.hidden_lights,
            coloured_lamps: features.coloured_lights,
            highlight: features.highlight,
            fractional_shininess: features.fractional_shininess,
            weight_cut: features.cut,
            samples: features.samples,
        };
        Self { depth: plan.depth(), omitted, film, features }
    }
}

/// Wall-clock milliseconds.
#[derive(Debug, Serialize)]
pub(super) struct Times {
    /// Reading, parsing and validating the scene.
    pub(super) load: f64,
    /// Scene to constants.
    pub(super) compile: f64,
    /// All rays.
    pub(super) trace: f64,
    /// 8-bit levels, compression and writing, but not the rename.
    pub(super) encode: f64,
    /// Time from the start of the program to the end of `encode`.
    pub(super) total: f64,
}

/// Logical rays: what the picture needs, whether or not the engine had to trace it.
#[derive(Debug, Serialize)]
pub(super) struct Rays {
    pub(super) primary: u64,
    pub(super) reflection: u64,
    pub(super) shadow: u64,
}

/// What happened after that many reflections.
#[derive(Debug, Serialize)]
pub(super) struct Depth {
    pub(super) depth: usize,
    pub(super) rays: u64,
    pub(super) hits: u64,
}

impl Rays {
    pub(super) fn of(counts: &Counts) -> Self {
        Self { primary: counts.primary(), reflection: counts.reflection(), shadow: counts.shadow() }
    }

    /// The number of rays of all kinds.
    pub(super) fn total(&self) -> u64 {
        self.primary + self.reflection + self.shadow
    }
}

/// One entry for each depth.
pub(super) fn depths(counts: &Counts) -> Vec<Depth> {
    let entries = counts.depths.iter().enumerate();
    entries.map(|(depth, count)| Depth { depth, rays: count.rays, hits: count.hits }).collect()
}

/// Milliseconds, to the microsecond.
pub(super) fn ms(time: Duration) -> f64 {
    (time.as_secs_f64() * 1e6).round() / 1e3
}
