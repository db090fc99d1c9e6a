//! Rendering a view: bands of tiles on rayon's threads.

use std::sync::atomic::{AtomicBool, Ordering};

use catoptric_scene::{Compiled, Counts, Film, Grid};
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
    let budget = Budget::new(settings.stack_limit);
    let sights = Sights::new(scene);
    let full = AtomicBool::new(false);
    let counts = film
        .pixels_mut()
        .par_chunks_mut(grid.width as usize * tile::HEIGHT)
        .zip(grid.rows.par_chunks(grid.samples as usize * tile::HEIGHT))
        .map_init(
            || (Stack::new(&budget), Vec::new()),
            |(stack, eye), (pixels, rows)| {
                if full.load(Ordering::Relaxed) {
                    return Counts::default();
                }
                let done = pixels.len() as u64;
                let mut band = Band { scene, sights: &sights, grid, rows, pixels, stack, eye };
                if band.render(settings.isa).is_err() {
                    full.store(true, Ordering::Relaxed);
                }
                progress(done);
                stack.take_counts()
            },
        )
        .reduce(Counts::default, |mut sum, band| {
            sum.add(&band);
            sum
        });
    if full.into_inner() { Err(StackFull { limit: settings.stack_limit }) } else { Ok(counts) }
}

/// Tiles side by side: what one thread takes at a time.
struct Band<'a, 'b> {
    scene: &'a Compiled,
    sights: &'a Sights,
    grid: &'a Grid,
    rows: &'a [f32],
    pixels: &'a mut [[f32; 3]],
    stack: &'a mut Stack<'b>,
    /// Room for the candidates of a tile.
    eye: &'a mut Vec<u32>,
}

impl Band<'_, '_> {
    fn render(&mut self, isa: Isa) -> Result<(), TooDeep> {
        let (grid, samples) = (self.grid, self.grid.samples as usize);
        for (tile, columns) in grid.columns.chunks(tile::WIDTH * samples).enumerate() {
            self.sights.candidates(&self.scene.eye, columns, self.rows, self.eye);
            let tile = Tile {
                scene: self.scene,
                candidates: Candidates { eye: self.eye, mirrors: self.sights.all() },
                samples,
                columns,
                rows: self.rows,
                pixels: self.pixels,
                width: grid.width as usize,
                left: tile * tile::WIDTH,
                stack: self.stack,
            };
            lanes::run(isa, tile)?;
        }
        Ok(())
    }
}
