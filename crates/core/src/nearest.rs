//! Which primitive each ray of a level meets first.
//!
//! Primitives are tried one after another, each on all packets, so that its constants stay in
//! registers. They are tried in the order of their index and only a smaller distance replaces:
//! the first of equals wins. A distance of NaN is not smaller.

use std::ops::Range;

use catoptric_scene::{Compiled, Numerics, Shape};

use crate::lanes::{Lane, Lanes, Mask};
use crate::packet::{Distance, NONE, Rays};
use crate::plane::{PACKETS, Plane};
use crate::vec3::Vec3;
use crate::wave::Wave;

/// What each ray of a wave meets first.
pub(crate) struct Nearest<S> {
    /// Index of the primitive, or [`NONE`].
    pub(crate) index: Plane<S>,
    pub(crate) distance: Plane<S>,
    /// One more than there are primitives: one is written before it is known whether it counts.
    found: Vec<Found>,
    found_len: usize,
}

/// A primitive that some rays may meet first.
#[derive(Clone, Copy)]
pub(crate) struct Found {
    pub(crate) index: u32,
    /// In which packets: packet i as bit i. In no others is it the nearest.
    pub(crate) packets: u64,
}

const _: () = assert!(PACKETS <= u64::BITS as usize);

/// Fills in `nearest` for some packets of a wave. `EYE`: all rays start at the eye.
#[inline(always)]
pub(crate) fn nearest<L: Lanes, const EYE: bool>(
    scene: &Compiled<L::Scalar>,
    tried: &[u32],
    wave: &Wave<L::Scalar>,
    packets: Range<usize>,
    nearest: &mut Nearest<L::Scalar>,
) {
    let (indices, distances) = (&mut nearest.index, &mut nearest.distance);
    let indices = indices.packets_mut(packets.clone());
    for (index, distance) in indices.iter_mut().zip(distances.packets_mut(packets.clone())) {
        *index = L::index(NONE).to_array();
        *distance = L::constant(f64::INFINITY).to_array();
    }
    nearest.found_len = 0;
    for &index in tried {
        let all = Try { index, wave, packets: packets.clone(), nearest };
        let packets = match &scene.primitives[index as usize].shape {
            Shape::Ball(ball) if ball.is_around() => all.run::<L, _, EYE>(Around(*ball)),
            Shape::Ball(ball) => all.run::<L, _, EYE>(*ball),
            Shape::Flat(flat) if flat.is_around() => all.run::<L, _, EYE>(Around(*flat)),
            Shape::Flat(flat) => all.run::<L, _, EYE>(*flat),
            Shape::TextbookSphere(sphere) => all.run::<L, _, EYE>(*sphere),
            Shape::TextbookPlane(plane) => all.run::<L, _, EYE>(*plane),
        };
        nearest.found[nearest.found_len] = Found { index, packets };
        nearest.found_len += usize::from(packets != 0);
    }
}

/// What a ray may meet.
pub(crate) trait Form<S>: Copy {
    /// The formulas that it belongs to.
    const NUMERICS: Numerics;
    /// Whether rays that left it do not meet it next, whatever it is computed to be.
    const LEFT_BEHIND: bool;

    /// Distances to it, unless all lanes miss it; `own`: the lanes whose ray starts on it.
    ///
    /// Idle lanes compute what is never read.
    fn distance<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>>;

    /// Where rays meet it at distances `t`: what [`Form::surface`] makes point and normal of.
    fn place<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> Vec3<L>;

    /// Points and unit normals of places where rays in `direction` meet it.
    fn surface<L: Lanes<Scalar = S>>(
        &self,
        place: Vec3<L>,
        direction: Vec3<L>,
    ) -> (Vec3<L>, Vec3<L>);

    /// Where rays that leave such a point start.
    #[inline(always)]
    fn start<L: Lanes<Scalar = S>>(&self, point: Vec3<L>, _normal: Vec3<L>) -> Vec3<L> {
        point
    }
}

/// A primitive around the eye.
#[derive(Clone, Copy)]
pub(crate) struct Around<F>(pub(crate) F);

/// One primitive to try.
struct Try<'a, S> {
    index: u32,
    wave: &'a Wave<S>,
    packets: Range<usize>,
    nearest: &'a mut Nearest<S>,
}

impl<S: Lane> Try<'_, S> {
    /// On all packets, run by run; those in which some ray may meet it.
    #[inline(always)]
    fn run<L: Lanes<Scalar = S>, F: Form<S>, const EYE: bool>(mut self, form: F) -> u64 {
        if EYE {
            return self.on::<L, F, true, false>(form, self.packets.clone(), Mask::none());
        }
        let mut found = 0;
        let mut start = self.packets.start;
        for run in self.wave.runs() {
            let packets = start..self.packets.end.min(run.end as usize);
            if packets.is_empty() {
                continue;
            }
            start = packets.end;
            if F::LEFT_BEHIND && run.left == self.index {
                continue;
            }
            found |= if run.left == NONE {
                self.on::<L, F, false, true>(form, packets, Mask::none())
            } else {
                let own = if run.left == self.index { Mask::every() } else { Mask::none() };
                self.on::<L, F, false, false>(form, packets, own)
            };
        }
        found
    }

    /// On some packets, of which the lanes `own` left it; `MIXED`: which did is looked up.
    #[inline(always)]
    fn on<L: Lanes<Scalar = S>, F: Form<S>, const EYE: bool, const MIXED: bool>(
        &mut self,
        form: F,
        packets: Range<usize>,
        own: Mask<L>,
    ) -> u64 {
        let (first, len) = (packets.start, packets.len());
        let mut found = 0;
        let index = L::index(self.index);
        // Slices of one length: then no bound is checked in the loop.
        let [ox, oy, oz] = self.wave.origins().packets(packets.clone()).map(|plane| &plane[..len]);
        let [dx, dy, dz] =
            self.wave.directions().packets(packets.clone()).map(|plane| &plane[..len]);
        let left = &self.wave.left().packets(packets.clone())[..len];
        let indices = &mut self.nearest.index.packets_mut(packets.clone())[..len];
        let distances = &mut self.nearest.distance.packets_mut(packets)[..len];
        for i in 0..len {
            let rays = Rays {
                origin: if EYE {
                    Vec3::zero()
                } else {
                    Vec3 {
                        x: L::from_array(ox[i]),
                        y: L::from_array(oy[i]),
                        z: L::from_array(oz[i]),
                    }
                },
                direction: Vec3 {
                    x: L::from_array(dx[i]),
                    y: L::from_array(dy[i]),
                    z: L::from_array(dz[i]),
                },
            };
            let own = if MIXED {
                L::from_array(left[i]).same_bits(index)
            } else if F::LEFT_BEHIND {
                Mask::none()
            } else {
                own
            };
            let Some(Distance { t, met }) = form.distance(&rays, own) else {
                continue;
            };
            found |= 1 << i;
            let best = L::from_array(distances[i]);
            let closer = met & t.lt(best);
            distances[i] = closer.replace(t, best).to_array();
            indices[i] = closer.replace(index, L::from_array(indices[i])).to_array();
        }
        found << first
    }
}

impl<S: Lane> Nearest<S> {
    /// Of a scene with so many primitives.
    pub(crate) fn new(primitives: usize) -> Self {
        Self {
            index: Plane::of(S::ZERO),
            distance: Plane::of(S::ZERO),
            found: vec![Found { index: NONE, packets: 0 }; primitives + 1],
            found_len: 0,
        }
    }

    /// Lanes without a ray meet nothing.
    #[inline(always)]
    pub(crate) fn forget_idle<L: Lanes<Scalar = S>>(
        &mut self,
        wave: &Wave<S>,
        packets: Range<usize>,
    ) {
        for packet in packets {
            let live = Mask::first(wave.live(packet));
            let index = self.index.packet(packet);
            self.index.put(packet, live.replace(index, L::index(NONE)));
        }
    }

    #[inline(always)]
    pub(crate) fn found(&self) -> &[Found] {
        &self.found[..self.found_len]
    }
}
