//! Where the rays of a level met one primitive.

use catoptric_scene::Numerics;
use glam::DVec3;

use crate::hits::Hits;
use crate::lanes::{LANES, Lane, Lanes};
use crate::nearest::{Form, Nearest};
use crate::packet::Rays;
use crate::vec3::{Packed, Vec3};
use crate::wave::{PACKETS, RayPacket, Slot, Wave};

/// Eight places at most.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct Surface<S> {
    /// The points that are lit.
    pub(crate) point: Packed<S>,
    /// Unit normals.
    pub(crate) normal: Packed<S>,
    /// Directions of the mirrored rays, if anything needs them.
    pub(crate) mirrored: Packed<S>,
    pub(crate) rays: Origin,
}

/// Which rays came there.
#[derive(Clone, Copy)]
pub(crate) enum Origin {
    /// A packet, lane by lane.
    Packet(usize),
    /// So many single rays.
    Single([Slot; LANES], usize),
}

/// Room for the surfaces of one primitive.
pub(crate) struct Surfaces<S> {
    list: Vec<Surface<S>>,
    len: usize,
    gathered: RayPacket<S>,
    distance: [S; LANES],
    least: Packed<S>,
    most: Packed<S>,
}

/// What rays of a level have met, to be collected.
pub(crate) struct Met<'a, S> {
    pub(crate) wave: &'a Wave<S>,
    pub(crate) nearest: &'a [Nearest<S>; PACKETS],
    pub(crate) hits: &'a mut Hits,
    pub(crate) index: u32,
    pub(crate) numerics: Numerics,
    pub(crate) mirrors: bool,
}

impl<S: Lane> Surfaces<S> {
    pub(crate) fn new() -> Self {
        let empty = [[S::ZERO; LANES]; 3];
        let surface =
            Surface { point: empty, normal: empty, mirrored: empty, rays: Origin::Packet(0) };
        Self {
            list: vec![surface; PACKETS],
            len: 0,
            gathered: RayPacket::EMPTY,
            distance: [S::ZERO; LANES],
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
        let (numerics, mirrors) = (met.numerics, met.mirrors);
        while let Some(packet) = met.hits.take_packet(met.index) {
            let Some(at) = list.next() else { break };
            len += 1;
            at.rays = Origin::Packet(packet);
            let distance = &met.nearest[packet % PACKETS].distance;
            let point = at.fill::<L, F>(form, numerics, mirrors, met.wave.packet(packet), distance);
            (least, most) = (least.least(point), most.most(point));
        }
        let mut slots = [0; LANES];
        while let live @ 1.. = met.hits.take_rays(met.index, &mut slots) {
            let Some(at) = list.next() else { break };
            len += 1;
            at.rays = Origin::Single(slots, live);
            // Lanes without a ray repeat the first, which leaves the bounds as they are.
            for to in 0..LANES {
                let slot = slots[if to < live { to } else { 0 }] as usize;
                let (packet, from) = (slot / LANES, slot % LANES);
                let rays = met.wave.packet(packet);
                for axis in 0..3 {
                    self.gathered.origin[axis][to] = rays.origin[axis][from];
                    self.gathered.direction[axis][to] = rays.direction[axis][from];
                }
                self.distance[to] = met.nearest[packet % PACKETS].distance[from];
            }
            let point = at.fill::<L, F>(form, numerics, mirrors, &self.gathered, &self.distance);
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
        numerics: Numerics,
        mirrors: bool,
        rays: &RayPacket<S>,
        distance: &[S; LANES],
    ) -> Vec3<L> {
        let rays = Rays {
            origin: Vec3::from_arrays(&rays.origin),
            direction: Vec3::from_arrays(&rays.direction),
        };
        let (point, normal) = form.surface(&rays, L::from_array(*distance));
        self.point = point.to_arrays();
        self.normal = normal.to_arrays();
        if mirrors {
            self.mirrored = mirrored(numerics, rays.direction, normal).to_arrays();
        }
        point
    }
}

/// d - 2 (d·n) n; robust: made a unit vector again by one Newton step.
#[inline(always)]
fn mirrored<L: Lanes>(numerics: Numerics, d: Vec3<L>, n: Vec3<L>) -> Vec3<L> {
    let v = d - n * (L::constant(2.0) * d.dot(n));
    match numerics {
        Numerics::Robust => v * (L::constant(1.5) - L::constant(0.5) * v.dot(v)),
        Numerics::Textbook => v,
    }
}
