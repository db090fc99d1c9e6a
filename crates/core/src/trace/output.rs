//! What becomes of a tile's colours: pixels of the film, or 8-bit levels.
//!
//! Colours go from eight lanes to eight pixels, so that for an 8-bit picture not even a tile of
//! linear light is made.

use catoptric_scene::Quantiser;

use crate::ray::Vec3Column;
use crate::simd::{Kernel, LANES, Lane, Lanes, Vec3};

/// A kind of picture.
pub(crate) trait Output<S>: Sync {
    type Pixel: Copy + Send;

    /// Converts one colour.
    fn pixel(&self, colour: [S; 3]) -> Self::Pixel;

    /// Converts eight colours to pixels. Must be `#[inline(always)]`.
    fn pixels<L: Lanes<Scalar = S>>(&self, colours: Vec3<L>, to: &mut [Self::Pixel; LANES]);
}

/// Linear light, as it is.
pub(crate) struct Linear;

impl<S: Lane> Output<S> for Linear {
    type Pixel = [S; 3];

    fn pixel(&self, colour: [S; 3]) -> [S; 3] {
        colour
    }

    #[inline(always)]
    fn pixels<L: Lanes<Scalar = S>>(&self, colours: Vec3<L>, to: &mut [[S; 3]; LANES]) {
        L::interleave(colours.x, colours.y, colours.z, to);
    }
}

impl Output<f32> for Quantiser {
    type Pixel = [u8; 3];

    fn pixel(&self, colour: [f32; 3]) -> [u8; 3] {
        colour.map(|x| self.level(x))
    }

    #[inline(always)]
    fn pixels<L: Lanes<Scalar = f32>>(&self, colours: Vec3<L>, to: &mut [[u8; 3]; LANES]) {
        let mut colours = colours.to_arrays();
        if self.is_linear() {
            for x in colours.as_flattened_mut() {
                *x = Self::scaled(*x);
            }
            let [x, y, z] = colours.map(L::from_array);
            L::bytes(x, y, z, to);
        } else {
            let [x, y, z] = colours;
            for (lane, to) in to.iter_mut().enumerate() {
                *to = [self.level(x[lane]), self.level(y[lane]), self.level(z[lane])];
            }
        }
    }
}

/// Fills the pixels of a tile.
pub(crate) struct Put<'a, S: Lane, O: Output<S>> {
    /// Row by row; the last packet of a row may have lanes beyond the tile's edge.
    pub(crate) colours: &'a Vec3Column<S>,
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
        for row in self.pixels.chunks_exact_mut(self.width) {
            let (whole, rest) = row[self.left..self.right].as_chunks_mut::<LANES>();
            for pixels in whole {
                self.output.pixels(self.colours.packet::<L>(next()), pixels);
            }
            if let Some(&first) = rest.first() {
                let mut pixels = [first; LANES];
                self.output.pixels(self.colours.packet::<L>(next()), &mut pixels);
                rest.copy_from_slice(&pixels[..rest.len()]);
            }
        }
    }
}
