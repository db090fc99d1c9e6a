//! A tile of the picture: packets of eight pixels side by side, partial ones at the right edge.

use crate::lanes::{Kernel, LANES, Lane, Lanes};
use crate::packet::{TooDeep, Work, World, trace};
use crate::plane::PACKETS;
use crate::stack::Stack;
use crate::vec3::Vec3;
use crate::watch::Watcher;

/// Columns of a tile: few enough that most tiles show few primitives, many enough that finding
/// out which costs little.
pub(crate) const WIDTH: usize = 32;

/// Rows of a tile.
pub(crate) const HEIGHT: usize = PACKETS * LANES / WIDTH;

/// What the eye rays of eight columns have in common; of one sample a pixel.
#[derive(Clone, Copy)]
pub(crate) struct Across<S> {
    /// Their horizontal component, before they are made unit vectors, and its square.
    x: [S; LANES],
    square: [S; LANES],
    /// How many of the columns are in the picture, the first ones; the others repeat the last.
    live: usize,
}

impl<S: Lane> Across<S> {
    pub(crate) const EMPTY: Self = Self { x: [S::ZERO; LANES], square: [S::ZERO; LANES], live: 0 };
}

/// The work of one thread at a time.
pub(crate) struct Tile<'a, 'b, S: Lane> {
    pub(crate) world: World<'a, S>,
    /// Samples a side.
    pub(crate) samples: usize,
    /// Horizontal positions of the tile's sub-columns, `samples` a column.
    pub(crate) columns: &'a [S],
    /// Vertical positions of the tile's sub-rows, `samples` a row.
    pub(crate) rows: &'a [S],
    pub(crate) work: &'a mut Work<S>,
    pub(crate) stack: &'a mut Stack<'b, S>,
    /// Sees the first ray. Its tile is never filled without a ray.
    pub(crate) watch: Option<&'a mut Watcher<'b, S>>,
}

impl<S: Lane> Kernel for Tile<'_, '_, S> {
    type Scalar = S;
    /// The one colour of all pixels where no eye ray can meet anything; otherwise the pixels'
    /// colours are in the stack's `eye_colours`.
    type Output = Result<Option<[S; 3]>, TooDeep>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(mut self) -> Result<Option<[S; 3]>, TooDeep> {
        if self.world.candidates.eye.is_empty() && self.watch.is_none() {
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
        self.stack.start().rays += (self.columns.len() * self.rows.len()) as u64;
        if self.samples == 1 {
            return self.world.scene.background.into();
        }
        let samples = self.samples * self.samples;
        let background = Vec3::<L>::splat(self.world.scene.background);
        let mut sum = Vec3::zero();
        for _ in 0..samples {
            sum = sum + background;
        }
        sum.over(L::constant(samples as f64)).first()
    }

    /// The mean of all samples, summed from 0 row by row: in place of the colours.
    #[inline(always)]
    fn mean<L: Lanes<Scalar = S>>(&mut self) -> Result<(), TooDeep> {
        let n = self.samples;
        let zero = Vec3::<L>::zero();
        for sum in &mut *self.work.sums {
            *sum = zero.to_arrays();
        }
        for j in 0..n {
            for i in 0..n {
                self.trace::<L>(i, j)?;
                for (packet, sum) in self.work.sums.iter_mut().enumerate() {
                    let sample = self.stack.eye_colours().packet::<L>(packet);
                    *sum = (Vec3::from_arrays(sum) + sample).to_arrays();
                }
            }
        }
        let samples = L::constant((n * n) as f64);
        for (packet, sum) in self.work.sums.iter().enumerate() {
            self.stack.eye_colours().put(packet, Vec3::<L>::from_arrays(sum).over(samples));
        }
        Ok(())
    }

    /// Traces sample (i, j) of each pixel. Lanes beyond the picture's edge repeat the last pixel.
    #[inline(always)]
    fn trace<L: Lanes<Scalar = S>>(&mut self, i: usize, j: usize) -> Result<(), TooDeep> {
        let eye = &self.world.scene.eye;
        // Left to right: x and its square depend on the column alone.
        let mut len = 0;
        for (across, columns) in
            self.work.across.iter_mut().zip(self.columns.chunks(LANES * self.samples))
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
        let Work { waves: [wave, ..], across, .. } = &mut *self.work;
        let z = L::splat(-eye.distance);
        let mut packets = 0;
        for rows in self.rows.chunks_exact(self.samples) {
            let y = L::splat(rows[j]) * L::splat(eye.half_height);
            for Across { x, square, live } in &across[..len] {
                let length = (L::from_array(*square) + y * y + z * z).sqrt();
                let d = Vec3 { x: L::from_array(*x), y, z };
                wave.put_eye(packets, d * (L::constant(1.0) / length), *live);
                packets += 1;
            }
        }
        wave.has_eye(packets);
        trace::<L>(self.world, self.work, self.stack, self.watch.as_deref_mut())
    }
}
