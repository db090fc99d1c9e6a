//! The nearest hit: the primitive that each ray of a bounce meets first.
//!
//! Primitives are tested one after another, each on all packets, so that its constants stay in
//! registers. They are tested in the order of their index and only a smaller distance replaces:
//! the first of equals wins. A distance of NaN is not smaller.

use std::ops::Range;

use catoptric_scene::Compiled;

use crate::ray::{Column, Distance, NONE, PACKETS, RayQueue, Rays};
use crate::shape::{Foot, Shape, ShapeVisitor, dispatch};
use crate::simd::{LANES, Lane, Lanes, Mask, Vec3};

/// What each ray of a queue meets first.
pub(crate) struct NearestHits<S> {
    /// Index of the primitive, or [`NONE`].
    pub(crate) index: Column<S>,
    pub(crate) distance: Column<S>,
    /// Scratch: the feet of the perpendiculars, for the sphere under test; see [`Foot`].
    feet: Column<S>,
    discriminants: Column<S>,
    /// One more than there are primitives: one is written before it is known whether it counts.
    met: Vec<MetPrimitive>,
    met_len: usize,
}

/// A primitive that some rays may meet first.
#[derive(Clone, Copy)]
pub(crate) struct MetPrimitive {
    pub(crate) index: u32,
    /// Packets in which it may be the nearest, packet i as bit i; in no others is it.
    pub(crate) packets: u64,
}

const _: () = assert!(PACKETS == u64::BITS as usize);

/// Finds what some packets of a queue meet first, among `candidates`. `EYE`: all rays start at the
/// eye.
#[inline(always)]
pub(crate) fn find_nearest<L: Lanes, const EYE: bool>(
    scene: &Compiled<L::Scalar>,
    candidates: &[u32],
    queue: &RayQueue<L::Scalar>,
    packets: Range<usize>,
    hits: &mut NearestHits<L::Scalar>,
) {
    let (indices, distances) = (&mut hits.index, &mut hits.distance);
    let indices = indices.packets_mut(packets.clone());
    for (index, distance) in indices.iter_mut().zip(distances.packets_mut(packets.clone())) {
        *index = L::index(NONE).to_array();
        *distance = L::constant(f64::INFINITY).to_array();
    }
    hits.met_len = 0;
    for &index in candidates {
        let test = Test::<_, EYE> { index, queue, packets: packets.clone(), hits };
        let shape = &scene.primitives[index as usize].shape;
        let packets = dispatch::<L, _, true>(shape, test);
        hits.met[hits.met_len] = MetPrimitive { index, packets };
        hits.met_len += usize::from(packets != 0);
    }
}

/// The test of one primitive; it finds the packets in which some ray may meet it.
struct Test<'a, S, const EYE: bool> {
    index: u32,
    queue: &'a RayQueue<S>,
    packets: Range<usize>,
    hits: &'a mut NearestHits<S>,
}

impl<S: Lane, L: Lanes<Scalar = S>, const EYE: bool> ShapeVisitor<L> for Test<'_, S, EYE> {
    type Output = u64;

    /// Tests all packets, run by run.
    #[inline(always)]
    fn visit<F: Shape<L>>(mut self, shape: F) -> u64 {
        if EYE {
            return self.one_pass::<L, F, false>(shape, self.packets.clone(), Mask::none());
        }
        let mut met = 0;
        let mut start = self.packets.start;
        for run in self.queue.runs() {
            let packets = start..self.packets.end.min(run.end as usize);
            if packets.is_empty() {
                continue;
            }
            start = packets.end;
            if F::SKIPS_SELF && run.from == self.index {
                continue;
            }
            met |= match (F::TWO_PASSES, run.from == NONE) {
                (true, true) => self.two_passes::<L, F, true>(shape, packets),
                (true, false) => self.two_passes::<L, F, false>(shape, packets),
                (false, true) => self.one_pass::<L, F, true>(shape, packets, Mask::none()),
                (false, false) => {
                    let on_self = if run.from == self.index { Mask::every() } else { Mask::none() };
                    self.one_pass::<L, F, false>(shape, packets, on_self)
                }
            };
        }
        met
    }
}

impl<S: Lane, const EYE: bool> Test<'_, S, EYE> {
    /// Tests some packets, of which the lanes `on_self` left this primitive; `MIXED`: which did is
    /// looked up.
    #[inline(always)]
    fn one_pass<L: Lanes<Scalar = S>, F: Shape<L>, const MIXED: bool>(
        &mut self,
        shape: F,
        packets: Range<usize>,
        on_self: Mask<L>,
    ) -> u64 {
        let (first, len) = (packets.start, packets.len());
        let index = L::index(self.index);
        let tested = RaySlice::of(self.queue, packets.clone());
        let indices = &mut self.hits.index.packets_mut(packets.clone())[..len];
        let distances = &mut self.hits.distance.packets_mut(packets)[..len];
        let mut met = 0;
        for i in 0..len {
            let mut rays = Rays { origin: Vec3::zero(), direction: tested.direction::<L>(i) };
            if !EYE {
                rays.origin = tested.origin(i);
            }
            let on_self = if MIXED {
                tested.from::<L>(i).same_bits(index)
            } else if F::SKIPS_SELF {
                Mask::none()
            } else {
                on_self
            };
            if let Some(distance) = shape.distance::<EYE>(&rays, on_self) {
                met |= 1 << i;
                take(index, distance, &mut indices[i], &mut distances[i]);
            }
        }
        met << first
    }

    /// [`Test::one_pass`] for spheres, in two passes, because the branch "any lane meets it" is
    /// unpredictable: mark the packets that meet it, then finish only those.
    #[inline(always)]
    fn two_passes<L: Lanes<Scalar = S>, F: Shape<L>, const MIXED: bool>(
        &mut self,
        shape: F,
        packets: Range<usize>,
    ) -> u64 {
        let (first, len) = (packets.start, packets.len());
        let index = L::index(self.index);
        let tested = RaySlice::of(self.queue, packets.clone());
        let NearestHits { index: indices, distance: distances, feet, discriminants, .. } =
            &mut *self.hits;
        // First pass: where each ray passes the sphere, and in which packets some ray meets it.
        let feet_of_run = &mut feet.packets_mut(packets.clone())[..len];
        let discriminants_of_run = &mut discriminants.packets_mut(packets)[..len];
        let mut met = 0;
        for i in (0..len).rev() {
            let rays = Rays { origin: tested.origin::<L>(i), direction: tested.direction(i) };
            let Some(mut foot) = shape.foot(&rays) else { return 0 };
            if MIXED {
                foot = foot.without(tested.from::<L>(i).same_bits(index));
            }
            feet_of_run[i] = foot.b.to_array();
            discriminants_of_run[i] = foot.discriminant.to_array();
            met = met * 2 + u64::from(foot.met().any());
        }
        // Second pass: distances, in those packets alone.
        let met = met << first;
        let mut rest = met;
        while rest != 0 {
            let packet = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let foot =
                Foot { b: feet.packet::<L>(packet), discriminant: discriminants.packet(packet) };
            take(index, foot.near(), indices.packet_mut(packet), distances.packet_mut(packet));
        }
        met
    }
}

/// Replaces what a packet meets first where a primitive is nearer.
#[inline(always)]
fn take<L: Lanes>(
    index: L,
    found: Distance<L>,
    indices: &mut [L::Scalar; LANES],
    distances: &mut [L::Scalar; LANES],
) {
    let best = L::from_array(*distances);
    let closer = found.met & found.t.lt(best);
    *distances = closer.replace(found.t, best).to_array();
    *indices = closer.replace(index, L::from_array(*indices)).to_array();
}

/// Packets of rays, as slices of one length: then no bound is checked in a loop over them.
struct RaySlice<'a, S> {
    origins: [&'a [[S; LANES]]; 3],
    directions: [&'a [[S; LANES]]; 3],
    from: &'a [[S; LANES]],
}

impl<'a, S: Lane> RaySlice<'a, S> {
    #[inline(always)]
    fn of(queue: &'a RayQueue<S>, packets: Range<usize>) -> Self {
        let len = packets.len();
        let [ox, oy, oz] = queue.origins().packets(packets.clone());
        let [dx, dy, dz] = queue.directions().packets(packets.clone());
        Self {
            origins: [&ox[..len], &oy[..len], &oz[..len]],
            directions: [&dx[..len], &dy[..len], &dz[..len]],
            from: &queue.from().packets(packets)[..len],
        }
    }

    #[inline(always)]
    fn origin<L: Lanes<Scalar = S>>(&self, i: usize) -> Vec3<L> {
        let [x, y, z] = self.origins;
        Vec3 { x: L::from_array(x[i]), y: L::from_array(y[i]), z: L::from_array(z[i]) }
    }

    #[inline(always)]
    fn direction<L: Lanes<Scalar = S>>(&self, i: usize) -> Vec3<L> {
        let [x, y, z] = self.directions;
        Vec3 { x: L::from_array(x[i]), y: L::from_array(y[i]), z: L::from_array(z[i]) }
    }

    /// What each ray left.
    #[inline(always)]
    fn from<L: Lanes<Scalar = S>>(&self, i: usize) -> L {
        L::from_array(self.from[i])
    }
}

impl<S: Lane> NearestHits<S> {
    /// Room for a scene with so many primitives.
    pub(crate) fn new(primitives: usize) -> Self {
        Self {
            index: Column::of(S::ZERO),
            distance: Column::of(S::ZERO),
            feet: Column::of(S::ZERO),
            discriminants: Column::of(S::ZERO),
            met: vec![MetPrimitive { index: NONE, packets: 0 }; primitives + 1],
            met_len: 0,
        }
    }

    /// Lets lanes without a ray meet nothing.
    #[inline(always)]
    pub(crate) fn forget_idle<L: Lanes<Scalar = S>>(
        &mut self,
        queue: &RayQueue<S>,
        packets: Range<usize>,
    ) {
        for packet in packets {
            let live = Mask::first(queue.live(packet));
            let index = self.index.packet(packet);
            self.index.put(packet, live.replace(index, L::index(NONE)));
        }
    }

    /// The primitives that some rays may meet first, in ascending order.
    #[inline(always)]
    pub(crate) fn met(&self) -> &[MetPrimitive] {
        &self.met[..self.met_len]
    }
}
