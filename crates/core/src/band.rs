//! A band of rows: packets of 4 x 2 pixels, partial ones at the edges.

use catoptric_scene::{Compiled, Grid};

use crate::lanes::{Kernel, LANES, Lanes, Mask};
use crate::packet::{NONE, Rays, TooDeep, trace};
use crate::stack::Stack;
use crate::vec3::Vec3;

/// Pixels of a packet side by side.
const WIDE: usize = 4;

/// Rows of a packet.
const HIGH: usize = LANES / WIDE;

/// Rows of a band.
pub(crate) const ROWS: usize = 8 * HIGH;

/// The work of one thread at a time: `pixels` holds whole rows, the first being row `top`.
pub(crate) struct Band<'a, 'b> {
    pub(crate) scene: &'a Compiled,
    pub(crate) grid: &'a Grid,
    pub(crate) top: usize,
    pub(crate) pixels: &'a mut [[f32; 3]],
    pub(crate) stack: &'a mut Stack<'b>,
}

impl Kernel for Band<'_, '_> {
    type Output = Result<(), TooDeep>;

    #[inline(always)]
    fn run<L: Lanes>(self) -> Result<(), TooDeep> {
        let width = self.grid.width as usize;
        let height = self.pixels.len() / width;
        for y in (0..height).step_by(HIGH) {
            for x in (0..width).step_by(WIDE) {
                // Lane i is pixel (x + i % WIDE, y + i / WIDE); past an edge it is idle and
                // stands on the last pixel.
                let mut at = [(0, 0); LANES];
                let mut inside = 0;
                for (i, at) in at.iter_mut().enumerate() {
                    let (px, py) = (x + i % WIDE, y + i / WIDE);
                    inside |= u32::from(px < width && py < height) << i;
                    *at = (px.min(width - 1), py.min(height - 1));
                }
                let colour = pixel_packet::<L>(
                    self.scene,
                    self.grid,
                    self.top,
                    &at,
                    Mask::from_bits(inside),
                    self.stack,
                )?;
                let (r, g, b) = (colour.x.to_array(), colour.y.to_array(), colour.z.to_array());
                for (i, (px, py)) in at.into_iter().enumerate() {
                    if inside >> i & 1 == 1 {
                        self.pixels[py * width + px] = [r[i], g[i], b[i]];
                    }
                }
            }
        }
        Ok(())
    }
}

/// The mean of the samples of eight pixels, summed from 0 row by row.
#[inline(always)]
fn pixel_packet<L: Lanes>(
    scene: &Compiled,
    grid: &Grid,
    top: usize,
    at: &[(usize, usize); LANES],
    inside: Mask<L>,
    stack: &mut Stack,
) -> Result<Vec3<L>, TooDeep> {
    let n = grid.samples as usize;
    let mut sum = Vec3::zero();
    for j in 0..n {
        for i in 0..n {
            let (mut columns, mut rows) = ([0.0; LANES], [0.0; LANES]);
            for (lane, &(x, y)) in at.iter().enumerate() {
                columns[lane] = grid.columns[x * n + i];
                rows[lane] = grid.rows[(top + y) * n + j];
            }
            let rays = eye_rays(scene, L::from_array(columns), L::from_array(rows));
            sum = sum + trace(scene, rays, inside, stack)?;
        }
    }
    if n == 1 {
        // 0 + c is c, and so is c / 1.
        return Ok(sum);
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
