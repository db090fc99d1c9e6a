//! What the engine leaves out, why no bit of the picture depends on it, and what that saves.

use catoptric_core::{Isa, Omission, Plan, occluders, tile_candidates};
use catoptric_scene::{Compiled, Grid};
use catoptric_study::omissions::{Saving, savings};
use catoptric_study::tracer::TooDeep;
use serde::Serialize;

/// Primitives that are asked in pairs, at most.
const PAIRED: usize = 2048;

/// What is left out of every scene's rendering.
const ALWAYS: &[&str] = &[
    "backs of surfaces, and the surface just left (robust numerics)",
    "shadow rays to lamps that some primitive hides from all that can be seen",
    "surfaces that an earlier one is already (robust numerics)",
    "cumulative weights without min_weight",
    "the linear film of PNG and PPM: levels are made tile by tile",
];

/// The engine's plan for a scene.
#[derive(Debug, Serialize)]
pub(super) struct Told {
    /// Reflections that can occur, at most max_depth.
    pub(super) depth: u32,
    /// What sets it: `max_depth`, `mirrors` or `min_weight`.
    pub(super) depth_set_by: &'static str,
    pub(super) omitted: Vec<Omitted>,
    /// Left out of every rendering.
    pub(super) always: &'static [&'static str],
    /// Tiles of the picture.
    pub(super) tiles: usize,
    /// Tiles that can show nothing but the background.
    pub(super) empty_tiles: usize,
    /// Primitives that a tile's eye rays try, in the mean.
    pub(super) tried_a_tile: f64,
    /// Primitives that can stand between a light and some point of a primitive, in the mean over
    /// both; the engine tries those of a tile's points, which are fewer. Null without a light that
    /// lights something, with textbook numerics, and with more than 2048 primitives.
    pub(super) occluders: Option<f64>,
}

/// Work that is not done.
#[derive(Debug, Serialize)]
pub(super) struct Omitted {
    /// The engine's word for it.
    pub(super) name: &'static str,
    /// What is not done.
    pub(super) what: &'static str,
    /// Why that changes no bit.
    pub(super) why: &'static str,
    /// The share of the time of tracing that it saves, measured here and now: 1 - t/t', t' being
    /// the least time without it. Below 0 where it costs more than it saves.
    pub(super) saves: f64,
}

impl Told {
    /// Measures what a plan of the scene saves, on rayon's current threads.
    ///
    /// # Errors
    /// A path too deep for the engine's stack.
    pub(super) fn new(
        scene: &Compiled,
        grid: &Grid,
        plan: &Plan,
        isa: Isa,
    ) -> Result<Self, TooDeep> {
        let candidates = tile_candidates(scene, grid);
        let uncut = Compiled { min_weight: 0.0, ..scene.clone() };
        let depth_set_by = if plan.depth() < Plan::new(&uncut, grid).depth() {
            "min_weight"
        } else if plan.depth() < scene.max_depth {
            "mirrors"
        } else {
            "max_depth"
        };
        let told = |Saving { omission, share }: Saving| Omitted {
            name: omission.name(),
            what: omission.what(),
            why: omission.why(),
            saves: share,
        };
        let occluders = plan.omits(Omission::Occluders).then(|| mean_occluders(scene)).flatten();
        Ok(Self {
            depth: plan.depth(),
            depth_set_by,
            omitted: savings(scene, grid, isa)?.into_iter().map(told).collect(),
            always: ALWAYS,
            tiles: candidates.tiles,
            empty_tiles: candidates.empty,
            tried_a_tile: candidates.tried as f64 / candidates.tiles as f64,
            occluders,
        })
    }
}

fn mean_occluders(scene: &Compiled) -> Option<f64> {
    let receivers = scene.primitives.len();
    if receivers == 0 || receivers > PAIRED {
        return None;
    }
    let lamps = (0..scene.lights.len()).filter(|&lamp| !scene.lights[lamp].hidden);
    let pairs = lamps.flat_map(|lamp| (0..receivers).map(move |receiver| (lamp, receiver)));
    let counts = pairs.map(|(lamp, receiver)| occluders(scene, lamp, receiver).len());
    let (pairs, sum) = counts.fold((0, 0), |(pairs, sum), count| (pairs + 1, sum + count));
    (pairs > 0).then(|| sum as f64 / f64::from(pairs))
}
