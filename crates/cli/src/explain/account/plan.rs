//! What the engine leaves out, and why no bit of the picture depends on it.

use catoptric_core::{Omission, Plan, tile_candidates};
use catoptric_scene::{Compiled, Grid};
use serde::Serialize;

/// The engine's plan for a scene.
#[derive(Debug, Serialize)]
pub(super) struct Told {
    /// Reflections that can occur, at most max_depth.
    pub(super) depth: u32,
    pub(super) omitted: Vec<Omitted>,
    /// Tiles of the picture.
    pub(super) tiles: usize,
    /// Tiles that can show nothing but the background.
    pub(super) empty_tiles: usize,
    /// Primitives that a tile's eye rays try, in the mean.
    pub(super) tried_a_tile: f64,
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
}

impl Told {
    pub(super) fn new(scene: &Compiled, grid: &Grid) -> Self {
        let plan = Plan::new(scene, grid);
        let candidates = tile_candidates(scene, grid);
        Self {
            depth: plan.depth,
            omitted: plan.omitted.iter().map(|omission| told(*omission)).collect(),
            tiles: candidates.tiles,
            empty_tiles: candidates.empty,
            tried_a_tile: candidates.tried as f64 / candidates.tiles as f64,
        }
    }
}

fn told(omission: Omission) -> Omitted {
    Omitted { name: omission.name(), what: omission.what(), why: omission.why() }
}
