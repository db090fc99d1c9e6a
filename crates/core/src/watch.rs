//! One eye ray's life as the packet loop has it, for those who study it.
//!
//! The loop that is watched is the loop that renders; what watches it is a type parameter, and
//! `()`, which watches nothing, leaves no trace in the compiled kernel.

use catoptric_scene::Compiled;

use crate::lanes::{self, Kernel, Lane, Lanes};
use crate::occluders::Occluders;
use crate::packet::{Candidates, NONE, Omit, TooDeep, Work, World, trace, wave_of};
use crate::render::{Settings, StackFull};
use crate::sight::Sights;
use crate::stack::{Budget, Stack};
use crate::tile::unit;
use crate::vec3::{Packed, Vec3};

/// A level on the way down.
#[derive(Clone, Copy, Debug)]
pub struct Level<S = f32> {
    /// Where the ray starts, relative to the eye.
    pub origin: [S; 3],
    /// Where it goes.
    pub direction: [S; 3],
    /// The product of the mirror factors on the way; `None` without a cut by weight, where the
    /// engine forms none.
    pub weight: Option<S>,
    /// Index of the primitive that it met, and how far along the ray.
    pub met: Option<(u32, S)>,
    /// What was put on the stack: the light from there, or the background.
    pub local: [S; 3],
    /// And the mirror factor, 0 where the mirror is not followed.
    pub k: S,
}

/// A level on the way up: colour = local + k · back.
#[derive(Clone, Copy, Debug)]
pub struct Fold<S = f32> {
    /// What was taken off the stack.
    pub local: [S; 3],
    /// With it.
    pub k: S,
    /// The colour of the level below.
    pub back: [S; 3],
    /// The sum.
    pub colour: [S; 3],
}

/// Sees what happens to one ray of a packet.
pub trait Watch<S = f32> {
    /// Every level of its path on the way down, from the eye.
    fn level(&mut self, level: Level<S>);
    /// Every level on the way up, but for the deepest, which owes nothing.
    fn fold(&mut self, fold: Fold<S>);
}

/// Traces the eye ray through a point of the image plane, alone in its packet; its colour.
///
/// # Errors
/// [`StackFull`] if its path goes too deep for the limit.
pub fn watch(
    scene: &Compiled,
    column: f32,
    row: f32,
    settings: Settings,
    watch: &mut dyn Watch,
) -> Result<[f32; 3], StackFull> {
    let budget = Budget::new(settings.stack_limit);
    let (sights, occluders) = (Sights::new(scene), Occluders::new(scene));
    let world = World {
        scene,
        candidates: Candidates { eye: sights.all(), mirrors: sights.all() },
        occluders: &occluders,
        hidden: &[],
        depth: scene.max_depth,
        omit: Omit { occluders: false, directions: false, shadows: false },
    };
    let (mut work, mut stack) = (Work::new(scene, occluders.len()), Stack::new(&budget));
    let (work, stack) = (&mut work, &mut stack);
    let watched = Watched { world, column, row, work, stack, watch };
    lanes::run(settings.isa, watched).map_err(|TooDeep| StackFull { limit: settings.stack_limit })
}

/// The work of [`watch`].
struct Watched<'a, 'b> {
    world: World<'a, f32>,
    column: f32,
    row: f32,
    work: &'a mut Work<f32>,
    stack: &'a mut Stack<'b, f32>,
    watch: &'a mut dyn Watch,
}

impl Kernel for Watched<'_, '_> {
    type Scalar = f32;
    type Output = Result<[f32; 3], TooDeep>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = f32>>(self) -> Result<[f32; 3], TooDeep> {
        let eye = &self.world.scene.eye;
        let across = Vec3::splat(eye.right) * L::splat(self.column);
        let up = Vec3::splat(eye.up) * L::splat(self.row);
        let wave = &mut self.work.waves[0];
        wave.clear();
        wave.push_eye(unit(Vec3::splat(eye.forward) + across + up), 1);
        let cut = self.world.scene.min_weight > 0.0;
        let mut first = First { watch: self.watch, cut, owed: None };
        trace::<L>(self.world, self.work, self.stack, &mut first)?;
        Ok(first_lane(&self.stack.level()[0].colour))
    }
}

/// What watches the packet loop. A ray alone stays in the first lane of the first packet.
pub(crate) trait Observe<S: Lane> {
    /// A level has been traced; the next one has so many packets.
    fn level(&mut self, work: &Work<S>, stack: &Stack<S>, next: usize);
    /// The level in flight is about to be folded into the one above.
    fn before_fold(&mut self, stack: &Stack<S>);
    /// It has been.
    fn after_fold(&mut self, stack: &Stack<S>);
}

/// Nobody watches.
impl<S: Lane> Observe<S> for () {
    #[inline(always)]
    fn level(&mut self, _: &Work<S>, _: &Stack<S>, _: usize) {}

    #[inline(always)]
    fn before_fold(&mut self, _: &Stack<S>) {}

    #[inline(always)]
    fn after_fold(&mut self, _: &Stack<S>) {}
}

/// Watches the first lane.
struct First<'a, S> {
    watch: &'a mut dyn Watch<S>,
    /// Whether weights are formed.
    cut: bool,
    /// What is about to be folded; its colour is still that before.
    owed: Option<Fold<S>>,
}

impl<S: Lane> Observe<S> for First<'_, S> {
    #[inline(always)]
    fn level(&mut self, work: &Work<S>, stack: &Stack<S>, next: usize) {
        let wave = &work.waves[wave_of(stack.depth())];
        let rays = wave.packet(0);
        let (index, distance) = (work.nearest[0].index[0].to_index(), work.nearest[0].distance[0]);
        self.watch.level(Level {
            origin: first_lane(&rays.origin),
            direction: first_lane(&rays.direction),
            weight: if self.cut { Some(wave.weight(0)[0]) } else { None },
            met: (index != NONE).then_some((index, distance)),
            local: first_lane(&stack.level()[0].colour),
            k: if next > 0 { stack.next()[0].k[0] } else { S::ZERO },
        });
    }

    #[inline(always)]
    fn before_fold(&mut self, stack: &Stack<S>) {
        let (above, level) = (&stack.level_above()[0], &stack.level()[0]);
        let local = first_lane(&above.colour);
        let back = first_lane(&level.colour);
        self.owed = Some(Fold { local, k: level.k[0], back, colour: local });
    }

    #[inline(always)]
    fn after_fold(&mut self, stack: &Stack<S>) {
        if let Some(owed) = self.owed.take() {
            self.watch.fold(Fold { colour: first_lane(&stack.level()[0].colour), ..owed });
        }
    }
}

#[inline(always)]
fn first_lane<S: Copy>(&[[x, ..], [y, ..], [z, ..]]: &Packed<S>) -> [S; 3] {
    [x, y, z]
}
