//! Which primitive each ray of a level meets first.
//!
//! Primitives are tried one after another, each on all packets, so that its constants stay in
//! registers. They are tried in the order of their index and only a smaller distance replaces:
//! the first of equals wins. A distance of NaN is not smaller.

use catoptric_scene::{Compiled, Shape};

use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::packet::{Distance, NONE, Rays};
use crate::vec3::Vec3;
use crate::wave::RayPacket;

/// Index of the primitive that each ray of a packet meets first, or [`NONE`], and its distance.
#[derive(Clone, Copy)]
#[repr(align(32))]
pub(crate) struct Nearest<S> {
    pub(crate) index: [S; LANES],
    pub(crate) distance: [S; LANES],
}

/// Fills in one of `nearest` for each packet. `EYE`: all rays start at the eye.
#[inline(always)]
pub(crate) fn nearest<L: Lanes, const EYE: bool>(
    scene: &Compiled<L::Scalar>,
    tried: &[u32],
    packets: &[RayPacket<L::Scalar>],
    nearest: &mut [Nearest<L::Scalar>],
) {
    for nearest in &mut *nearest {
        nearest.index = L::index(NONE).to_array();
        nearest.distance = L::constant(f64::INFINITY).to_array();
    }
    for &index in tried {
        let all = Try { index, packets, nearest };
        match &scene.primitives[index as usize].shape {
            Shape::Ball(ball) if ball.is_around() => all.run::<L, _, EYE>(Around(*ball)),
            Shape::Ball(ball) => all.run::<L, _, EYE>(*ball),
            Shape::Flat(flat) if flat.is_around() => all.run::<L, _, EYE>(Around(*flat)),
            Shape::Flat(flat) => all.run::<L, _, EYE>(*flat),
            Shape::TextbookSphere(sphere) => all.run::<L, _, EYE>(*sphere),
            Shape::TextbookPlane(plane) => all.run::<L, _, EYE>(*plane),
        }
    }
}

/// What a ray may meet.
pub(crate) trait Form<S>: Copy {
    /// Whether rays that left it do not meet it next, whatever it is computed to be.
    const LEFT_BEHIND: bool;

    /// Distances to it, unless all lanes miss it; `own`: the lanes whose ray starts on it.
    ///
    /// Idle lanes compute what is never read.
    fn distance<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, own: Mask<L>) -> Option<Distance<L>>;

    /// Points and unit normals where rays meet it at distances `t`.
    fn surface<L: Lanes<Scalar = S>>(&self, rays: &Rays<L>, t: L) -> (Vec3<L>, Vec3<L>);
}

/// A primitive around the eye.
#[derive(Clone, Copy)]
pub(crate) struct Around<F>(pub(crate) F);

/// One primitive to try.
struct Try<'a, S> {
    index: u32,
    packets: &'a [RayPacket<S>],
    nearest: &'a mut [Nearest<S>],
}

impl<S: Lane> Try<'_, S> {
    #[inline(always)]
    fn run<L: Lanes<Scalar = S>, F: Form<S>, const EYE: bool>(self, form: F) {
        let index = L::index(self.index);
        for (packet, nearest) in self.packets.iter().zip(self.nearest) {
            if !EYE && F::LEFT_BEHIND && packet.all_left == self.index {
                continue;
            }
            let direction = Vec3::from_arrays(&packet.direction);
            let origin = if EYE { Vec3::zero() } else { Vec3::from_arrays(&packet.origin) };
            let own = if EYE { Mask::none() } else { L::from_array(packet.left).same_bits(index) };
            let Some(found) = form.distance(&Rays { origin, direction }, own) else {
                continue;
            };
            let best = L::from_array(nearest.distance);
            let closer = found.met & found.t.lt(best);
            nearest.distance = closer.select(found.t, best).to_array();
            nearest.index = closer.select(index, L::from_array(nearest.index)).to_array();
        }
    }
}
