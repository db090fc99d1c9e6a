//! Pictures, whatever their format.

use catoptric_scene::{Film, Quantiser};
use rayon::prelude::*;

/// A picture, read or rendered.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Picture {
    /// What PNG and PPM hold.
    Levels(Levels),
    /// What PFM holds.
    Linear(Film),
}

/// An 8-bit picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Levels {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Row by row from the top left.
    pub(crate) pixels: Vec<[u8; 3]>,
}

impl Levels {
    /// A black picture. Its pages are taken as they are first written.
    pub(crate) fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![[0; 3]; width as usize * height as usize] }
    }
}

impl Picture {
    /// Converts to 8-bit levels; a film is converted on rayon's current threads.
    pub(super) fn into_levels(self, quantiser: &Quantiser) -> Levels {
        /// Pixels in a piece of work: enough to be worth handing over.
        const PIECE: usize = 1 << 14;
        match self {
            Self::Levels(levels) => levels,
            Self::Linear(film) => {
                let mut levels = Levels::new(film.width(), film.height());
                let pieces = levels.pixels.par_chunks_mut(PIECE);
                let linear = film.pixels().par_chunks(PIECE);
                pieces.zip(linear).for_each(|(to, linear)| quantiser.levels(linear, to));
                levels
            }
        }
    }
}
