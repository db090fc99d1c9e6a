//! A tile of the picture: packets of eight pixels side by side, partial ones at the right edge.

use super::across::Across;
use super::frame::Frame;
use super::observe::Observe;
use super::scratch::Scratch;
use super::stack::TooDeep;
use super::wavefront::trace;
use crate::simd::{Kernel, LANES, Lane, Lanes, Vec3};

/// The work of one thread at a time.
pub(crate) struct Tile<'a, 'b, S: Lane> {
    pub(crate) frame: &'a Frame<'a, S>,
    /// The primitives that its eye rays are tested against.
    pub(crate) candidates: &'a [u32],
    /// Samples a side.
    pub(crate) samples: usize,
    /// Horizontal positions of the tile's sub-columns, `samples` a column.
    pub(crate) columns: &'a [S],
    /// Vertical positions of the tile's sub-rows, `samples` a row.
    pub(crate) rows: &'a [S],
    pub(crate) scratch: &'a mut Scratch<'b, S>,
    /// Sees the first ray. Its tile is never filled without a ray.
    pub(crate) observer: Option<&'a mut (dyn Observe<S> + 'a)>,
}

impl<S: Lane> Kernel for Tile<'_, '_, S> {
    type Scalar = S;
    /// The one colour of all pixels where no eye ray can meet anything; otherwise the pixels'
    /// colours are in the stack's `eye_colours`.
    type Output = Result<Option<[S; 3]>, TooDeep>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(mut self) -> Result<Option<[S; 3]>, TooDeep> {
        if self.candidates.is_empty() && self.observer.is_none() {
            return Ok(Some(self.background::<L>()));
        }
        let n = self.samples;
        // One sample is the mean: 0 + c is c, and so is c / 1.
        if n == 1 {
            self.trace::<L>(0, 0)?;
        } else {
            self.mean::<L>()?;
        }
        Ok(None)
    }
}

impl<S: Lane> Tile<'_, '_, S> {
    /// No eye ray meets anything: every sample is the background.
    #[inline(always)]
    fn background<L: Lanes<Scalar = S>>(&mut self) -> [S; 3] {
        self.scratch.stack.start().rays += (self.columns.len() * self.rows.len()) as u64;
        if self.samples == 1 {
            return self.frame.scene.background.into();
        }
        let samples = self.samples * self.samples;
        let background = Vec3::<L>::splat(self.frame.scene.background);
        let mut sum = Vec3::zero();
        for _ in 0..samples {
            sum = sum + background;
        }
        sum.div(L::constant(samples as f64)).first()
    }

    /// The mean of all samples, summed from 0 row by row: in place of the colours.
    #[inline(always)]
    fn mean<L: Lanes<Scalar = S>>(&mut self) -> Result<(), TooDeep> {
        let n = self.samples;
        let zero = Vec3::<L>::zero();
        for sum in &mut *self.scratch.sums {
            *sum = zero.to_arrays();
        }
        for j in 0..n {
            for i in 0..n {
                self.trace::<L>(i, j)?;
                for (packet, sum) in self.scratch.sums.iter_mut().enumerate() {
                    let sample = self.scratch.stack.eye_colours().packet::<L>(packet);
                    *sum = (Vec3::from_arrays(sum) + sample).to_arrays();
                }
            }
        }
        let samples = L::constant((n * n) as f64);
        for (packet, sum) in self.scratch.sums.iter().enumerate() {
            self.scratch.stack.eye_colours().put(packet, Vec3::<L>::from_arrays(sum).div(samples));
        }
        Ok(())
    }

    /// Traces sample (i, j) of each pixel. Lanes beyond the picture's edge repeat the last pixel.
    #[inline(always)]
    fn trace<L: Lanes<Scalar = S>>(&mut self, i: usize, j: usize) -> Result<(), TooDeep> {
        let eye = &self.frame.scene.eye;
        // Left to right: x and its square depend on the column alone.
        let mut len = 0;
        for (across, columns) in
            self.scratch.across.iter_mut().zip(self.columns.chunks(LANES * self.samples))
        {
            let live = columns.len() / self.samples;
            let mut lanes = [S::ZERO; LANES];
            for (lane, column) in lanes.iter_mut().enumerate() {
                *column = columns[lane.min(live - 1) * self.samples + i];
            }
            let x = L::from_array(lanes) * L::splat(eye.half_width);
            *across = Across { x: x.to_array(), square: (x * x).to_array(), live };
            len += 1;
        }
        // Top to bottom: y and its square depend on the row alone; z is that of all.
        let Scratch { queues: [queue, ..], across, .. } = &mut *self.scratch;
        let z = L::splat(-eye.distance);
        let mut packets = 0;
        for rows in self.rows.chunks_exact(self.samples) {
            let y = L::splat(rows[j]) * L::splat(eye.half_height);
            for Across { x, square, live } in &across[..len] {
                let length = (L::from_array(*square) + y * y + z * z).sqrt();
                let d = Vec3 { x: L::from_array(*x), y, z };
                queue.put_eye_rays(packets, d * (L::constant(1.0) / length), *live);
                packets += 1;
            }
        }
        queue.end_eye_rays(packets);
        #[expect(clippy::manual_map, reason = "a closure may be left as a call in the kernel")]
        let observer = match &mut self.observer {
            Some(observer) => Some(&mut **observer),
            None => None,
        };
        trace::<L>(self.frame, self.candidates, self.scratch, observer)
    }
}
