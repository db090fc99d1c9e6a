//! Makes a picture from eye rays, the same for every rung: rows on rayon's threads.

use std::sync::atomic::{AtomicBool, Ordering};

use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;
use rayon::prelude::*;

use crate::{Error, Flight, Walk, Watch};

/// Renders a view with a rung that takes one eye ray at a time.
///
/// # Errors
/// [`Error::TooDeep`] if a path has more than `deepest` reflections; the film is then void.
///
/// # Panics
/// If the film's size is not the grid's.
pub fn render_by(
    scene: &Compiled,
    grid: &Grid,
    film: &mut Film,
    deepest: u32,
    trace: impl Fn(&mut Walk<()>, Flight) -> Vec3 + Sync,
) -> Result<Counts, Error> {
    rows(grid, film, |pixels, rows| {
        let mut walk = Walk::new(scene, deepest, ());
        for (pixel, columns) in pixels.iter_mut().zip(grid.columns.chunks(rows.len())) {
            let mut sum = Vec3::ZERO;
            for &row in rows {
                for &column in columns {
                    let eye = walk.eye(column, row);
                    sum += trace(&mut walk, eye);
                }
            }
            *pixel = (sum / (columns.len() * rows.len()) as f32).to_array();
        }
        walk.finish()
    })
}

/// Lets `watch` see the life of one eye ray; gives the ray's colour.
///
/// # Errors
/// [`Error::TooDeep`] if the path has more than `deepest` reflections.
pub fn watch_by<'a>(
    scene: &'a Compiled,
    (column, row): (f32, f32),
    watch: &'a mut dyn Watch,
    deepest: u32,
    trace: impl Fn(&mut Walk<'a, &'a mut dyn Watch>, Flight) -> Vec3,
) -> Result<Vec3, Error> {
    let mut walk = Walk::new(scene, deepest, watch);
    let eye = walk.eye(column, row);
    let colour = trace(&mut walk, eye);
    walk.finish().map(|_| colour)
}

/// Fills every row: `fill` gets the row's pixels and the positions of its sub-rows.
pub(crate) fn rows(
    grid: &Grid,
    film: &mut Film,
    fill: impl Fn(&mut [[f32; 3]], &[f32]) -> Result<Counts, Error> + Sync,
) -> Result<Counts, Error> {
    assert_eq!((film.width(), film.height()), (grid.width, grid.height), "the film's size");
    let failed = AtomicBool::new(false);
    film.pixels_mut()
        .par_chunks_mut(grid.width as usize)
        .zip(grid.rows.par_chunks(grid.samples as usize))
        .map(|(pixels, rows)| {
            // The film is void; the rest of it could take hours.
            if failed.load(Ordering::Relaxed) {
                return Ok(Counts::default());
            }
            let filled = fill(pixels, rows);
            failed.fetch_or(filled.is_err(), Ordering::Relaxed);
            filled
        })
        .try_reduce(Counts::default, |mut sum, row| {
            sum.add(&row);
            Ok(sum)
        })
}
