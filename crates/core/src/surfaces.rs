//! Where the rays of a level met one primitive.

use glam::DVec3;

use crate::hits::{Hits, Singles};
use crate::lanes::{LANES, Lane, Lanes};
use crate::nearest::{Form, Nearest};
use crate::packet::Rays;
use crate::plane::{PACKETS, Slot};
use crate::vec3::{Packed, Vec3};
use crate::wave::Wave;

/// Eight places at most; lanes without one repeat the first.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct Surface<S> {
    /// What the form makes points and normals of.
    pub(crate) place: Packed<S>,
    /// Of single rays, their directions; a packet's are in its wave.
    pub(crate) direction: Packed<S>,
    pub(crate) rays: Origin,
}

/// Which rays came there.
#[derive(Clone, Copy)]
pub(crate) enum Origin {
    /// A packet, lane by lane.
    Packet(usize),
    /// So many single rays, the others repeat the first.
    Single([Slot; LANES], usize),
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
    pub(crate) hits: &'a mut Hits,
    pub(crate) index: u32,
}

impl<S: Lane> Surfaces<S> {
    pub(crate) fn new() -> Self {
        let empty = [[S::ZERO; LANES]; 3];
        let surface = Surface { place: empty, direction: empty, rays: Origin::Packet(0) };
        Self {
            list: vec![surface; PACKETS],
            len: 0,
            singles: Singles::new(),
            least: empty,
            most: empty,
        }
    }

    pub(crate) fn all(&self) -> &[Surface<S>] {
        &self.list[..self.len]
    }

    /// Collects all places where the primitive of that form was met.
    ///
    /// There are no more of them than packets: so many packets met it whole, and the single rays
    /// come from others, eight of them at most. The list does not end before them.
    #[inline(always)]
    pub(crate) fn collect<L: Lanes<Scalar = S>, F: Form<S>>(&mut self, form: F, met: Met<S>) {
        let mut least = Vec3::all(L::constant(f64::INFINITY));
        let mut most = Vec3::all(L::constant(f64::NEG_INFINITY));
        let mut list = self.list.iter_mut();
        let mut len = 0;
        let mut next = met.hits.take_packets(met.index);
        while let Some(packet) = next {
            let Some(at) = list.next() else { break };
            next = met.hits.next_packet(packet);
            len += 1;
            at.rays = Origin::Packet(packet);
            let rays = met.wave.rays(packet);
            let point = at.fill::<L, F>(form, &rays, met.nearest.distance.packet(packet));
            (least, most) = (least.least(point), most.most(point));
        }
        met.hits.take_singles(met.index, &mut self.singles);
        for group in 0..self.singles.groups() {
            let Some(at) = list.next() else { break };
            len += 1;
            let (slots, live) = self.singles.group(group);
            at.rays = Origin::Single(slots, live);
            let rays = met.wave.gather(&slots);
            at.direction = rays.direction.to_arrays();
            let point = at.fill::<L, F>(form, &rays, met.nearest.distance.gather(&slots));
            (least, most) = (least.least(point), most.most(point));
        }
        self.len = len;
        (self.least, self.most) = (least.to_arrays(), most.to_arrays());
    }

    /// Centre, a point of the scalar, and radius of a ball that holds all points.
    #[inline(always)]
    pub(crate) fn bounds(&self) -> (DVec3, f64) {
        let (mut center, mut corner) = (DVec3::ZERO, DVec3::ZERO);
        for axis in 0..3 {
            let (mut least, mut most) = (self.least[axis][0], self.most[axis][0]);
            for lane in 1..LANES {
                let (a, b) = (self.least[axis][lane], self.most[axis][lane]);
                least = if a < least { a } else { least };
                most = if b > most { b } else { most };
            }
            let (least, most) = (least.to_f64(), most.to_f64());
            center[axis] = S::rounded((least + most) * 0.5).to_f64();
            let (below, above) = (center[axis] - least, most - center[axis]);
            corner[axis] = if below > above { below } else { above };
        }
        (center, corner.length())
    }
}

impl<S: Lane> Surface<S> {
    /// Where rays met a primitive; the points.
    #[inline(always)]
    fn fill<L: Lanes<Scalar = S>, F: Form<S>>(
        &mut self,
        form: F,
        rays: &Rays<L>,
        distance: L,
    ) -> Vec3<L> {
        let place = form.place(rays, distance);
        self.place = place.to_arrays();
        form.surface(place, rays.direction).0
    }
}
