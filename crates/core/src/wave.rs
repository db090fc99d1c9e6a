//! The rays of one level of a tile, packed: those that go on leave no gaps.
//!
//! Eight rays that met one primitive together go on together, as a packet. Rays that go on
//! alone wait until they are eight, whichever primitives they left. So only the last packet of
//! a wave of mirrored rays has lanes without a ray, its last ones.
//!
//! A wave has at most as many rays as the one above it, and all its packets but the last are
//! full: so it never holds more than [`PACKETS`]. Indices are taken modulo that, here and in
//! `hits`, to tell it to the compiler, which then checks no bounds.

use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::packet::NONE;
use crate::stack::Pending;
use crate::vec3::{Packed, Vec3};

/// Packets of a tile, at any level: no ray has more than one child.
pub(crate) const PACKETS: usize = 64;

/// Where a ray stands in its level: lane `slot % LANES` of packet `slot / LANES`.
pub(crate) type Slot = u16;

/// Eight rays in memory. The first `live` lanes hold rays, the others nonsense.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct RayPacket<S> {
    pub(crate) origin: Packed<S>,
    pub(crate) direction: Packed<S>,
    /// Index of the primitive just left, which is not met again, or all ones.
    pub(crate) left: [S; LANES],
    /// The primitive that all lanes left, or [`NONE`].
    pub(crate) all_left: u32,
    pub(crate) live: u32,
}

impl<S: Lane> RayPacket<S> {
    pub(crate) const EMPTY: Self = Self {
        origin: [[S::ZERO; LANES]; 3],
        direction: [[S::ZERO; LANES]; 3],
        left: [S::ZERO; LANES],
        all_left: NONE,
        live: 0,
    };
}

/// Rays of a tile at one level.
pub(crate) struct Wave<S> {
    packets: Box<[RayPacket<S>; PACKETS]>,
    /// Cumulative weights; kept only where there is a cut by weight.
    weights: Box<[[S; LANES]; PACKETS]>,
    len: usize,
    waiting: Waiting<S>,
}

/// Rays that do not yet fill a packet.
struct Waiting<S> {
    rays: RayPacket<S>,
    weight: [S; LANES],
    k: [S; LANES],
    parents: [Slot; LANES],
}

/// Mirrored rays that leave one primitive.
pub(crate) struct Mirrored<L: Lanes> {
    pub(crate) origin: Vec3<L>,
    pub(crate) direction: Vec3<L>,
    /// `None` without a cut by weight.
    pub(crate) weight: Option<L>,
    pub(crate) k: L::Scalar,
    pub(crate) left: u32,
}

impl<S: Lane> Wave<S> {
    pub(crate) fn new() -> Self {
        Self {
            packets: Box::new([RayPacket::EMPTY; PACKETS]),
            weights: Box::new([[S::rounded(1.0); LANES]; PACKETS]),
            len: 0,
            waiting: Waiting {
                rays: RayPacket::EMPTY,
                weight: [S::ZERO; LANES],
                k: [S::ZERO; LANES],
                parents: [0; LANES],
            },
        }
    }

    #[inline(always)]
    pub(crate) fn len(&self) -> usize {
        self.len
    }

    #[inline(always)]
    pub(crate) fn packets(&self) -> &[RayPacket<S>] {
        &self.packets[..self.len]
    }

    #[inline(always)]
    pub(crate) fn packet(&self, i: usize) -> &RayPacket<S> {
        &self.packets[i % PACKETS]
    }

    #[inline(always)]
    pub(crate) fn weight(&self, i: usize) -> &[S; LANES] {
        &self.weights[i % PACKETS]
    }

    #[inline(always)]
    pub(crate) fn clear(&mut self) {
        self.len = 0;
    }

    /// A further packet of eye rays, in a wave that holds no others: weights stay 1.
    #[inline(always)]
    pub(crate) fn push_eye<L: Lanes<Scalar = S>>(&mut self, direction: Vec3<L>, live: usize) {
        debug_assert!(self.len < PACKETS);
        let packet = &mut self.packets[self.len % PACKETS];
        packet.direction = direction.to_arrays();
        packet.live = live as u32;
        self.len += 1;
    }

    /// Eight rays that left one packet lane by lane.
    #[inline(always)]
    pub(crate) fn push_packet<L: Lanes<Scalar = S>>(
        &mut self,
        rays: &Mirrored<L>,
        parent: usize,
        pending: &mut [Pending<S>],
    ) {
        let pending = self.push(rays, pending);
        pending.parents[0] = (parent * LANES) as Slot;
        pending.side_by_side = true;
    }

    /// Those of eight rays that go on; `parents` are their slots.
    #[inline(always)]
    pub(crate) fn push_lanes<L: Lanes<Scalar = S>>(
        &mut self,
        rays: &Mirrored<L>,
        goes_on: Mask<L>,
        parents: &[Slot; LANES],
        pending: &mut [Pending<S>],
    ) {
        if goes_on.all() {
            let pending = self.push(rays, pending);
            pending.parents = *parents;
            pending.side_by_side = false;
            return;
        }
        let (origin, direction) = (rays.origin.to_arrays(), rays.direction.to_arrays());
        #[expect(clippy::manual_map, reason = "a closure may be left as a call in the kernel")]
        let weight = match rays.weight {
            Some(weight) => Some(weight.to_array()),
            None => None,
        };
        let mut lanes = goes_on.bits();
        while lanes != 0 {
            let from = lanes.trailing_zeros() as usize % LANES;
            lanes &= lanes - 1;
            let to = self.waiting.rays.live as usize % LANES;
            for axis in 0..3 {
                self.waiting.rays.origin[axis][to] = origin[axis][from];
                self.waiting.rays.direction[axis][to] = direction[axis][from];
            }
            self.waiting.rays.left[to] = S::from_index(rays.left);
            if let Some(weight) = &weight {
                self.waiting.weight[to] = weight[from];
            }
            self.waiting.k[to] = rays.k;
            self.waiting.parents[to] = parents[from];
            self.waiting.rays.live += 1;
            if self.waiting.rays.live as usize == LANES {
                self.push_waiting::<L>(pending);
            }
        }
    }

    /// Ends the level: rays wait no longer.
    #[inline(always)]
    pub(crate) fn close<L: Lanes<Scalar = S>>(&mut self, pending: &mut [Pending<S>]) {
        if self.waiting.rays.live > 0 {
            self.push_waiting::<L>(pending);
        }
    }

    /// Adds eight rays that left one primitive, and what is owed to them.
    #[inline(always)]
    fn push<'a, L: Lanes<Scalar = S>>(
        &mut self,
        rays: &Mirrored<L>,
        pending: &'a mut [Pending<S>],
    ) -> &'a mut Pending<S> {
        debug_assert!(self.len < PACKETS);
        let packet = &mut self.packets[self.len % PACKETS];
        packet.origin = rays.origin.to_arrays();
        packet.direction = rays.direction.to_arrays();
        packet.left = L::index(rays.left).to_array();
        packet.all_left = rays.left;
        packet.live = LANES as u32;
        if let Some(weight) = rays.weight {
            self.weights[self.len % PACKETS] = weight.to_array();
        }
        let pending = &mut pending[self.len];
        pending.k = L::splat(rays.k).to_array();
        pending.live = LANES as u32;
        self.len += 1;
        pending
    }

    #[inline(always)]
    fn push_waiting<L: Lanes<Scalar = S>>(&mut self, pending: &mut [Pending<S>]) {
        let Waiting { rays, weight, k, parents } = &mut self.waiting;
        debug_assert!(self.len < PACKETS);
        let packet = &mut self.packets[self.len % PACKETS];
        packet.origin = Vec3::<L>::from_arrays(&rays.origin).to_arrays();
        packet.direction = Vec3::<L>::from_arrays(&rays.direction).to_arrays();
        packet.left = L::from_array(rays.left).to_array();
        packet.all_left = NONE;
        packet.live = rays.live;
        self.weights[self.len % PACKETS] = L::from_array(*weight).to_array();
        let pending = &mut pending[self.len];
        (pending.k, pending.parents, pending.side_by_side) = (*k, *parents, false);
        pending.live = rays.live;
        rays.live = 0;
        self.len += 1;
    }
}
