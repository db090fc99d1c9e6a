//! What the error study compares with.

use catoptric_reference::truth::{Precision, Truth, Vertex};
use catoptric_scene::{Scene, View};

use super::sweep::Measured;
use crate::formula::Formula;
use crate::light::LightBounds;
use crate::metrics::Metrics;
use crate::report::{Column, Table};
use crate::stability::backward::{Backward, Judge};
use crate::stability::paths::{Arithmetic, Paths, each_pixel};
use crate::subject::Subject;

/// The depth that truth has.
pub(super) struct FullDepth {
    pub(super) depth: u32,
    /// What a deeper one could change at most.
    left_out: f64,
    /// Whether no path would be longer, whatever the depth.
    all_end: bool,
}

/// Light that is not there in any measure.
const NOTHING: f64 = 1e-10;

/// The greatest depth at which truth is made: closed rooms of good mirrors have no depth past
/// which nothing changes.
const DEEPEST: u32 = 512;

/// Pixels that the eye looks for paths in, before the size is chosen.
const LOOK: u32 = 160;

/// The depth past which nothing changes: where all paths have ended, or where the a-priori
/// bound is nothing.
pub(super) fn full_depth(subject: &Subject) -> FullDepth {
    let bounds =
        LightBounds::new(&subject.with(|draft| draft.render.numerics = Default::default()));
    let left_out = |depth: u32| bounds.left_out_by_cap(depth, u32::MAX);
    let enough = (0..DEEPEST).find(|&depth| left_out(depth) <= NOTHING);
    let bounded = enough.unwrap_or(DEEPEST);
    let look = subject.with(|draft| {
        (draft.image.width, draft.image.height) = fit(draft.image.width, draft.image.height, LOOK);
        draft.render.max_depth = bounded;
        draft.render.min_weight = 0.0;
    });
    let truth = Truth::new(&look, Precision::F64).render(&View::whole(&look));
    let rays = truth.map_or(usize::MAX, |film| film.counts.depths.len());
    // A path may be found between those looked at that is somewhat longer.
    let longest = u32::try_from(rays).unwrap_or(bounded).saturating_mul(2).saturating_add(4);
    let all_end = longest < bounded;
    let depth = if all_end { longest } else { bounded };
    FullDepth { depth, left_out: left_out(depth), all_end }
}

/// What truth is, for readers.
pub(super) fn words(full: &FullDepth, width: u32, height: u32) -> String {
    let depth = full.depth;
    let why = if full.all_end {
        "where every path has ended".to_owned()
    } else if full.left_out <= NOTHING {
        format!("past which no pixel can change by more than {NOTHING:.0e}")
    } else {
        "which no depth would settle: its mirrors send everything back".to_owned()
    };
    format!("Pictures of {width}x{height}; truth in double-double to depth {depth}, {why}.")
}

/// The scene in a size that truth can be made in: at most 640 pixels wide or high, less where
/// paths are long; to full depth, without a weight cut, with robust numerics.
pub(super) fn sized(subject: &Subject, depth: u32) -> Scene {
    const BOUNCES: u32 = 8_000_000;
    subject.with(|draft| {
        let image = &mut draft.image;
        let mut longest = 640;
        let (mut width, mut height) = fit(image.width, image.height, longest);
        while longest > 16 && width * height > BOUNCES / (depth + 1) {
            longest -= 16;
            (width, height) = fit(image.width, image.height, longest);
        }
        (image.width, image.height) = (width, height);
        draft.render.max_depth = depth;
        draft.render.min_weight = 0.0;
        draft.render.numerics = Default::default();
    })
}

/// The scene in a size that many samples can be taken in.
pub(super) fn small(sized: &Subject) -> Scene {
    sized.with(|draft| {
        let image = &mut draft.image;
        (image.width, image.height) = (image.width.div_ceil(4), image.height.div_ceil(4));
    })
}

/// At most `longest` columns and rows, with the same shape.
fn fit(width: u32, height: u32, longest: u32) -> (u32, u32) {
    let larger = if width > height { width } else { height };
    if larger <= longest {
        return (width, height);
    }
    let scaled = |side: u32| {
        let scaled = (u64::from(side) * u64::from(longest)).div_ceil(u64::from(larger));
        u32::try_from(scaled).expect("not more than it was")
    };
    (scaled(width), scaled(height))
}

/// Truth in double-double.
pub(super) fn pixels(scene: &Scene) -> Vec<[f64; 3]> {
    let truth = Truth::new(scene, Precision::DoubleDouble).render(&View::whole(scene));
    truth.expect("a study's depths are within the recursion's").pixels
}

/// Truth in f64 with 16 x 16 samples.
pub(super) fn many_samples(scene: &Scene) -> Vec<[f64; 3]> {
    let view = View::new(scene, None, 16).expect("1 to 256 samples");
    let truth = Truth::new(scene, Precision::F64).render(&view);
    truth.expect("a study's depths are within the recursion's").pixels
}

/// For each pixel the first bounce at which a formula's path is not truth's: another primitive,
/// or a lamp that lights only one of them; `u32::MAX` where there is none.
pub(super) fn flips(scene: &Scene, formula: Formula) -> Vec<u32> {
    let view = View::whole(scene);
    let truth = Paths::new(scene, &view, Arithmetic::DoubleDouble);
    let found = Paths::new(scene, &view, formula.arithmetic());
    each_pixel(&view, |x, y| {
        let (found, truth) = (found.path(x, y), truth.path(x, y));
        let same = |(a, b): &(&Vertex, &Vertex)| a.primitive == b.primitive && a.lit == b.lit;
        let kept = found.iter().zip(&truth).take_while(same).count();
        let ends = kept == found.len() && kept == truth.len();
        if ends { u32::MAX } else { u32::try_from(kept).unwrap_or(u32::MAX) }
    })
}

/// What a formula leaves at full depth.
pub(super) struct Floor {
    formula: Formula,
    backward: Backward,
}

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "The scene's name." },
    Column { key: "formula", heading: "formula", meaning: "Formulas and precision." },
    Column { key: "rmse", heading: "RMSE", meaning: "Over all channels, linear, against truth." },
    Column { key: "max", heading: "max", meaning: "Largest error of a channel, linear." },
    Column {
        key: "off_by_more",
        heading: "off > 1",
        meaning: "Pixels with 8-bit levels that differ by more than one.",
    },
    Column {
        key: "backward_eye",
        heading: "backward, eye",
        meaning: "Largest error over what truth moves by when eye rays do by 1 to 4 u.",
    },
    Column {
        key: "backward_input",
        heading: "backward, input",
        meaning: "The same when the whole scene is moved by that too.",
    },
];

/// What is left where nothing is left out, by scene and formula.
pub(super) fn floors() -> Table {
    Table::new(
        "floors",
        COLUMNS,
        "What formulas and precision leave at full depth. A backward ratio up to 4 says that the \
         picture is the true one of a scene nearly as stated: no arithmetic of that precision \
         can be asked for more.",
    )
}

/// Adds a scene's floors.
pub(super) fn push(table: &mut Table, scene: &str, measured: &Measured) {
    for floor in &measured.floors {
        let Metrics { rmse, max, off_by_more, .. } = floor.backward.raw;
        table.push([
            scene.into(),
            floor.formula.name().into(),
            rmse.into(),
            max.into(),
            off_by_more.into(),
            floor.backward.by_eye.into(),
            floor.backward.by_input.into(),
        ]);
    }
}

/// Judges every formula's picture of a scene at full depth.
pub(super) fn measure_floors(scene: &Scene) -> Vec<Floor> {
    let Ok(judge) = Judge::new(scene) else { return Vec::new() };
    let floor = |formula: Formula| {
        let backward = judge.judge(&formula.picture(scene).ok()?).ok()?;
        Some(Floor { formula, backward })
    };
    Formula::ALL.into_iter().filter_map(floor).collect()
}
