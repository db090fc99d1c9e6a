//! Rendering a view: bands of tiles on rayon's threads.

use catoptric_scene::{Compiled, Counts, Film, Grid, Quantiser, Scalar};
use rayon::prelude::*;

use crate::omission::Omission;
use crate::plan::{Plan, candidates};
use crate::ray::{TILE_HEIGHT, TILE_WIDTH};
use crate::settings::{Settings, StackFull};
use crate::simd::{self, Isa, Lane};
use crate::trace::{Budget, Frame, Linear, Output, Put, Scratch, Tile, TooDeep};

/// A scalar that the engine computes in: f32, which it is made for, or f64.
pub trait PacketScalar: Scalar {
    /// [`render_planned`], compiled once for each scalar, here.
    #[doc(hidden)]
    fn render_pixels(
        scene: &Compiled<Self>,
        plan: &Plan,
        grid: &Grid<Self>,
        pixels: &mut [[Self; 3]],
        settings: Settings,
        progress: &(dyn Fn(u64) + Sync),
    ) -> Result<Counts, StackFull>;
}

macro_rules! packet_scalar {
    ($scalar:ty) => {
        impl PacketScalar for $scalar {
            fn render_pixels(
                scene: &Compiled<Self>,
                plan: &Plan,
                grid: &Grid<Self>,
                pixels: &mut [[Self; 3]],
                settings: Settings,
                progress: &(dyn Fn(u64) + Sync),
            ) -> Result<Counts, StackFull> {
                bands(scene, plan, grid, &Linear, pixels, settings, progress)
            }
        }
    };
}

packet_scalar!(f32);
packet_scalar!(f64);

/// Renders a view into a film of its size, on rayon's current threads.
///
/// The picture is that of the recursion in the same scalar.
///
/// `progress` is told after every few rows how many pixels were added. Memory: the film, and
/// half a megabyte a thread (f64: one); 16 bytes a primitive and thread; 64 bytes (f64: 128) a ball
/// and lamp, or if that is more a megabyte (f64: two); and 8 bytes an occluder and thread. Where paths go deep, a thread's stack takes
/// 16 bytes (f64: 28) a ray of a tile and level down to level 1024, 9 MB at most, and from there on
/// 168 (f64: 264) a level; and up to a quarter more, for it grows by that much.
///
/// # Errors
/// [`StackFull`] if paths go too deep for the limit; the film is then void.
///
/// # Panics
/// If the film's size is not the grid's.
pub fn render<S: PacketScalar>(
    scene: &Compiled<S>,
    grid: &Grid<S>,
    film: &mut Film<S>,
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    render_planned(scene, &Plan::new(scene, grid), grid, film, settings, progress)
}

/// [`render`] by a plan of that scene and grid, which changes how long it takes and nothing else.
///
/// # Errors
/// As [`render`].
///
/// # Panics
/// As [`render`].
pub fn render_planned<S: PacketScalar>(
    scene: &Compiled<S>,
    plan: &Plan,
    grid: &Grid<S>,
    film: &mut Film<S>,
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    assert_eq!((film.width(), film.height()), (grid.width, grid.height), "the film's size");
    S::render_pixels(scene, plan, grid, film.pixels_mut(), settings, progress)
}

/// Renders a view straight to 8-bit levels: those that `quantiser` gives for the film, which
/// is never made.
///
/// Shape: `levels` holds the grid's pixels row by row from the top left. Otherwise as
/// [`render`], without the film.
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
    render_levels_planned(
        scene,
        &Plan::new(scene, grid),
        grid,
        quantiser,
        levels,
        settings,
        progress,
    )
}

/// [`render_levels`] by a plan of that scene and grid.
///
/// # Errors
/// As [`render`].
///
/// # Panics
/// As [`render_levels`].
pub fn render_levels_planned(
    scene: &Compiled,
    plan: &Plan,
    grid: &Grid,
    quantiser: &Quantiser,
    levels: &mut [[u8; 3]],
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    assert_eq!(levels.len(), grid.width as usize * grid.height as usize, "a place for each pixel");
    bands(scene, plan, grid, quantiser, levels, settings, progress)
}

/// Hands out bands of rows to rayon's threads.
fn bands<S: Lane, O: Output<S>>(
    scene: &Compiled<S>,
    plan: &Plan,
    grid: &Grid<S>,
    output: &O,
    pixels: &mut [O::Pixel],
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    let budget = Budget::new(settings.stack_limit);
    let samples = grid.columns.len() * grid.rows.len();
    let frame = Frame::new(scene, candidates(scene, plan), samples, plan.depth, plan.omissions);
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
                // One row is filled, the others are copies of it: pixels of three numbers are slow to
                // write one by one.
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
