//! Which primitive each ray of a level meets first.
//!
//! Primitives are tried one after another, each on all packets, so that its constants stay in
//! registers. They are tried in the order of their index and only a smaller distance replaces:
//! the first of equals wins. A distance of NaN is not smaller.

use std::ops::Range;

use catoptric_scene::{Compiled, Numerics, Shape};

use crate::ball::{Ball, Foot};
use crate::flat::Flat;
use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::packet::{Distance, NONE, Rays};
use crate::plane::{PACKETS, Plane};
use crate::textbook::{TextbookPlane, TextbookSphere};
use crate::vec3::Vec3;
use crate::wave::Wave;

/// What each ray of a wave meets first.
pub(crate) struct Nearest<S> {
    /// Index of the primitive, or [`NONE`].
    pub(crate) index: Plane<S>,
    pub(crate) distance: Plane<S>,
    /// Of the ball that is tried; see [`Foot`].
    feet: Plane<S>,
    discriminants: Plane<S>,
    /// One more than there are primitives: one is written before it is known whether it counts.
    found: Vec<Found>,
    found_len: usize,
}

/// A primitive that some rays may meet first.
#[derive(Clone, Copy)]
pub(crate) struct Found {
    pub(crate) index: u32,
    /// In which packets it may be the nearest, packet i as bit i; in no others is it.
    pub(crate) packets: u64,
}

const _: () = assert!(PACKETS == u64::BITS as usize);

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
            Shape::Ball(ball) if ball.is_around() => {
                all.run::<L, _, EYE>(Around(Ball::<L>::splat(ball)))
            }
            Shape::Ball(ball) => all.run::<L, _, EYE>(Ball::<L>::splat(ball)),
            Shape::Flat(flat) if flat.is_around() => {
                all.run::<L, _, EYE>(Around(Flat::<L>::splat(flat)))
            }
            Shape::Flat(flat) => all.run::<L, _, EYE>(Flat::<L>::splat(flat)),
            Shape::TextbookSphere(sphere) => {
                all.run::<L, _, EYE>(TextbookSphere::<L>::splat(sphere))
            }
            Shape::TextbookPlane(plane) => all.run::<L, _, EYE>(TextbookPlane::<L>::splat(plane)),
        };
        nearest.found[nearest.found_len] = Found { index, packets };
        nearest.found_len += usize::from(packets != 0);
    }
}

/// What eight rays may meet: the constants of a form, lane by lane.
pub(crate) trait Form<L: Lanes>: Copy {
    /// The formulas that it belongs to.
    const NUMERICS: Numerics;
    /// Whether rays that left it do not meet it next, whatever it is computed to be.
    const LEFT_BEHIND: bool;

    /// The ball that it is, if it is one that is not around the eye.
    #[inline(always)]
    fn ball(&self) -> Option<&Ball<L>> {
        None
    }

    /// Distances to it, unless all lanes miss it; `own`: the lanes whose ray starts on it. `EYE`:
    /// all rays start at the eye.
    ///
    /// Idle lanes compute what is never read.
    fn distance<const EYE: bool>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>>;

    /// What its points are measured from: a ball's centre, or else the eye.
    #[inline(always)]
    fn anchor(&self) -> Option<Vec3<L>> {
        None
    }

    /// Where rays meet it at distances `t`, from the anchor.
    fn arm(&self, rays: &Rays<L>, t: L) -> Vec3<L>;

    /// Unit normals where rays in `direction` meet it.
    fn normal(&self, arm: Vec3<L>, direction: Vec3<L>) -> Vec3<L>;

    /// The points at the end of arms.
    #[inline(always)]
    fn point(&self, arm: Vec3<L>) -> Vec3<L> {
        match self.anchor() {
            Some(anchor) => anchor + arm,
            None => arm,
        }
    }

    /// A point, relative to the anchor. Less an arm it is the way to it from the arm's end:
    /// `reference::trace::Surface::to`.
    #[inline(always)]
    fn relative(&self, point: Vec3<L>) -> Vec3<L> {
        match self.anchor() {
            Some(anchor) => point - anchor,
            None => point,
        }
    }

    /// Where rays that leave such a point start.
    #[inline(always)]
    fn start(&self, point: Vec3<L>, _normal: Vec3<L>) -> Vec3<L> {
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
    fn run<L: Lanes<Scalar = S>, F: Form<L>, const EYE: bool>(mut self, form: F) -> u64 {
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
            found |= match (form.ball(), run.left == NONE) {
                (Some(ball), true) => self.sift::<L, true>(ball, packets),
                (Some(ball), false) => self.sift::<L, false>(ball, packets),
                (None, true) => self.on::<L, F, false, true>(form, packets, Mask::none()),
                (None, false) => {
                    let own = if run.left == self.index { Mask::every() } else { Mask::none() };
                    self.on::<L, F, false, false>(form, packets, own)
                }
            };
        }
        found
    }

    /// On some packets, of which the lanes `own` left it; `MIXED`: which did is looked up.
    #[inline(always)]
    fn on<L: Lanes<Scalar = S>, F: Form<L>, const EYE: bool, const MIXED: bool>(
        &mut self,
        form: F,
        packets: Range<usize>,
        own: Mask<L>,
    ) -> u64 {
        let (first, len) = (packets.start, packets.len());
        let index = L::index(self.index);
        let tried = Tried::of(self.wave, packets.clone());
        let indices = &mut self.nearest.index.packets_mut(packets.clone())[..len];
        let distances = &mut self.nearest.distance.packets_mut(packets)[..len];
        let mut found = 0;
        for i in 0..len {
            let mut rays = Rays { origin: Vec3::zero(), direction: tried.direction::<L>(i) };
            if !EYE {
                rays.origin = tried.origin(i);
            }
            let own = if MIXED {
                tried.left::<L>(i).same_bits(index)
            } else if F::LEFT_BEHIND {
                Mask::none()
            } else {
                own
            };
            if let Some(distance) = form.distance::<EYE>(&rays, own) {
                found |= 1 << i;
                take(index, distance, &mut indices[i], &mut distances[i]);
            }
        }
        found << first
    }

    /// [`Try::on`] for a ball that rays left elsewhere. Whether some ray of a packet meets it is hard
    /// to foresee, so no branch depends on it: first the packets are found, then only those are gone
    /// through.
    #[inline(always)]
    fn sift<L: Lanes<Scalar = S>, const MIXED: bool>(
        &mut self,
        ball: &Ball<L>,
        packets: Range<usize>,
    ) -> u64 {
        let (first, len) = (packets.start, packets.len());
        let index = L::index(self.index);
        let tried = Tried::of(self.wave, packets.clone());
        let Nearest { index: indices, distance: distances, feet, discriminants, .. } =
            &mut *self.nearest;
        let feet_of_run = &mut feet.packets_mut(packets.clone())[..len];
        let discriminants_of_run = &mut discriminants.packets_mut(packets)[..len];
        let mut found = 0;
        for i in (0..len).rev() {
            let rays = Rays { origin: tried.origin::<L>(i), direction: tried.direction(i) };
            let mut foot = ball.foot(&rays);
            if MIXED {
                foot = foot.without(tried.left::<L>(i).same_bits(index));
            }
            feet_of_run[i] = foot.b.to_array();
            discriminants_of_run[i] = foot.discriminant.to_array();
            found = found * 2 + u64::from(foot.met().any());
        }
        let found = found << first;
        let mut rest = found;
        while rest != 0 {
            let packet = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            let foot =
                Foot { b: feet.packet::<L>(packet), discriminant: discriminants.packet(packet) };
            take(index, foot.near(), indices.packet_mut(packet), distances.packet_mut(packet));
        }
        found
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

/// Packets of rays. Slices of one length: then no bound is checked in a loop over them.
struct Tried<'a, S> {
    origins: [&'a [[S; LANES]]; 3],
    directions: [&'a [[S; LANES]]; 3],
    left: &'a [[S; LANES]],
}

impl<'a, S: Lane> Tried<'a, S> {
    #[inline(always)]
    fn of(wave: &'a Wave<S>, packets: Range<usize>) -> Self {
        let len = packets.len();
        let [ox, oy, oz] = wave.origins().packets(packets.clone());
        let [dx, dy, dz] = wave.directions().packets(packets.clone());
        Self {
            origins: [&ox[..len], &oy[..len], &oz[..len]],
            directions: [&dx[..len], &dy[..len], &dz[..len]],
            left: &wave.left().packets(packets)[..len],
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
    fn left<L: Lanes<Scalar = S>>(&self, i: usize) -> L {
        L::from_array(self.left[i])
    }
}

impl<S: Lane> Nearest<S> {
    /// Of a scene with so many primitives.
    pub(crate) fn new(primitives: usize) -> Self {
        Self {
            index: Plane::of(S::ZERO),
            distance: Plane::of(S::ZERO),
            feet: Plane::of(S::ZERO),
            discriminants: Plane::of(S::ZERO),
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
