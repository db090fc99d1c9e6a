//! A ray for every sample of every pixel, row by row.

use std::sync::atomic::{AtomicBool, Ordering};

use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;
use rayon::prelude::*;

use crate::trace::{Ray, Tracer};

/// The deepest path that the recursion follows.
pub const DEPTH_ALLOWED: u32 = 100_000;

/// The stack, in bytes, that a thread needs for a path of [`DEPTH_ALLOWED`]: the recursion
/// keeps one frame a mirror on it, with room for the larger frames of a debug build.
pub const STACK_BYTES: usize = 256 << 20;

/// A path that would have overflowed the stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error(
    "a path has more than {} reflections, which the recursion's stack does not hold",
    DEPTH_ALLOWED
)]
pub struct TooDeep;

/// Renders a view into a film of its size, on rayon's current threads.
///
/// Their stacks must hold [`STACK_BYTES`] where paths may go deep. `rows_done` is told after
/// every row how many pixels were added.
///
/// # Errors
/// [`TooDeep`] if a path has more than [`DEPTH_ALLOWED`] reflections; the film is then void.
///
/// # Panics
/// If the film's size is not the grid's.
pub fn render(
    scene: &Compiled,
    grid: &Grid,
    film: &mut Film,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, TooDeep> {
    assert_eq!((film.width(), film.height()), (grid.width, grid.height), "the film's size");
    let too_deep = AtomicBool::new(false);
    let counts = film
        .pixels_mut()
        .par_chunks_mut(grid.width as usize)
        .zip(grid.rows.par_chunks(grid.samples as usize))
        .map(|(pixels, rows)| {
            let mut tracer = Tracer { scene, counts: Counts::default(), too_deep: false };
            let columns = grid.columns.chunks(grid.samples as usize);
            for (pixel, columns) in pixels.iter_mut().zip(columns) {
                // The film is void; the rest of it could take hours.
                if too_deep.load(Ordering::Relaxed) {
                    break;
                }
                *pixel = tracer.pixel(columns, rows).to_array();
                too_deep.fetch_or(tracer.too_deep, Ordering::Relaxed);
            }
            progress(pixels.len() as u64);
            tracer.counts
        })
        .reduce(Counts::default, |mut sum, row| {
            sum.add(&row);
            sum
        });
    if too_deep.into_inner() { Err(TooDeep) } else { Ok(counts) }
}

impl Tracer<'_> {
    /// The mean of a pixel's samples, summed from 0 row by row.
    fn pixel(&mut self, columns: &[f32], rows: &[f32]) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for &row in rows {
            for &column in columns {
                sum += self.trace(self.eye_ray(column, row), 1.0, 0);
            }
        }
        sum / (columns.len() * rows.len()) as f32
    }

    /// The ray from the eye through a point of the image plane.
    fn eye_ray(&self, column: f32, row: f32) -> Ray {
        let eye = &self.scene.eye;
        let d = eye.forward + eye.right * column + eye.up * row;
        Ray { origin: Vec3::ZERO, direction: d * (1.0 / d.length()), left: None }
    }
}
