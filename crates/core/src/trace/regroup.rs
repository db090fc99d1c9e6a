//! Regrouping: rays that go on alone wait until they are eight, whichever primitives they left.

use super::pending::ReturnSlot;
use super::stack::Stack;
use crate::ray::{Departing, RayQueue, Rays};
use crate::simd::{LANES, Lane, Lanes, Mask, Packed, Vec3};

/// Rays that do not yet fill a packet, and what they owe on the return.
pub(crate) struct Regroup<S> {
    origin: Packed<S>,
    direction: Packed<S>,
    from: [S; LANES],
    weight: [S; LANES],
    local: Packed<S>,
    slots: [ReturnSlot; LANES],
    live: usize,
}

impl<S: Lane> Regroup<S> {
    pub(crate) fn new() -> Self {
        Self {
            origin: [[S::ZERO; LANES]; 3],
            direction: [[S::ZERO; LANES]; 3],
            from: [S::ZERO; LANES],
            weight: [S::ZERO; LANES],
            local: [[S::ZERO; LANES]; 3],
            slots: [ReturnSlot::NOTHING; LANES],
            live: 0,
        }
    }

    /// Takes the lanes `goes_on` of eight rays, with their local light and return slots; whenever
    /// eight are together, they go to the queue and what they owe to the stack.
    #[inline(always)]
    pub(crate) fn add<L: Lanes<Scalar = S>>(
        &mut self,
        departing: &Departing<L>,
        goes_on: Mask<L>,
        (local, slots): (&Packed<S>, &[ReturnSlot; LANES]),
        queue: &mut RayQueue<S>,
        stack: &mut Stack<S>,
    ) {
        let Rays { origin, direction } = departing.rays;
        let (origin, direction) = (origin.to_arrays(), direction.to_arrays());
        #[expect(clippy::manual_map, reason = "a closure may be left as a call in the kernel")]
        let weight = match departing.weight {
            Some(weight) => Some(weight.to_array()),
            None => None,
        };
        let mut lanes = goes_on.bits();
        while lanes != 0 {
            let lane = lanes.trailing_zeros() as usize % LANES;
            lanes &= lanes - 1;
            let to = self.live % LANES;
            for axis in 0..3 {
                self.origin[axis][to] = origin[axis][lane];
                self.direction[axis][to] = direction[axis][lane];
                self.local[axis][to] = local[axis][lane];
            }
            self.from[to] = S::from_index(departing.from);
            if let Some(weight) = &weight {
                self.weight[to] = weight[lane];
            }
            self.slots[to] = slots[lane];
            self.live += 1;
            if self.live == LANES {
                self.release::<L>(queue, stack);
            }
        }
    }

    /// Ends the bounce: rays wait no longer.
    #[inline(always)]
    pub(crate) fn close<L: Lanes<Scalar = S>>(
        &mut self,
        queue: &mut RayQueue<S>,
        stack: &mut Stack<S>,
    ) {
        if self.live > 0 {
            self.release::<L>(queue, stack);
        }
        queue.end_run();
    }

    /// Sends the waiting rays on; lanes without one repeat the first.
    #[inline(always)]
    fn release<L: Lanes<Scalar = S>>(&mut self, queue: &mut RayQueue<S>, stack: &mut Stack<S>) {
        let Self { origin, direction, from, weight, local, slots, live } = self;
        for lane in *live..LANES {
            for axis in 0..3 {
                origin[axis][lane] = origin[axis][0];
                direction[axis][lane] = direction[axis][0];
                local[axis][lane] = local[axis][0];
            }
            (from[lane], weight[lane], slots[lane]) = (from[0], weight[0], slots[0]);
        }
        let rays =
            Rays { origin: Vec3::from_arrays(origin), direction: Vec3::from_arrays(direction) };
        let live = std::mem::take(live);
        stack.push(Vec3::<L>::from_arrays(local), slots, 0, queue.len());
        queue.push_mixed(&rays, L::from_array(*weight), L::from_array(*from), live);
    }
}
