//! What a scene's tiles and shadow rays have to test, for those who study it.

use catoptric_scene::{Compiled, Grid, Scalar};
use glam::DVec3;

use crate::cull::{Occluders, TileCuller};
use crate::plan::nested;
use crate::ray::{TILE_HEIGHT, TILE_WIDTH};
use crate::shape::facts;
use crate::simd::{Lane, in_f64};

/// How many of a view's tiles can show how many primitives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TileCandidates {
    /// Tiles of the picture.
    pub tiles: usize,
    /// Tiles that can show nothing but the background.
    pub empty: usize,
    /// Primitives tried, summed over all tiles.
    pub tried: usize,
}

/// What the eye rays of a view's tiles have to try.
#[must_use]
pub fn tile_candidates<S: Scalar>(scene: &Compiled<S>, grid: &Grid<S>) -> TileCandidates {
    let tiles = TileCuller::new(scene, nested::others(scene, &nested::nested(scene)));
    let (mut sum, mut list) = (TileCandidates::default(), Vec::new());
    let samples = grid.samples as usize;
    for rows in grid.rows.chunks(TILE_HEIGHT * samples) {
        for columns in grid.columns.chunks(TILE_WIDTH * samples) {
            tiles.candidates(&scene.eye, columns, rows, &mut list);
            sum.tiles += 1;
            sum.empty += usize::from(list.is_empty());
            sum.tried += list.len();
        }
    }
    sum
}

/// The primitives that can stand between a light and any point of a receiver, by index.
///
/// Conservative: one that is not here never does; one that is here may not either. A hidden
/// light has none.
///
/// # Panics
/// If there is no such light or receiver.
#[must_use]
pub fn occluders(scene: &Compiled, light: usize, receiver: usize) -> Vec<u32> {
    let light = &scene.lights[light];
    if light.hidden {
        return Vec::new();
    }
    let (center, radius) = match facts(&scene.primitives[receiver].shape).sphere() {
        // Its points are within rounding of it, a few u of |c| + r, u = 6e-8 at most.
        Some((center, radius)) => (center, radius + 1e-6 * (center.length() + radius)),
        None => (DVec3::ZERO, f64::INFINITY),
    };
    // Spheres inside others too: to find them takes longer than what is asked for here.
    let occluders = Occluders::new(scene, &nested::all(scene));
    let mut list = vec![0; occluders.len() + 1];
    let left = u32::try_from(receiver).expect("fewer than 2^32 primitives");
    let position = in_f64::<f32>(light.position);
    let len = occluders.find::<<f32 as Lane>::Portable>(position, center, radius, left, &mut list);
    let mut indices: Vec<_> = list[..len].iter().map(|&number| occluders.index(number)).collect();
    indices.sort_unstable();
    indices
}
