//! Rendering a view: bands of tiles on rayon's threads.

use std::sync::atomic::{AtomicBool, Ordering};

use catoptric_scene::{Compiled, Counts, Film, Grid, Quantiser};
use rayon::prelude::*;

use crate::Isa;
use crate::lanes;
use crate::packet::{Candidates, TooDeep};
use crate::sight::Sights;
use crate::stack::{Budget, Stack};
use crate::tile::{self, Tile};

/// How to render; none of it changes a bit of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Lowered to what the processor has.
    pub isa: Isa,
    /// Bytes that the stacks of all threads together may take.
    pub stack_limit: usize,
}

/// The stacks of deep paths would pass the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("paths are so deep that their stacks need more than {limit} bytes")]
pub struct StackFull {
    /// The limit, in bytes.
    pub limit: usize,
}

/// Renders a view into a film of its size, on rayon's current threads.
///
/// `progress` is told after every few rows how many pixels were added. Memory: the film, and
/// a stack a thread of 152 bytes a level of the deepest path so far, rounded up to a power of
/// two levels.
///
/// # Errors
/// [`StackFull`] if paths go too deep for the limit; the film is then void.
///
/// # Panics
/// If the film's size is not the grid's.
pub fn render(
    scene: &Compiled,
    grid: &Grid,
    film: &mut Film,
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    assert_eq!((film.width(), film.height()), (grid.width, grid.height), "the film's size");
    bands(scene, grid, film.pixels_mut(), settings, progress, |band, pixels| band.render(pixels))
}

/// Renders a view straight to 8-bit levels: those that `quantiser` gives for the film, which
/// is never made.
///
/// Shape: `levels` holds the grid's pixels row by row from the top left. Otherwise as
/// [`render`], with 96 bytes of memory a column and thread in place of the film.
///
/// # Errors
/// As [`render`]; the levels are then void.
///
/// # Panics
/// If there is not one place for each pixel.
pub fn render_levels(
    scene: &Compiled,
    grid: &Grid,
    quantiser: &Quantiser,
    levels: &mut [[u8; 3]],
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    assert_eq!(levels.len(), grid.width as usize * grid.height as usize, "a place for each pixel");
    bands(scene, grid, levels, settings, progress, |band, levels| {
        // Stays in the cache, where a film would not.
        let mut linear = std::mem::take(&mut band.linear);
        linear.resize(levels.len(), [0.0; 3]);
        let rendered = band.render(&mut linear);
        quantiser.levels(&linear, levels);
        band.linear = linear;
        rendered
    })
}

/// Hands out bands of rows to rayon's threads; `render` fills the pixels of one.
fn bands<P: Send>(
    scene: &Compiled,
    grid: &Grid,
    pixels: &mut [P],
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
    render: impl Fn(&mut Band, &mut [P]) -> Result<(), TooDeep> + Sync,
) -> Result<Counts, StackFull> {
    let budget = Budget::new(settings.stack_limit);
    let sights = Sights::new(scene);
    let full = AtomicBool::new(false);
    let band = || Band {
        scene,
        grid,
        isa: settings.isa,
        sights: &sights,
        rows: &[],
        stack: Stack::new(&budget),
        eye: Vec::new(),
        linear: Vec::new(),
    };
    let counts = pixels
        .par_chunks_mut(grid.width as usize * tile::HEIGHT)
        .zip(grid.rows.par_chunks(grid.samples as usize * tile::HEIGHT))
        .map_init(band, |band, (pixels, rows)| {
            if full.load(Ordering::Relaxed) {
                return Counts::default();
            }
            band.rows = rows;
            if render(band, pixels).is_err() {
                full.store(true, Ordering::Relaxed);
            }
            progress(pixels.len() as u64);
            band.stack.take_counts()
        })
        .reduce(Counts::default, |mut sum, band| {
            sum.add(&band);
            sum
        });
    if full.into_inner() { Err(StackFull { limit: settings.stack_limit }) } else { Ok(counts) }
}

/// Tiles side by side, what one thread takes at a time; and what it keeps from band to band.
struct Band<'a> {
    scene: &'a Compiled,
    grid: &'a Grid,
    isa: Isa,
    sights: &'a Sights,
    /// Vertical positions of the band's sub-rows.
    rows: &'a [f32],
    stack: Stack<'a>,
    /// Room for the candidates of a tile.
    eye: Vec<u32>,
    /// Room for a band in linear light.
    linear: Vec<[f32; 3]>,
}

impl Band<'_> {
    /// Fills the pixels of whole rows.
    fn render(&mut self, pixels: &mut [[f32; 3]]) -> Result<(), TooDeep> {
        let (grid, samples) = (self.grid, self.grid.samples as usize);
        for (tile, columns) in grid.columns.chunks(tile::WIDTH * samples).enumerate() {
            self.sights.candidates(&self.scene.eye, columns, self.rows, &mut self.eye);
            let tile = Tile {
                scene: self.scene,
                candidates: Candidates { eye: &self.eye, mirrors: self.sights.all() },
                samples,
                columns,
                rows: self.rows,
                pixels,
                width: grid.width as usize,
                left: tile * tile::WIDTH,
                stack: &mut self.stack,
            };
            lanes::run(self.isa, tile)?;
        }
        Ok(())
    }
}
