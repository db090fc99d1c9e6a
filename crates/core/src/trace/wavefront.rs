//! The packet loop.
//!
//! The plain algorithm is `reference::trace`:
//!
//! ```text
//! trace(ray, weight, depth):
//!     if ray meets nothing: return background
//!     local = ambient + lights
//!     if mirror is followed: return local + reflectance · trace(reflected ray, weight · reflectance, depth + 1)
//!     return local
//! ```
//!
//! This file departs from it as follows, and no bit changes:
//!
//! 1. Eight rays go side by side, as a packet. Each lane does what the recursion does for its
//!    ray, in the same order; operations are the same in a lane as on a scalar (`simd`). A lane
//!    without a ray does over again what another one does.
//! 2. All rays of a tile go side by side, bounce by bounce: those of one depth are a queue (`ray`).
//!    No ray knows of another, so their order is free. What a queue's rays met is taken primitive
//!    by primitive (`hit_groups`) and lit light by light (`light`), so that all that depends on the
//!    primitive, the light or what stands before it is the same in all lanes; and the rays that go
//!    on are packed anew (`regroup`).
//! 3. The call becomes a loop. On the way down every bounce leaves behind what it owes on the
//!    return: for each ray that met something the local light, whose it is and the mirror
//!    (`stack`).
//! 4. The return becomes a second loop that folds back, colour = local + reflectance · colour, from
//!    the deepest bounce up: the sum that the recursion forms, in its order. Adding weight · local
//!    on the way down would be the same sum only in the reals.
//! 5. A bounce keeps something of all its rays, which would take too much memory where they go
//!    deep together. From bounce [`BREADTH`] on each packet goes to the end of its path before
//!    the next one does.

use std::ops::Range;

use catoptric_scene::{DepthCount, Scalar};

use super::frame::Frame;
use super::nearest::find_nearest;
use super::observe::Observe;
use super::scratch::Scratch;
use super::shade::{InFlight, Shade};
use super::stack::TooDeep;
use crate::ray::{BREADTH, queue_of};
use crate::simd::{LANES, Lanes};

/// Traces the eye rays of queue 0: the light that comes back along them is in the stack's
/// `eye_colours`. `candidates`: the primitives that they are tested against. `observer` sees the
/// first of them go down and come up.
///
/// Down to bounce [`BREADTH`] all packets of a bounce are traced at once; there, one: packet 0 goes
/// to the end of its path and is folded back to this bounce, then packet 1, and so on; the queue of
/// this bounce is not written meanwhile. When its last packet is back, folding goes on to bounce 0.
#[inline(always)]
pub(crate) fn trace<L: Lanes>(
    frame: &Frame<L::Scalar>,
    candidates: &[u32],
    scratch: &mut Scratch<L::Scalar>,
    mut observer: Option<&mut (dyn Observe<L::Scalar> + '_)>,
) -> Result<(), TooDeep> {
    let mut packets = 0..scratch.queues[0].len();
    scratch.stack.start();
    // The first packet of bounce `BREADTH` that has not gone on.
    let mut held = 0;
    loop {
        // Down: one bounce further.
        let bounce = scratch.stack.bounce();
        if bounce == BREADTH {
            held = packets.end;
        }
        let next = trace_bounce::<L>(frame, candidates, packets, scratch)?;
        if let Some(observer) = &mut observer {
            observer.bounce(scratch, next);
        }
        if next > 0 {
            scratch.stack.descend();
            packets = if bounce + 1 == BREADTH { 0..1 } else { 0..next };
            continue;
        }
        // Up: fold, to the eye or to the bounce at which packets are held.
        loop {
            if let Some(observer) = &mut observer {
                observer.before_fold(&scratch.stack);
            }
            scratch.stack.fold::<L>(&frame.scene.materials, frame.scene.background);
            if let Some(observer) = &mut observer {
                observer.after_fold(&scratch.stack);
            }
            if scratch.stack.bounce() == 0 {
                return Ok(());
            }
            if scratch.stack.bounce() == BREADTH && held < scratch.queues[queue_of(BREADTH)].len() {
                break;
            }
            scratch.stack.ascend();
        }
        // The next packet's path may be long, and the picture already lost.
        if scratch.stack.is_refused() {
            return Err(TooDeep);
        }
        packets = held..held + 1;
    }
}

/// Traces packets of the bounce in flight as far as what they meet. The rays that go on are the
/// next queue; how many packets that is.
#[inline(always)]
fn trace_bounce<L: Lanes>(
    frame: &Frame<L::Scalar>,
    candidates: &[u32],
    packets: Range<usize>,
    scratch: &mut Scratch<L::Scalar>,
) -> Result<usize, TooDeep> {
    let Scratch { queues, nearest, shade, regroup, stack, .. } = scratch;
    let bounce = stack.bounce();
    let Ok([queue, next]) = queues.get_disjoint_mut([queue_of(bounce), queue_of(bounce + 1)])
    else {
        unreachable!("two queues");
    };
    let count = DepthCount { rays: queue.count(packets.clone()), ..DepthCount::default() };
    if !stack.make_room(count.rays as usize) {
        return Err(TooDeep);
    }
    next.clear();

    // What each ray meets first.
    if bounce == 0 {
        find_nearest::<L, true>(frame.scene, candidates, queue, packets.clone(), nearest);
    } else {
        let all = frame.tiles.all();
        find_nearest::<L, false>(frame.scene, all, queue, packets.clone(), nearest);
    }
    if count.rays < (packets.len() * LANES) as u64 {
        // Among reflected rays, only the last packet has idle lanes.
        let start = if bounce == 0 { packets.start } else { packets.end - 1 };
        nearest.forget_idle::<L>(queue, start..packets.end);
    }

    // Local light, and the next queue.
    let followed = bounce < frame.depth as usize;
    let cut = frame.scene.min_weight > L::Scalar::ZERO;
    let mut flight = InFlight { queue, nearest, stack, regroup, next, followed, cut, count };
    for &met in nearest.met() {
        Shade { frame, met, flight: &mut flight, scratch: shade }.run::<L>();
    }
    flight.regroup.close::<L>(flight.next, flight.stack);

    // Rays that met nothing take the background when they are folded.
    let InFlight { stack, next, count, .. } = flight;
    if count.hits < count.rays {
        stack.missed(packets.start, packets.len());
    }
    stack.count().add(count);
    Ok(next.len())
}
