//! Numbers of a queue's rays, side by side: a structure of arrays.
//!
//! A ray of a queue has a slot: lane `slot % LANES` of packet `slot / LANES`. Each number of all
//! rays is a column of its own, so that it is found by the slot alone, and eight of a packet are
//! read at once. Unused columns are never written, so they cost no cache.

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

/// A ray's place in its queue.
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

#[cfg(test)]
mod tests {
    use super::{Column, PACKETS, RAYS, Vec3Column};
    use crate::simd::numbers::{Numbers, TestScalar, isas};
    use crate::simd::{Kernel, LANES, Lanes, Packed, Vec3, run};

    /// Writes eight vectors to slots, and reads eight others.
    struct Move<'a, S> {
        column: &'a mut Vec3Column<S>,
        vectors: Packed<S>,
        to: [usize; LANES],
        from: [usize; LANES],
    }

    impl<S: TestScalar> Kernel for Move<'_, S> {
        type Scalar = S;
        type Output = Packed<S>;

        #[inline(always)]
        fn run<L: Lanes<Scalar = S>>(self) -> Packed<S> {
            self.column.scatter(|lane| self.to[lane], Vec3::<L>::from_arrays(&self.vectors));
            self.column.gather::<L>(|lane| self.from[lane]).to_arrays()
        }
    }

    /// The column as a plain list; where two lanes are the same ray's, the first one's counts.
    fn check<S: TestScalar>(slots: usize) {
        let mut numbers = Numbers::new(12);
        for isa in isas() {
            let mut column = Vec3Column::<S>::zero();
            let mut plain = [[S::ZERO; 3]; RAYS];
            for _ in 0..300 {
                let vectors = std::array::from_fn(|_| numbers.eight());
                let first = numbers.below(RAYS - slots + 1);
                let to = std::array::from_fn(|_| first + numbers.below(slots));
                let from: [usize; LANES] = std::array::from_fn(|_| numbers.below(RAYS));
                let read = run(isa, Move { column: &mut column, vectors, to, from });
                for lane in (0..LANES).rev() {
                    plain[to[lane]] = vectors.map(|component| component[lane]);
                }
                for (lane, &slot) in from.iter().enumerate() {
                    let found = read.map(|component| component[lane].pattern());
                    assert_eq!(found, plain[slot].map(S::pattern), "{isa}, slot {slot}");
                }
            }
            for (slot, expected) in plain.iter().enumerate() {
                let found = column.ray(slot).map(S::pattern);
                assert_eq!(found, expected.map(S::pattern), "{isa}, slot {slot}");
            }
        }
    }

    /// Few slots, so that most are written twice; and all of them.
    #[test]
    fn vectors_are_scattered_and_gathered_by_slot() {
        for slots in [1, 2, 5, 16, RAYS] {
            check::<f32>(slots);
            check::<f64>(slots);
        }
    }

    #[test]
    fn a_ray_is_a_lane_of_its_packet() {
        type L = <f32 as crate::simd::Lane>::Portable;
        let mut column = Column::<f32>::of(-1.0);
        for packet in 0..PACKETS {
            let numbers: [f32; LANES] = std::array::from_fn(|i| (packet * LANES + i) as f32);
            column.put(packet, L::from_array(numbers));
        }
        for slot in 0..RAYS {
            assert_eq!(column.ray(slot), slot as f32);
            assert_eq!(column.packet::<L>(slot / LANES).to_array()[slot % LANES], slot as f32);
        }
        let some = column.packets(3..5).as_flattened().to_vec();
        assert_eq!(some, (24..40).map(|slot| slot as f32).collect::<Vec<_>>());
        column.packet_mut(4)[0] = 0.5;
        column.packets_mut(PACKETS - 1..PACKETS)[0][7] = 0.25;
        assert_eq!((column.ray(32), column.ray(RAYS - 1)), (0.5, 0.25));
    }
}
