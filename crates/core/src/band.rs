//! A band of rows: packets of eight pixels side by side, a partial one at the right edge.

use catoptric_scene::{Compiled, Grid};

use crate::lanes::{Kernel, LANES, Lanes, Mask};
use crate::packet::{NONE, Rays, TooDeep, trace};
use crate::stack::Stack;
use crate::vec3::Vec3;

/// Rows of a band.
pub(crate) const ROWS: usize = 8;

/// The work of one thread at a time.
pub(crate) struct Band<'a, 'b> {
    pub(crate) scene: &'a Compiled,
    pub(crate) grid: &'a Grid,
    /// Vertical positions of the band's sub-rows, `grid.samples` a row.
    pub(crate) rows: &'a [f32],
    /// Whole rows.
    pub(crate) pixels: &'a mut [[f32; 3]],
    pub(crate) stack: &'a mut Stack<'b>,
}

impl Kernel for Band<'_, '_> {
    type Output = Result<(), TooDeep>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Result<(), TooDeep> {
        let n = self.grid.samples as usize;
        let rows = self.pixels.chunks_exact_mut(self.grid.width as usize);
        for (row, sub_rows) in rows.zip(self.rows.chunks_exact(n)) {
            let packets = row.chunks_mut(LANES);
            for (pixels, sub_columns) in packets.zip(self.grid.columns.chunks(LANES * n)) {
                let colour =
                    packet::<L>(self.scene, sub_columns, sub_rows, pixels.len(), self.stack)?;
                let (r, g, b) = (colour.x.to_array(), colour.y.to_array(), colour.z.to_array());
                for (pixel, ((r, g), b)) in pixels.iter_mut().zip(r.into_iter().zip(g).zip(b)) {
                    *pixel = [r, g, b];
                }
            }
        }
        Ok(())
    }
}

/// The mean of the samples of `live` pixels, summed from 0 row by row.
///
/// Shape: `sub_columns[lane * n + i]`, `sub_rows[j]`. Idle lanes stand on the last pixel.
#[inline(always)]
fn packet<L: Lanes>(
    scene: &Compiled,
    sub_columns: &[f32],
    sub_rows: &[f32],
    live: usize,
    stack: &mut Stack,
) -> Result<Vec3<L>, TooDeep> {
    if let (&[row], Ok(columns)) = (sub_rows, <[f32; LANES]>::try_from(sub_columns)) {
        // One sample: 0 + c is c, and so is c / 1.
        let rays = eye_rays(scene, L::from_array(columns), L::splat(row));
        return trace(scene, rays, Mask::first(LANES), stack);
    }
    let n = sub_rows.len();
    let mut sum = Vec3::zero();
    for &row in sub_rows {
        for i in 0..n {
            let mut columns = [0.0; LANES];
            for (lane, column) in columns.iter_mut().enumerate() {
                *column = sub_columns[lane.min(live - 1) * n + i];
            }
            let rays = eye_rays(scene, L::from_array(columns), L::splat(row));
            sum = sum + trace(scene, rays, Mask::first(live), stack)?;
        }
    }
    let samples = L::splat((n * n) as f32);
    Ok(Vec3 { x: sum.x / samples, y: sum.y / samples, z: sum.z / samples })
}

/// The rays from the eye through points of the image plane.
#[inline(always)]
fn eye_rays<L: Lanes>(scene: &Compiled, column: L, row: L) -> Rays<L> {
    let eye = &scene.eye;
    let (right, up) = (Vec3::splat(eye.right), Vec3::splat(eye.up));
    let d = Vec3::splat(eye.forward) + right * column + up * row;
    let direction = d * (L::splat(1.0) / d.length());
    Rays { origin: Vec3::zero(), direction, left: L::index(NONE) }
}
