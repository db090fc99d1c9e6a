//! What of a tile's eye rays depends on the column alone.

use crate::ray::TILE_WIDTH;
use crate::simd::{LANES, Lane};

/// Packets side by side in a row of a tile.
pub(crate) const COLUMN_PACKETS: usize = TILE_WIDTH / LANES;

/// What the eye rays of eight columns have in common; of one sample a pixel.
#[derive(Clone, Copy)]
pub(crate) struct Across<S> {
    /// Horizontal components, before the rays are made unit vectors, and their squares.
    pub(crate) x: [S; LANES],
    pub(crate) square: [S; LANES],
    /// How many of the columns are in the picture, the first ones; the others repeat the last.
    pub(crate) live: usize,
}

impl<S: Lane> Across<S> {
    pub(crate) const EMPTY: Self = Self { x: [S::ZERO; LANES], square: [S::ZERO; LANES], live: 0 };
}
