//! The packet loop.
//!
//! The plain algorithm is `reference::trace`:
//!
//! ```text
//! trace(ray, weight, depth):
//!     if ray meets nothing: return background
//!     local = ambient + lamps
//!     if mirror is followed: return local + k · trace(mirrored ray, weight · k, depth + 1)
//!     return local
//! ```
//!
//! This file departs from it as follows, and no bit changes:
//!
//! 1. Eight rays go side by side, as a packet. Each lane does what the recursion does for its
//!    ray, in the same order; operations are the same in a lane as on a scalar (`lanes`). A lane
//!    without a ray does over again what another one does.
//! 2. All rays of a tile go side by side, level by level: those of one depth are a wave
//!    (`wave`). No ray knows of another, so their order is free. What a wave met is taken
//!    primitive by primitive (`surfaces`) and lit lamp by lamp (`light`), so that all that depends on
//!    the primitive, the lamp or what stands before it is a scalar, as it is in the recursion; and
//!    the rays that go on are packed anew.
//! 3. The call becomes a loop. On the way down every level leaves behind what it owes on the
//!    return: for each ray that met something the local light, whose it is and k (`stack`).
//! 4. The return becomes a second loop that folds back, colour = local + k · colour, from the
//!    deepest level up: the sum that the recursion forms, in its order. Adding weight · local on
//!    the way down would be the same sum only in the reals.
//! 5. A level keeps something of all its rays, which would take too much memory where they go
//!    deep together. From level [`BREADTH`] on each packet goes to the end of its path before
//!    the next one does.

use std::ops::Range;

use catoptric_scene::{Compiled, DepthCount, PointLight, Scalar};

use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::nearest::{Nearest, nearest};
use crate::occluders::Occluders;
use crate::plane::PACKETS;
use crate::shade::{Level, Shading, shade};
use crate::stack::Stack;
use crate::tile::{self, Across};
use crate::vec3::{Packed, Vec3};
use crate::watch::Watcher;
use crate::wave::Wave;

/// No primitive.
pub(crate) const NONE: u32 = u32::MAX;

/// The last level at which the rays of a tile go side by side.
pub(crate) const BREADTH: usize = 1024;

/// Eight rays in flight. Units: directions have length 1, up to rounding.
#[derive(Clone, Copy)]
pub(crate) struct Rays<L> {
    pub(crate) origin: Vec3<L>,
    pub(crate) direction: Vec3<L>,
}

/// How far eight rays are from one primitive.
pub(crate) struct Distance<L> {
    /// NaN where there is no root.
    pub(crate) t: L,
    /// False where the primitive does not count: met from behind, or just left.
    pub(crate) met: Mask<L>,
}

/// The primitives that are tried, in ascending order; a ray would miss all others.
#[derive(Clone, Copy)]
pub(crate) struct Candidates<'a> {
    /// By the eye rays of a tile.
    pub(crate) eye: &'a [u32],
    /// By mirrored rays.
    pub(crate) mirrors: &'a [u32],
}

/// What tracing reads.
#[derive(Clone, Copy)]
pub(crate) struct World<'a, S: Scalar> {
    pub(crate) scene: &'a Compiled<S>,
    pub(crate) candidates: Candidates<'a>,
    pub(crate) occluders: &'a Occluders<S>,
    /// The scene's lamps, but hidden: what they are to a primitive that sends back no lamp's light.
    pub(crate) hidden: &'a [PointLight<S>],
    /// Reflections followed.
    pub(crate) depth: u32,
    pub(crate) omit: Omit,
}

/// What of a plan's omissions is asked for while tracing.
#[derive(Clone, Copy)]
pub(crate) struct Omit {
    pub(crate) occluders: bool,
    pub(crate) directions: bool,
    pub(crate) shadows: bool,
}

/// What a thread keeps from tile to tile.
pub(crate) struct Work<S> {
    /// Eye rays; those of odd and of even levels; and those of level `BREADTH`.
    pub(crate) waves: [Box<Wave<S>>; 4],
    pub(crate) nearest: Box<Nearest<S>>,
    shading: Shading<S>,
    /// What of a tile's eye rays depends on the column.
    pub(crate) across: [Across<S>; tile::WIDTH / LANES],
    /// Sums of samples.
    pub(crate) sums: Box<[Packed<S>; PACKETS]>,
}

/// A path went deeper than the memory limit allows.
pub(crate) struct TooDeep;

/// The light that comes back along eye rays, those of `waves[0]`: in the stack's `eye_colours`.
/// `watch` sees the first of them go down and come up.
///
/// Down to level `BREADTH` all packets of a level are traced at once; there, one: packet 0 goes
/// to the end of its path and is folded back to this level, then packet 1, and so on; the wave of
/// this level, `waves[3]`, is not written meanwhile. When its last packet is back, folding goes
/// on to level 0.
#[inline(always)]
pub(crate) fn trace<L: Lanes>(
    world: World<L::Scalar>,
    work: &mut Work<L::Scalar>,
    stack: &mut Stack<L::Scalar>,
    mut watch: Option<&mut Watcher<L::Scalar>>,
) -> Result<(), TooDeep> {
    let mut packets = 0..work.waves[0].len();
    stack.start();
    // The first packet of level `BREADTH` that has not gone on.
    let mut held = 0;
    loop {
        let depth = stack.depth();
        if depth == BREADTH {
            held = packets.end;
        }
        let next = level::<L>(world, packets, work, stack)?;
        if let Some(watch) = watch.as_mut() {
            watch.level(work, stack, next);
        }
        if next > 0 {
            stack.descend();
            packets = if depth + 1 == BREADTH { 0..1 } else { 0..next };
            continue;
        }
        loop {
            if let Some(watch) = watch.as_mut() {
                watch.before_fold(stack);
            }
            stack.fold::<L>(&world.scene.materials, world.scene.background);
            if let Some(watch) = watch.as_mut() {
                watch.after_fold(stack);
            }
            if stack.depth() == 0 {
                return Ok(());
            }
            if stack.depth() == BREADTH && held < work.waves[wave_of(BREADTH)].len() {
                break;
            }
            stack.ascend();
        }
        // The next packet's path may be long, and the picture already lost.
        if stack.is_refused() {
            return Err(TooDeep);
        }
        packets = held..held + 1;
    }
}

/// Which of the waves holds the rays of a level.
#[inline(always)]
pub(crate) fn wave_of(depth: usize) -> usize {
    match depth {
        0 => 0,
        BREADTH => 3,
        _ => 1 + depth % 2,
    }
}

/// Traces packets of the level in flight as far as the surfaces they meet. The rays that go on
/// are the next wave; how many packets that is.
#[inline(always)]
fn level<L: Lanes>(
    world: World<L::Scalar>,
    packets: Range<usize>,
    work: &mut Work<L::Scalar>,
    stack: &mut Stack<L::Scalar>,
) -> Result<usize, TooDeep> {
    let depth = stack.depth();
    let Ok([wave, next]) = work.waves.get_disjoint_mut([wave_of(depth), wave_of(depth + 1)]) else {
        unreachable!("two waves");
    };
    let count = DepthCount { rays: wave.count(packets.clone()), ..DepthCount::default() };
    if !stack.make_room(count.rays as usize) {
        return Err(TooDeep);
    }
    next.clear();

    let Candidates { eye, mirrors } = world.candidates;
    if depth == 0 {
        nearest::<L, true>(world.scene, eye, wave, packets.clone(), &mut work.nearest);
    } else {
        nearest::<L, false>(world.scene, mirrors, wave, packets.clone(), &mut work.nearest);
    }

    if count.rays < (packets.len() * LANES) as u64 {
        // Of mirrored rays, only the last packet has idle lanes.
        let start = if depth == 0 { packets.start } else { packets.end - 1 };
        work.nearest.forget_idle::<L>(wave, start..packets.end);
    }

    let followed = depth < world.depth as usize;
    let cut = world.scene.min_weight > L::Scalar::ZERO;
    let mut level = Level { wave, nearest: &work.nearest, stack, next, followed, cut, count };
    for &found in work.nearest.found() {
        shade::<L>(world, found, &mut level, &mut work.shading);
    }
    level.next.close::<L>(level.stack);

    let Level { stack, next, count, .. } = level;
    if count.hits < count.rays {
        stack.missed(packets.start, packets.len());
    }
    stack.count().add(count);
    Ok(next.len())
}

impl<S: Lane> Work<S> {
    /// For a scene with so many occluders before each lamp.
    pub(crate) fn new(scene: &Compiled<S>, occluders: usize) -> Self {
        Self {
            waves: std::array::from_fn(|_| Box::new(Wave::new())),
            nearest: Box::new(Nearest::new(scene.primitives.len())),
            shading: Shading::new(occluders, scene.lights.len()),
            across: [Across::EMPTY; tile::WIDTH / LANES],
            sums: Box::new([[[S::ZERO; LANES]; 3]; PACKETS]),
        }
    }
}
