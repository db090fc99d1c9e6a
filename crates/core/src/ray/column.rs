//! Numbers of a queue's rays, side by side: a structure of arrays.
//!
//! A ray of a queue has a slot: lane `slot % LANES` of packet `slot / LANES`. Each number of all
//! rays is a column of its own, so that it is found by the slot alone, and eight of a packet are read
//! at once. Unused columns are never written, so they cost no cache.

use std::ops::Range;

use crate::simd::{LANES, Lane, Lanes, Vec3};

/// Packets of a tile, at any bounce: no ray has more than one child.
pub(crate) const PACKETS: usize = 64;

/// Rays of a tile.
pub(crate) const RAYS: usize = PACKETS * LANES;

/// Columns of a tile: few enough that most tiles show few primitives, many enough that finding
/// out which costs little.
pub(crate) const TILE_WIDTH: usize = 32;

/// Rows of a tile.
pub(crate) const TILE_HEIGHT: usize = RAYS / TILE_WIDTH;

/// Where a ray stands in its queue.
pub(crate) type Slot = u16;

/// One number of each ray. Indices are taken modulo [`PACKETS`] and [`RAYS`], which they are below
/// anyway: it tells the compiler, which then checks no bounds. There are two packets more, or the
/// same packet of two columns would lie a multiple of 4096 bytes apart and a processor take one for
/// the other.
#[derive(Clone, Copy)]
#[repr(align(64))]
pub(crate) struct Column<S>([[S; LANES]; PACKETS + 2]);

/// One vector of each ray.
pub(crate) struct Vec3Column<S>([Column<S>; 3]);

impl<S: Lane> Column<S> {
    /// A column that holds one number everywhere.
    pub(crate) fn of(number: S) -> Self {
        Self([[number; LANES]; PACKETS + 2])
    }

    /// The numbers of a packet.
    #[inline(always)]
    pub(crate) fn packet<L: Lanes<Scalar = S>>(&self, packet: usize) -> L {
        L::from_array(self.0[packet % PACKETS])
    }

    #[inline(always)]
    pub(crate) fn put<L: Lanes<Scalar = S>>(&mut self, packet: usize, numbers: L) {
        self.0[packet % PACKETS] = numbers.to_array();
    }

    #[inline(always)]
    pub(crate) fn packet_mut(&mut self, packet: usize) -> &mut [S; LANES] {
        &mut self.0[packet % PACKETS]
    }

    #[inline(always)]
    pub(crate) fn packets(&self, packets: Range<usize>) -> &[[S; LANES]] {
        &self.0[packets]
    }

    #[inline(always)]
    pub(crate) fn packets_mut(&mut self, packets: Range<usize>) -> &mut [[S; LANES]] {
        &mut self.0[packets]
    }

    /// The number of a ray.
    #[inline(always)]
    pub(crate) fn ray(&self, slot: usize) -> S {
        self.0.as_flattened()[slot % RAYS]
    }

    /// The numbers of eight rays.
    #[inline(always)]
    pub(crate) fn gather<L: Lanes<Scalar = S>>(&self, slots: impl Fn(usize) -> usize) -> L {
        L::gather(|lane| self.ray(slots(lane)))
    }

    #[inline(always)]
    fn put_ray(&mut self, slot: usize, number: S) {
        self.0.as_flattened_mut()[slot % RAYS] = number;
    }
}

impl<S: Lane> Vec3Column<S> {
    pub(crate) fn zero() -> Self {
        Self([Column::of(S::ZERO); 3])
    }

    #[inline(always)]
    pub(crate) fn packet<L: Lanes<Scalar = S>>(&self, packet: usize) -> Vec3<L> {
        let [x, y, z] = &self.0;
        Vec3 { x: x.packet(packet), y: y.packet(packet), z: z.packet(packet) }
    }

    #[inline(always)]
    pub(crate) fn put<L: Lanes<Scalar = S>>(&mut self, packet: usize, v: Vec3<L>) {
        let [x, y, z] = &mut self.0;
        x.put(packet, v.x);
        y.put(packet, v.y);
        z.put(packet, v.z);
    }

    #[inline(always)]
    pub(crate) fn packets(&self, packets: Range<usize>) -> [&[[S; LANES]]; 3] {
        let [x, y, z] = &self.0;
        [x.packets(packets.clone()), y.packets(packets.clone()), z.packets(packets)]
    }

    pub(crate) fn ray(&self, slot: usize) -> [S; 3] {
        let [x, y, z] = &self.0;
        [x.ray(slot), y.ray(slot), z.ray(slot)]
    }

    #[inline(always)]
    pub(crate) fn gather<L: Lanes<Scalar = S>>(
        &self,
        slots: impl Fn(usize) -> usize + Copy,
    ) -> Vec3<L> {
        let [x, y, z] = &self.0;
        Vec3 { x: x.gather(slots), y: y.gather(slots), z: z.gather(slots) }
    }

    /// Writes the vectors of eight rays; where two lanes are the same ray's, the first one's.
    #[inline(always)]
    pub(crate) fn scatter<L: Lanes<Scalar = S>>(
        &mut self,
        slots: impl Fn(usize) -> usize,
        v: Vec3<L>,
    ) {
        let [x, y, z] = &mut self.0;
        let [vx, vy, vz] = v.to_arrays();
        for i in 0..LANES {
            let lane = LANES - 1 - i;
            let slot = slots(lane);
            x.put_ray(slot, vx[lane]);
            y.put_ray(slot, vy[lane]);
            z.put_ray(slot, vz[lane]);
        }
    }
}
