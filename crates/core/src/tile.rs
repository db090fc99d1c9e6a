//! A tile of the picture: packets of eight pixels side by side, partial ones at the right edge.

use catoptric_scene::Compiled;

use crate::lanes::{Kernel, LANES, Lanes, Mask};
use crate::packet::{Candidates, NONE, Rays, TooDeep, trace};
use crate::stack::Stack;
use crate::vec3::Vec3;

/// Columns of a tile: few enough that most tiles show few primitives, many enough that finding
/// out which costs little.
pub(crate) const WIDTH: usize = 64;

/// Rows of a tile.
pub(crate) const HEIGHT: usize = 8;

/// The work of one thread at a time.
pub(crate) struct Tile<'a, 'b> {
    pub(crate) scene: &'a Compiled,
    pub(crate) candidates: Candidates<'a>,
    /// Samples a side.
    pub(crate) samples: usize,
    /// Horizontal positions of the tile's sub-columns, `samples` a column.
    pub(crate) columns: &'a [f32],
    /// Vertical positions of the tile's sub-rows, `samples` a row.
    pub(crate) rows: &'a [f32],
    /// Whole rows of the picture, `width` pixels each; the tile begins at column `left`.
    pub(crate) pixels: &'a mut [[f32; 3]],
    pub(crate) width: usize,
    pub(crate) left: usize,
    pub(crate) stack: &'a mut Stack<'b>,
}

impl Kernel for Tile<'_, '_> {
    type Output = Result<(), TooDeep>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Result<(), TooDeep> {
        let Self { scene, candidates, samples: n, columns, left, stack, .. } = self;
        let right = left + columns.len() / n;
        let rows = self.pixels.chunks_exact_mut(self.width).zip(self.rows.chunks_exact(n));
        for (row, sub_rows) in rows {
            let packets = row[left..right].chunks_mut(LANES);
            for (pixels, sub_columns) in packets.zip(columns.chunks(LANES * n)) {
                let live = pixels.len();
                let colour = packet::<L>(scene, candidates, sub_columns, sub_rows, live, stack)?;
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
    candidates: Candidates,
    sub_columns: &[f32],
    sub_rows: &[f32],
    live: usize,
    stack: &mut Stack,
) -> Result<Vec3<L>, TooDeep> {
    if let (&[row], Ok(columns)) = (sub_rows, <[f32; LANES]>::try_from(sub_columns)) {
        // One sample: 0 + c is c, and so is c / 1.
        let rays = eye_rays(scene, L::from_array(columns), L::splat(row));
        return trace(scene, candidates, rays, Mask::first(LANES), stack);
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
            sum = sum + trace(scene, candidates, rays, Mask::first(live), stack)?;
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
