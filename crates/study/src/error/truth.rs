//! What the error study compares with.

use catoptric_reference::truth::{Precision, Truth, Vertex};
use catoptric_scene::{Crop, Scene, View};
use rayon::prelude::*;

use super::size::{LOOK, fit, sized};
use crate::Watch;
use crate::formula::Formula;
use crate::light::LightBounds;
use crate::stability::paths::{Arithmetic, Paths, each_pixel};
use crate::subject::Subject;

/// Truth of a scene in the size that it can be made in, to the depth past which nothing changes.
pub struct Settled {
    /// The scene in that size and to that depth, without a weight cut, with robust numerics.
    pub scene: Scene,
    /// The scene's `max_depth`.
    pub depth: u32,
    /// Linear RGB, row by row from the top left.
    pub pixels: Vec<[f64; 3]>,
    /// Reflections of the deepest ray: less than `depth` where all paths have ended.
    pub deepest: u32,
    /// What a deeper one could change at most.
    left_out: f64,
}

/// Light that is not there in any measure.
const NOTHING: f64 = 1e-10;

/// The greatest depth at which truth is made: closed rooms of good mirrors have no depth past
/// which nothing changes.
const DEEPEST: u32 = 512;

const EXPECT: &str = "a study's depths are within the recursion's";

impl Settled {
    /// Truth to the depth past which nothing changes: where all paths of that picture have
    /// ended, or where the a-priori bound is nothing, or 512. `None` if it was stopped.
    #[must_use]
    pub fn of(subject: &Subject, watch: &dyn Watch) -> Option<Self> {
        let bounds =
            LightBounds::new(&subject.with(|draft| draft.render.numerics = Default::default()));
        let left_out = |depth: u32| bounds.left_out_by_cap(depth, u32::MAX);
        let bounded = (0..DEEPEST).find(|&depth| left_out(depth) <= NOTHING).unwrap_or(DEEPEST);
        // A guess, from a picture small enough to be made twice. Another size has other pixels,
        // and one of them may hold a longer path: so the final one is what decides.
        let look = subject.with(|draft| {
            let image = &mut draft.image;
            (image.width, image.height) = fit(image.width, image.height, LOOK);
            draft.render.max_depth = bounded;
            draft.render.min_weight = 0.0;
        });
        let (_, longest) = picture(&look, Precision::F64, 1, watch)?;
        let mut depth = smaller(2 * (longest + 1) + 4, bounded);
        loop {
            let scene = sized(subject, depth);
            let (width, height) = (scene.image.width, scene.image.height);
            watch.say(&format!("{}: truth, {width}x{height}, to depth {depth}", subject.name));
            let (pixels, deepest) = picture(&scene, Precision::DoubleDouble, 1, watch)?;
            if deepest < depth || depth >= bounded {
                let left_out = left_out(depth);
                return Some(Self { scene, depth, pixels, deepest, left_out });
            }
            depth = smaller(depth * 2, bounded);
        }
    }

    /// What truth is, for readers.
    #[must_use]
    pub fn words(&self) -> String {
        let Self { depth, deepest, .. } = self;
        let (width, height) = (self.scene.image.width, self.scene.image.height);
        let why = if deepest < depth {
            format!(
                "where every path of that picture has ended, the last after {deepest} reflections"
            )
        } else if self.left_out <= NOTHING {
            format!("past which no pixel can change by more than {NOTHING:.0e}")
        } else {
            "which no depth would settle: its mirrors send everything back".to_owned()
        };
        format!("Pictures of {width}x{height}; truth in double-double to depth {depth}, {why}.")
    }
}

/// Truth in double-double; `None` if it was stopped.
pub(super) fn pixels(scene: &Scene, watch: &dyn Watch) -> Option<Vec<[f64; 3]>> {
    Some(picture(scene, Precision::DoubleDouble, 1, watch)?.0)
}

/// Truth in f64 with 16 x 16 samples; `None` if it was stopped.
pub(super) fn many_samples(scene: &Scene, watch: &dyn Watch) -> Option<Vec<[f64; 3]>> {
    Some(picture(scene, Precision::F64, 16, watch)?.0)
}

/// A picture and the reflections of its deepest ray; row by row, so that it can be stopped.
fn picture(
    scene: &Scene,
    precision: Precision,
    samples: u32,
    watch: &dyn Watch,
) -> Option<(Vec<[f64; 3]>, u32)> {
    let truth = Truth::new(scene, precision);
    let (width, height) = (scene.image.width, scene.image.height);
    let row = |y: u32| {
        if watch.stopped() {
            return None;
        }
        let crop = Crop { x: 0, y, width, height: 1 };
        let view = View::new(scene, Some(crop), samples).expect("a row of the picture");
        Some(truth.render(&view).expect(EXPECT))
    };
    let rows = (0..height).into_par_iter().map(row).collect::<Option<Vec<_>>>()?;
    let rays = rows.iter().map(|row| row.counts.depths.len()).max().unwrap_or(0);
    let deepest = u32::try_from(rays.saturating_sub(1)).expect(EXPECT);
    Some((rows.into_iter().flat_map(|row| row.pixels).collect(), deepest))
}

/// The first bounce, by pixel, at which a formula's path is not truth's: another primitive, or a
/// light that lights only one of them; `u32::MAX` where there is none. `None` if it was stopped.
pub(super) fn flips(scene: &Scene, formula: Formula, watch: &dyn Watch) -> Option<Vec<u32>> {
    let view = View::whole(scene);
    let truth = Paths::new(scene, &view, Arithmetic::DoubleDouble);
    let found = Paths::new(scene, &view, formula.arithmetic());
    let flips = each_pixel(&view, |x, y| {
        if watch.stopped() {
            return 0;
        }
        let (found, truth) = (found.path(x, y), truth.path(x, y));
        let same = |(a, b): &(&Vertex, &Vertex)| a.primitive == b.primitive && a.lit == b.lit;
        let kept = found.iter().zip(&truth).take_while(same).count();
        let ends = kept == found.len() && kept == truth.len();
        if ends { u32::MAX } else { u32::try_from(kept).unwrap_or(u32::MAX) }
    });
    (!watch.stopped()).then_some(flips)
}

fn smaller(a: u32, b: u32) -> u32 {
    if a < b { a } else { b }
}
