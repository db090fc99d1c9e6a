//! One eye ray's life as the packet loop has it, for those who study it.
//!
//! The loop that is watched is the loop that renders: it asks once a bounce whether it is.

use catoptric_scene::{Compiled, Phong, Scalar};

use crate::omission::Omissions;
use crate::plan::nested;
use crate::ray::{NONE, queue_of};
use crate::settings::{Settings, StackFull};
use crate::simd::{self, Lane, Packed};
use crate::trace::{Budget, Frame, Observe, Scratch, Stack, Tile, TooDeep};

/// A bounce on the way down.
#[derive(Clone, Copy, Debug)]
pub struct Bounce<S = f32> {
    /// Start of the ray, relative to the eye.
    pub origin: [S; 3],
    /// Direction of the ray.
    pub direction: [S; 3],
    /// The product of the reflectances on the way; `None` without a cut by weight, where the
    /// engine forms none.
    pub weight: Option<S>,
    /// Index of the primitive that it met, and how far along the ray.
    pub met: Option<(u32, S)>,
    /// What was put on the stack: the light from there, or the background.
    pub local: [S; 3],
    /// The reflectance, 0 where the mirror is not followed.
    pub reflectance: S,
}

/// A bounce on the way up: colour = local + reflectance · back.
#[derive(Clone, Copy, Debug)]
pub struct Fold<S = f32> {
    /// What was taken off the stack.
    pub local: [S; 3],
    /// The reflectance.
    pub reflectance: S,
    /// The colour of the bounce below.
    pub back: [S; 3],
    /// The sum.
    pub colour: [S; 3],
}

/// Sees what happens to one ray of a packet.
pub trait Watch<S = f32> {
    /// Every bounce of its path on the way down, from the eye.
    fn bounce(&mut self, bounce: Bounce<S>);
    /// Every bounce on the way up, but for the deepest, which owes nothing.
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
    let frame = Frame::new(scene, nested::all(scene), 1, scene.max_depth, Omissions::NONE);
    let mut scratch = Scratch::new(&frame, &budget);
    let cut = scene.min_weight > 0.0;
    let mut watcher = Watcher {
        watch,
        materials: &scene.materials,
        background: scene.background.into(),
        cut,
        owed: None,
    };
    let tile = Tile {
        frame: &frame,
        candidates: frame.tiles.all(),
        samples: 1,
        columns: &[column],
        rows: &[row],
        scratch: &mut scratch,
        observer: Some(&mut watcher),
    };
    match simd::run(settings.isa, tile) {
        Ok(_) => Ok(scratch.stack.eye_colours().ray(0)),
        Err(TooDeep) => Err(StackFull { limit: settings.stack_limit }),
    }
}

/// Shows what happens in the packet loop to [`Watch`]. A ray alone stays in the first lane of
/// the first packet.
struct Watcher<'a, S: Scalar> {
    watch: &'a mut dyn Watch<S>,
    materials: &'a [Phong<S>],
    background: [S; 3],
    /// Whether weights are formed.
    cut: bool,
    /// What is about to be folded; its colour is still that before.
    owed: Option<Fold<S>>,
}

impl<S: Lane> Observe<S> for Watcher<'_, S> {
    #[cold]
    fn bounce(&mut self, scratch: &Scratch<S>, next: usize) {
        let stack = &scratch.stack;
        let queue = &scratch.queues[queue_of(stack.bounce())];
        let nearest = &scratch.nearest;
        let (index, distance) = (nearest.index.ray(0).to_index(), nearest.distance.ray(0));
        let (origin, direction) = queue.ray(0);
        self.watch.bounce(Bounce {
            origin,
            direction,
            weight: if self.cut { Some(queue.weights().ray(0)) } else { None },
            met: (index != NONE).then_some((index, distance)),
            local: match stack.pending() {
                [hit, ..] => first_lane(&hit.local),
                [] => self.background,
            },
            reflectance: if next > 0 {
                stack.pending()[0].slots[0].reflectance(self.materials)
            } else {
                S::ZERO
            },
        });
    }

    #[cold]
    fn before_fold(&mut self, stack: &Stack<S>) {
        let local = match stack.pending() {
            [mirror, ..] if !mirror.slots[0].is_end() => first_lane(&mirror.local),
            _ => return,
        };
        let back = stack.colours(stack.bounce() + 1).ray(0);
        let reflectance = stack.pending()[0].slots[0].reflectance(self.materials);
        self.owed = Some(Fold { local, reflectance, back, colour: local });
    }

    #[cold]
    fn after_fold(&mut self, stack: &Stack<S>) {
        if let Some(owed) = self.owed.take() {
            self.watch.fold(Fold { colour: stack.colours(stack.bounce()).ray(0), ..owed });
        }
    }
}

fn first_lane<S: Copy>(&[[x, ..], [y, ..], [z, ..]]: &Packed<S>) -> [S; 3] {
    [x, y, z]
}
