//! One eye ray's life as the packet loop has it, for those who study it.
//!
//! The loop that is watched is the loop that renders: it asks once a level whether it is.

use catoptric_scene::{Compiled, Phong, Scalar};

use crate::lanes::{self, Lane};
use crate::nested;
use crate::occluders::Occluders;
use crate::packet::{Candidates, NONE, Omit, TooDeep, Work, World, wave_of};
use crate::render::{Settings, StackFull};
use crate::stack::{Budget, Stack};
use crate::tile::Tile;
use crate::vec3::Packed;

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
    let all = nested::all(scene);
    let occluders = Occluders::new(scene, &all).with_cones(&scene.lights, 1);
    let world = World {
        scene,
        candidates: Candidates { eye: &all, mirrors: &all },
        occluders: &occluders,
        hidden: &[],
        depth: scene.max_depth,
        omit: Omit { occluders: false, directions: false, shadows: false },
    };
    let (mut work, mut stack) =
        (Work::new(scene, occluders.len()), Stack::new(&budget, scene.max_depth));
    let cut = scene.min_weight > 0.0;
    let mut watcher = Watcher {
        watch,
        materials: &scene.materials,
        background: scene.background.into(),
        cut,
        owed: None,
    };
    let tile = Tile {
        world,
        samples: 1,
        columns: &[column],
        rows: &[row],
        work: &mut work,
        stack: &mut stack,
        watch: Some(&mut watcher),
    };
    match lanes::run(settings.isa, tile) {
        Ok(_) => Ok(stack.eye_colours().ray(0)),
        Err(TooDeep) => Err(StackFull { limit: settings.stack_limit }),
    }
}

/// Shows what happens in the packet loop to [`Watch`]. A ray alone stays in the first lane of
/// the first packet.
pub(crate) struct Watcher<'a, S: Scalar> {
    watch: &'a mut dyn Watch<S>,
    materials: &'a [Phong<S>],
    background: [S; 3],
    /// Whether weights are formed.
    cut: bool,
    /// What is about to be folded; its colour is still that before.
    owed: Option<Fold<S>>,
}

impl<S: Lane> Watcher<'_, S> {
    /// A level has been traced; the next one has so many packets.
    #[cold]
    pub(crate) fn level(&mut self, work: &Work<S>, stack: &Stack<S>, next: usize) {
        let wave = &work.waves[wave_of(stack.depth())];
        let (index, distance) =
            (work.nearest.index.ray(0).to_index(), work.nearest.distance.ray(0));
        let (origin, direction) = wave.ray(0);
        self.watch.level(Level {
            origin,
            direction,
            weight: if self.cut { Some(wave.weights().ray(0)) } else { None },
            met: (index != NONE).then_some((index, distance)),
            local: match stack.level() {
                [hit, ..] => first_lane(&hit.local),
                [] => self.background,
            },
            k: if next > 0 { stack.level()[0].owed[0].k(self.materials) } else { S::ZERO },
        });
    }

    /// The level in flight is about to be taken off the stack.
    #[cold]
    pub(crate) fn before_fold(&mut self, stack: &Stack<S>) {
        let local = match stack.level() {
            [mirror, ..] if !mirror.owed[0].is_end() => first_lane(&mirror.local),
            _ => return,
        };
        let back = stack.colours(stack.depth() + 1).ray(0);
        let k = stack.level()[0].owed[0].k(self.materials);
        self.owed = Some(Fold { local, k, back, colour: local });
    }

    /// It has been.
    #[cold]
    pub(crate) fn after_fold(&mut self, stack: &Stack<S>) {
        if let Some(owed) = self.owed.take() {
            self.watch.fold(Fold { colour: stack.colours(stack.depth()).ray(0), ..owed });
        }
    }
}

fn first_lane<S: Copy>(&[[x, ..], [y, ..], [z, ..]]: &Packed<S>) -> [S; 3] {
    [x, y, z]
}
