//! Bands of tiles on rayon's threads.

use catoptric_scene::{Counts, Grid};
use rayon::prelude::*;

use crate::omission::Omission;
use crate::plan::Plan;
use crate::ray::{TILE_HEIGHT, TILE_WIDTH};
use crate::settings::{Settings, StackFull};
use crate::simd::{self, Isa, Lane};
use crate::trace::{Budget, Frame, Output, Put, Scratch, Tile, TooDeep};

/// Hands out bands of rows to rayon's threads.
pub(crate) fn render_bands<S: Lane, O: Output<S>>(
    plan: &Plan<S>,
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
    output: &O,
    pixels: &mut [O::Pixel],
) -> Result<Counts, StackFull> {
    let grid = plan.grid();
    let budget = Budget::new(settings.stack_limit);
    let samples = grid.columns.len() * grid.rows.len();
    let frame =
        Frame::new(plan.scene(), plan.candidates(), samples, plan.depth(), plan.omissions());
    let band = || Band {
        frame: &frame,
        grid,
        isa: settings.isa,
        rows: &[],
        scratch: Scratch::new(&frame, &budget),
        candidates: Vec::new(),
    };
    let counts = pixels
        .par_chunks_mut(grid.width as usize * TILE_HEIGHT)
        .zip(grid.rows.par_chunks(grid.samples as usize * TILE_HEIGHT))
        .map_init(band, |band, (pixels, rows)| {
            band.rows = rows;
            if budget.is_refused() || band.render(output, pixels).is_err() {
                return Counts::default();
            }
            progress(pixels.len() as u64);
            band.scratch.stack.take_counts()
        })
        .reduce(Counts::default, |mut sum, band| {
            sum.add(&band);
            sum
        });
    if budget.is_refused() { Err(StackFull { limit: settings.stack_limit }) } else { Ok(counts) }
}

/// Tiles side by side, what one thread takes at a time; and what it keeps from band to band.
struct Band<'a, S: Lane> {
    frame: &'a Frame<'a, S>,
    grid: &'a Grid<S>,
    isa: Isa,
    /// Vertical positions of the band's sub-rows.
    rows: &'a [S],
    scratch: Scratch<'a, S>,
    /// Room for the candidates of a tile.
    candidates: Vec<u32>,
}

impl<S: Lane> Band<'_, S> {
    /// Fills the pixels of whole rows.
    fn render<O: Output<S>>(&mut self, output: &O, pixels: &mut [O::Pixel]) -> Result<(), TooDeep> {
        let width = self.grid.width as usize;
        for left in (0..width).step_by(TILE_WIDTH) {
            let right = width.min(left + TILE_WIDTH);
            if let Some(colour) = self.trace(left, right)? {
                // One row is filled, the others are copies of it: pixels of three numbers are slow
                // to write one by one.
                let (first, rest) = pixels.split_at_mut(width);
                let first = &mut first[left..right];
                first.fill(output.pixel(colour));
                for row in rest.chunks_exact_mut(width) {
                    row[left..right].copy_from_slice(first);
                }
            } else {
                let colours = &*self.scratch.stack.eye_colours();
                simd::run(self.isa, Put { colours, output, pixels, width, left, right });
            }
        }
        Ok(())
    }

    /// Traces the tile between two columns; see [`Tile`].
    fn trace(&mut self, left: usize, right: usize) -> Result<Option<[S; 3]>, TooDeep> {
        let samples = self.grid.samples as usize;
        let columns = &self.grid.columns[left * samples..right * samples];
        let mut candidates = self.frame.tiles.all();
        if self.frame.omissions.contains(Omission::Tiles) {
            let eye = &self.frame.scene.eye;
            self.frame.tiles.candidates(eye, columns, self.rows, &mut self.candidates);
            candidates = &self.candidates;
        }
        let tile = Tile {
            frame: self.frame,
            candidates,
            samples,
            columns,
            rows: self.rows,
            scratch: &mut self.scratch,
            observer: None,
        };
        simd::run(self.isa, tile)
    }
}
