//! What becomes of a tile's colours: pixels of the film, or 8-bit levels.
//!
//! Colours go from eight lanes to pixels a packet at a time, so that for an 8-bit picture not even
//! a tile of linear light is made.

use catoptric_scene::Quantiser;

use crate::lanes::{Kernel, LANES, Lane, Lanes};
use crate::plane::Vectors;
use crate::vec3::Vec3;

/// A kind of picture.
pub(crate) trait Output<S>: Sync {
    type Pixel: Copy + Send;

    /// Must be `#[inline(always)]`. As many pixels as colours, at most [`LANES`].
    fn put(&self, colours: &[[S; 3]], pixels: &mut [Self::Pixel]);
}

/// Linear light, as it is.
pub(crate) struct Linear;

impl<S: Lane> Output<S> for Linear {
    type Pixel = [S; 3];

    #[inline(always)]
    fn put(&self, colours: &[[S; 3]], pixels: &mut [[S; 3]]) {
        pixels.copy_from_slice(colours);
    }
}

impl Output<f32> for Quantiser {
    type Pixel = [u8; 3];

    #[inline(always)]
    fn put(&self, colours: &[[f32; 3]], pixels: &mut [[u8; 3]]) {
        self.levels(colours, pixels);
    }
}

/// Fills the pixels of a tile.
pub(crate) struct Put<'a, S: Lane, O: Output<S>> {
    /// Row by row; the last packet of a row may have lanes beyond the tile's edge.
    pub(crate) colours: &'a Vectors<S>,
    pub(crate) output: &'a O,
    /// Whole rows of the picture, `width` pixels each.
    pub(crate) pixels: &'a mut [O::Pixel],
    pub(crate) width: usize,
    /// The tile's columns.
    pub(crate) left: usize,
    pub(crate) right: usize,
}

impl<S: Lane, O: Output<S>> Kernel for Put<'_, S, O> {
    type Scalar = S;
    type Output = ();

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) {
        let mut packets = 0..;
        let mut next = || packets.next().unwrap_or_default();
        let mut linear = [[S::ZERO; 3]; LANES];
        for row in self.pixels.chunks_exact_mut(self.width) {
            let (whole, rest) = row[self.left..self.right].as_chunks_mut::<LANES>();
            for pixels in whole {
                let Vec3 { x, y, z } = self.colours.packet::<L>(next());
                L::interleave(x, y, z, &mut linear);
                self.output.put(&linear, pixels);
            }
            if !rest.is_empty() {
                let Vec3 { x, y, z } = self.colours.packet::<L>(next());
                L::interleave(x, y, z, &mut linear);
                self.output.put(&linear[..rest.len()], rest);
            }
        }
    }
}
