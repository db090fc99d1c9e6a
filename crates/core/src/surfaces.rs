//! Where the rays of a level met one primitive.

use glam::DVec3;

use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::nearest::{Form, Found, Nearest};
use crate::occluders::POINT;
use crate::packet::Rays;
use crate::plane::PACKETS;
use crate::singles::Singles;
use crate::stack::Owed;
use crate::vec3::{Packed, Vec3};
use crate::wave::Wave;

/// Eight places at most; lanes without one repeat the first.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
pub(crate) struct Surface<S> {
    /// Where they are, from the form's anchor.
    pub(crate) arm: Packed<S>,
    /// Which rays came there.
    pub(crate) rays: [Owed; LANES],
    /// Of rays that are no packet, their directions; a packet's are in its wave.
    pub(crate) direction: Packed<S>,
    /// And how many they are.
    pub(crate) live: u32,
}

/// Room for the surfaces of one primitive.
pub(crate) struct Surfaces<S> {
    list: Vec<Surface<S>>,
    len: usize,
    singles: Singles,
    least: Packed<S>,
    most: Packed<S>,
}

/// What rays of a level have met, to be collected.
pub(crate) struct Met<'a, S> {
    pub(crate) wave: &'a Wave<S>,
    pub(crate) nearest: &'a Nearest<S>,
    pub(crate) found: Found,
}

impl<S: Lane> Surfaces<S> {
    pub(crate) fn new() -> Self {
        let empty = [[S::ZERO; LANES]; 3];
        let rays = [Owed::NOTHING; LANES];
        let surface = Surface { arm: empty, rays, direction: empty, live: 0 };
        Self {
            list: vec![surface; PACKETS],
            len: 0,
            singles: Singles::new(),
            least: empty,
            most: empty,
        }
    }

    #[inline(always)]
    pub(crate) fn all(&self) -> &[Surface<S>] {
        &self.list[..self.len]
    }

    /// Collects all places where the primitive of that form was met; how many rays met it.
    ///
    /// A packet all of whose rays did is a surface as it is. Rays of other packets are put together
    /// to eights.
    ///
    /// There are no more surfaces than packets: so many packets met it whole, and the single rays
    /// come from others, eight of them at most. The list does not end before them.
    #[inline(always)]
    pub(crate) fn collect<L: Lanes<Scalar = S>, F: Form<L>>(
        &mut self,
        form: F,
        met: Met<S>,
    ) -> u64 {
        let (least, most) = (L::constant(f64::INFINITY), L::constant(f64::NEG_INFINITY));
        let mut bounds = [Vec3::all(least), Vec3::all(most)];
        let mut list = self.list.iter_mut();
        let mut len = 0;
        let mut hits = 0;
        self.singles.clear();
        let Found { index, mut packets } = met.found;
        while packets != 0 {
            let packet = packets.trailing_zeros() as usize;
            packets &= packets - 1;
            let lanes = met.nearest.index.packet::<L>(packet).same_bits(L::index(index)).bits();
            hits += u64::from(lanes.count_ones());
            if lanes != Mask::<L>::ALL {
                self.singles.add(packet, lanes);
                continue;
            }
            let Some(at) = list.next() else { break };
            len += 1;
            at.rays = Owed::to_packet(packet);
            let rays = met.wave.rays(packet);
            at.fill::<L, F>(form, &rays, met.nearest.distance.packet(packet), &mut bounds);
        }
        self.singles.fill_up();
        for group in 0..self.singles.groups() {
            let Some(at) = list.next() else { break };
            len += 1;
            let (single, live) = self.singles.group(group);
            let slots = |lane: usize| single[lane] as usize;
            (at.rays, at.live) = (Owed::to_rays(&single), live as u32);
            let rays = met.wave.gather(slots);
            at.direction = rays.direction.to_arrays();
            at.fill::<L, F>(form, &rays, met.nearest.distance.gather(slots), &mut bounds);
        }
        self.len = len;
        (self.least, self.most) = (bounds[0].to_arrays(), bounds[1].to_arrays());
        hits
    }

    /// Centre, a point of the scalar, and radius of a ball that holds all points, and all that they
    /// were rounded from. `anchor` is where arms start.
    #[inline(always)]
    pub(crate) fn bounds(&self, anchor: DVec3) -> (DVec3, f64) {
        let (mut center, mut corner) = (DVec3::ZERO, DVec3::ZERO);
        for axis in 0..3 {
            let (mut least, mut most) = (self.least[axis][0], self.most[axis][0]);
            for lane in 1..LANES {
                let (a, b) = (self.least[axis][lane], self.most[axis][lane]);
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

impl<S: Lane> Surface<S> {
    /// Where rays met a primitive; widens the bounds of its arms.
    ///
    /// An arm of NaN, which no lamp reaches, changes no bound: of it and a number the second is
    /// taken.
    #[inline(always)]
    fn fill<L: Lanes<Scalar = S>, F: Form<L>>(
        &mut self,
        form: F,
        rays: &Rays<L>,
        distance: L,
        bounds: &mut [Vec3<L>; 2],
    ) {
        let arm = form.arm(rays, distance);
        self.arm = arm.to_arrays();
        *bounds = [arm.least(bounds[0]), arm.most(bounds[1])];
    }
}
