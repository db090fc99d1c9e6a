//! Hit groups: where the rays of a bounce met one primitive, eight at a time.

use glam::DVec3;

use super::nearest::{MetPrimitive, NearestHits};
use super::pending::ReturnSlot;
use crate::cull::POINT;
use crate::ray::{Compactor, PACKETS, RayQueue, Rays};
use crate::shape::Shape;
use crate::simd::{LANES, Lane, Lanes, Mask, Packed, Vec3};

/// Hits of up to eight rays; lanes without one repeat the first.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
pub(crate) struct HitGroup<S> {
    /// Arms from the shape's anchor.
    pub(crate) arm: Packed<S>,
    /// The rays' return slots.
    pub(crate) slots: [ReturnSlot; LANES],
    /// Ray directions. Filled for gathered rays only; whole packets read theirs from the queue.
    pub(crate) direction: Packed<S>,
    /// How many rays a gathered group has; a whole packet has all.
    pub(crate) live: u32,
}

/// Room for the hits of one primitive.
pub(crate) struct HitGroups<S> {
    list: Vec<HitGroup<S>>,
    len: usize,
    compactor: Compactor,
    /// Lane by lane, the least and the greatest components of all arms.
    lowest: Packed<S>,
    highest: Packed<S>,
}

impl<S: Lane> HitGroups<S> {
    pub(crate) fn new() -> Self {
        let empty = [[S::ZERO; LANES]; 3];
        let slots = [ReturnSlot::NOTHING; LANES];
        let group = HitGroup { arm: empty, slots, direction: empty, live: 0 };
        Self {
            list: vec![group; PACKETS],
            len: 0,
            compactor: Compactor::new(),
            lowest: empty,
            highest: empty,
        }
    }

    #[inline(always)]
    pub(crate) fn all(&self) -> &[HitGroup<S>] {
        &self.list[..self.len]
    }

    /// Collects all hits of one primitive; how many rays met it.
    ///
    /// A packet all of whose rays met it is a group as it is. Rays of other packets are put
    /// together to eights.
    ///
    /// There are no more groups than packets: so many packets met it whole, and the single rays
    /// come from others, eight of them at most. The list does not end before them.
    #[inline(always)]
    pub(crate) fn collect<L: Lanes<Scalar = S>, F: Shape<L>>(
        &mut self,
        shape: F,
        met: MetPrimitive,
        queue: &RayQueue<S>,
        nearest: &NearestHits<S>,
    ) -> u64 {
        let (lowest, highest) = (L::constant(f64::INFINITY), L::constant(f64::NEG_INFINITY));
        let mut bounds = [Vec3::all(lowest), Vec3::all(highest)];
        let mut list = self.list.iter_mut();
        let mut len = 0;
        let mut hits = 0;
        self.compactor.clear();
        // Whole packets become groups, the hits of others are noted.
        let MetPrimitive { index, mut packets } = met;
        while packets != 0 {
            let packet = packets.trailing_zeros() as usize;
            packets &= packets - 1;
            let lanes = nearest.index.packet::<L>(packet).same_bits(L::index(index)).bits();
            hits += u64::from(lanes.count_ones());
            if lanes != Mask::<L>::ALL {
                self.compactor.add(packet, lanes);
                continue;
            }
            let Some(at) = list.next() else { break };
            len += 1;
            at.slots = ReturnSlot::to_packet(packet);
            let rays = queue.rays(packet);
            at.fill::<L, F>(shape, &rays, nearest.distance.packet(packet), &mut bounds);
        }
        // The noted hits are gathered.
        self.compactor.fill_up();
        for group in 0..self.compactor.groups() {
            let Some(at) = list.next() else { break };
            len += 1;
            let (single, live) = self.compactor.group(group);
            let slots = |lane: usize| single[lane] as usize;
            (at.slots, at.live) = (ReturnSlot::to_rays(&single), live as u32);
            let rays = queue.gather(slots);
            at.direction = rays.direction.to_arrays();
            at.fill::<L, F>(shape, &rays, nearest.distance.gather(slots), &mut bounds);
        }
        self.len = len;
        (self.lowest, self.highest) = (bounds[0].to_arrays(), bounds[1].to_arrays());
        hits
    }

    /// Centre, a point of the scalar, and radius of a sphere that holds all points, and all that
    /// they were rounded from. `anchor` is where arms start.
    #[inline(always)]
    pub(crate) fn bounds(&self, anchor: DVec3) -> (DVec3, f64) {
        let (mut center, mut corner) = (DVec3::ZERO, DVec3::ZERO);
        for axis in 0..3 {
            let (mut least, mut most) = (self.lowest[axis][0], self.highest[axis][0]);
            for lane in 1..LANES {
                let (a, b) = (self.lowest[axis][lane], self.highest[axis][lane]);
                least = if a < least { a } else { least };
                most = if b > most { b } else { most };
            }
            let (least, most) = (anchor[axis] + least.to_f64(), anchor[axis] + most.to_f64());
            center[axis] = S::rounded((least + most) * 0.5).to_f64();
            let (below, above) = (center[axis] - least, most - center[axis]);
            corner[axis] = if below > above { below } else { above };
        }
        let radius = corner.length();
        (center, radius + POINT * (center.length() + radius))
    }
}

impl<S: Lane> HitGroup<S> {
    /// Sets where rays met a primitive, and widens the bounds of its arms.
    ///
    /// An arm of NaN, which no light reaches, changes no bound: of it and a number the second is
    /// taken.
    #[inline(always)]
    fn fill<L: Lanes<Scalar = S>, F: Shape<L>>(
        &mut self,
        shape: F,
        rays: &Rays<L>,
        distance: L,
        bounds: &mut [Vec3<L>; 2],
    ) {
        let arm = shape.arm(rays, distance);
        self.arm = arm.to_arrays();
        *bounds = [arm.min_or_second(bounds[0]), arm.max_or_second(bounds[1])];
    }
}
