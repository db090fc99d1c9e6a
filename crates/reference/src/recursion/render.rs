//! A ray for every sample of every pixel, row by row.

use std::sync::atomic::{AtomicBool, Ordering};

use catoptric_scene::{Compiled, Counts, Film, Grid};
use rayon::prelude::*;

use super::ray::Ray;
use super::real::{Real, Vec3};
use super::trace::Tracer;
use crate::depth::TooDeep;

/// Renders a view into a film of its size, on rayon's current threads.
///
/// The threads' stacks must hold [`STACK_BYTES`](crate::STACK_BYTES) where paths may go deep.
/// `progress` is told after every row how many pixels were added.
///
/// # Errors
/// [`TooDeep`] if a path has more than [`DEPTH_ALLOWED`](crate::DEPTH_ALLOWED) reflections; the
/// film is then void.
///
/// # Panics
/// If the film's size is not the grid's.
pub fn render(
    scene: &Compiled<Real>,
    grid: &Grid<Real>,
    film: &mut Film<Real>,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, TooDeep> {
    assert_eq!((film.width(), film.height()), (grid.width, grid.height), "the film's size");
    // Each row is a task of its own, with a tracer that counts its rays.
    let too_deep = AtomicBool::new(false);
    let counts = film
        .pixels_mut()
        .par_chunks_mut(grid.width as usize)
        .zip(grid.rows.par_chunks(grid.samples as usize))
        .map(|(pixels, rows)| {
            let mut tracer = Tracer::new(scene);
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
        // Sums of integers, so the order in which rows end changes nothing.
        .reduce(Counts::default, |mut sum, row| {
            sum.add(&row);
            sum
        });
    if too_deep.into_inner() { Err(TooDeep) } else { Ok(counts) }
}

impl Tracer<'_> {
    /// The mean of a pixel's samples, summed from 0 row by row.
    fn pixel(&mut self, columns: &[Real], rows: &[Real]) -> Vec3 {
        let mut sum = Vec3::ZERO;
        for &row in rows {
            for &column in columns {
                sum += self.trace(self.eye_ray(column, row), 1.0, 0);
            }
        }
        sum / (columns.len() * rows.len()) as Real
    }

    /// The ray from the eye through a point of the image plane, as [`Grid`] places it.
    #[must_use]
    pub fn eye_ray(&self, column: Real, row: Real) -> Ray {
        let eye = &self.scene.eye;
        let d = Vec3::new(column * eye.half_width, row * eye.half_height, -eye.distance);
        Ray { origin: Vec3::ZERO, direction: d * (1.0 / d.length()), left: None }
    }
}
