//! The knobs, one at a time.

use catoptric_scene::{Scene, View};

use super::sample::Prepared;
use super::{Enough, Request, enough, truth};
use crate::Watch;
use crate::formula::Formula;
use crate::light::LightBounds;
use crate::metrics::Metrics;
use crate::subject::Subject;
use crate::timing::{Times, in_turn};
use crate::tracer::Tracer;

/// What is varied.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Sweep {
    /// `max_depth`, without a weight cut.
    Depth,
    /// `min_weight`, at full depth.
    Weight,
    /// Samples a side, at full depth, on a smaller picture.
    Samples,
}

/// One setting of one knob with one formula.
pub(super) struct Row {
    pub(super) sweep: Sweep,
    /// `max_depth`, `min_weight` or samples a side.
    pub(super) setting: f64,
    pub(super) formula: Formula,
    pub(super) times: Times,
    /// Against truth.
    pub(super) error: Metrics,
    /// What the error is made of. Not of samples, where every pixel has many paths.
    pub(super) parts: Option<Parts>,
}

/// The parts of an error.
#[derive(Clone, Copy)]
pub(super) struct Parts {
    /// Truth at this setting against truth.
    pub(super) truncation: Metrics,
    /// Pixels whose path is not truth's: another primitive, or another lamp in view.
    pub(super) flipped: usize,
    /// Against truth, without those.
    pub(super) error: Metrics,
    /// Against truth at this setting, without those: rounding alone.
    pub(super) rounding: Metrics,
    /// A-priori bound of `error.max`: of the truncation, plus the rounding at full depth.
    pub(super) bound: f64,
}

/// All of a scene.
pub(super) struct Measured {
    /// What was made the truth, in words.
    pub(super) about: String,
    pub(super) rows: Vec<Row>,
    pub(super) floors: Vec<truth::Floor>,
}

impl Sweep {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Depth => "depth",
            Self::Weight => "weight",
            Self::Samples => "samples",
        }
    }
}

const DEPTHS: [u32; 14] = [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256];
/// From the coarsest to the finest, as all of these.
const WEIGHTS: [f64; 10] = [0.5, 0.2, 0.1, 0.05, 0.02, 1.0 / 255.0, 1e-3, 1e-4, 1e-5, 1e-6];
const SAMPLES: [u32; 6] = [1, 2, 3, 4, 6, 8];

/// Measures all rows of a scene. Stopped, it keeps those that it has; they have no times.
pub(super) fn measure(subject: &Subject, request: &Request, watch: &dyn Watch) -> Measured {
    let threads = request.threads.most();
    let full = threads.install(|| truth::full_depth(subject));
    let sized = Subject { name: subject.name.clone(), scene: truth::sized(subject, full.depth) };
    let (width, height) = (sized.scene.image.width, sized.scene.image.height);
    watch.say(&format!("{}: truth, {width}x{height}, to depth {}", subject.name, full.depth));
    let bounds = LightBounds::new(&sized.scene);
    let exact = threads.install(|| truth::pixels(&sized.scene));
    let flips = threads.install(|| Formula::ALL.map(|f| (f, truth::flips(&sized.scene, f))));

    let mut runs = Vec::new();
    let depths = DEPTHS.into_iter().filter(|&depth| depth < full.depth).chain([full.depth]);
    for depth in depths {
        let scene = sized.to_depth(depth);
        let bound = bounds.left_out_by_cap(depth, full.depth);
        let setting = Setting { sweep: Sweep::Depth, setting: depth.into(), scene, bound };
        runs.extend(formulas(&setting, &exact, &flips, request));
        if watch.stopped() {
            break;
        }
    }
    for weight in WEIGHTS {
        let scene = sized.with(|draft| draft.render.min_weight = weight);
        let bound = bounds.left_out_by_weight(weight, full.depth);
        let setting = Setting { sweep: Sweep::Weight, setting: weight, scene, bound };
        runs.extend(formulas(&setting, &exact, &flips, request));
        if watch.stopped() {
            break;
        }
    }
    if !watch.stopped() {
        watch.say(&format!("{}: truth with many samples", subject.name));
        let small = truth::small(&sized);
        let many = threads.install(|| truth::many_samples(&small));
        runs.extend(SAMPLES.into_iter().flat_map(|n| sampled(n, &small, &many, request)));
    }
    add_floors(&mut runs);
    let floors = |scene: &Scene| threads.install(|| truth::measure_floors(scene));
    let floors = if watch.stopped() { Vec::new() } else { floors(&sized.scene) };

    watch.say(&format!("{}: timing {} settings", subject.name, runs.len()));
    let times = in_turn(runs.len(), request.repeat, watch, |i| {
        let (_, prepared) = &mut runs[i];
        let (rendered, time) =
            request.threads.time(request.timed_on, || prepared.render(request.tracer));
        rendered.ok().map(|_| time)
    });
    let rows = runs.into_iter().zip(times).map(|((row, _), times)| Row { times, ..row });
    let mut about = truth::words(&full, width, height);
    if !watch.stopped() {
        about += &enough_words(&sized.scene, request);
    }
    Measured { about, rows: rows.collect(), floors }
}

/// Which `max_depth` is enough, in words.
fn enough_words(scene: &Scene, request: &Request) -> String {
    let Tracer::Packet(isa) = request.tracer else { return String::new() };
    match request.threads.most().install(|| enough(scene, isa)) {
        Ok(Enough { same_bits, within_a_level, deepest_ray, .. }) => format!(
            " Of the f32 picture of that size: the deepest ray has {deepest_ray} reflections, \
             max_depth {same_bits} gives the same bits as any deeper, {within_a_level} stays \
             within one 8-bit level of it."
        ),
        Err(_) => String::new(),
    }
}

/// A setting of depth or weight.
struct Setting {
    sweep: Sweep,
    setting: f64,
    scene: Scene,
    /// Of the truncation.
    bound: f64,
}

/// A setting with each formula: its picture's errors, and how to make it again.
fn formulas(
    setting: &Setting,
    exact: &[[f64; 3]],
    flips: &[(Formula, Vec<u32>)],
    request: &Request,
) -> Vec<(Row, Prepared)> {
    let max_depth = setting.scene.render.max_depth;
    request.threads.most().install(|| {
        let at_setting = truth::pixels(&setting.scene);
        let truncation = Metrics::of(&at_setting, exact);
        let formula = |(formula, flips): &(Formula, Vec<u32>)| {
            let scene = formula.scene(&setting.scene);
            let mut prepared = Prepared::new(*formula, &scene, &View::whole(&scene));
            prepared.render(request.tracer).ok()?;
            let pixels = prepared.pixels();
            let unflipped = |pixels: &[[f64; 3]]| -> Vec<[f64; 3]> {
                let kept = pixels.iter().zip(flips).filter(|(_, flip)| **flip > max_depth);
                kept.map(|(pixel, _)| *pixel).collect()
            };
            let kept = unflipped(&pixels);
            let parts = Parts {
                truncation,
                flipped: pixels.len() - kept.len(),
                error: Metrics::of(&kept, &unflipped(exact)),
                rounding: Metrics::of(&kept, &unflipped(&at_setting)),
                bound: setting.bound,
            };
            let row = Row {
                sweep: setting.sweep,
                setting: setting.setting,
                formula: *formula,
                times: Times::default(),
                error: Metrics::of(&pixels, exact),
                parts: Some(parts),
            };
            Some((row, prepared))
        };
        flips.iter().filter_map(formula).collect()
    })
}

/// A number of samples with each formula.
fn sampled(
    samples: u32,
    scene: &Scene,
    exact: &[[f64; 3]],
    request: &Request,
) -> Vec<(Row, Prepared)> {
    let formula = |formula: Formula| {
        let scene = formula.scene(scene);
        let view = View::new(&scene, None, samples).expect("1 to 256 samples");
        let mut prepared = Prepared::new(formula, &scene, &view);
        request.threads.most().install(|| prepared.render(request.tracer)).ok()?;
        let row = Row {
            sweep: Sweep::Samples,
            setting: samples.into(),
            formula,
            times: Times::default(),
            error: Metrics::of(&prepared.pixels(), exact),
            parts: None,
        };
        Some((row, prepared))
    };
    Formula::ALL.into_iter().filter_map(formula).collect()
}

/// Adds to every bound what a formula's rounding leaves at full depth: its floor, which is no
/// part of what a setting leaves out.
fn add_floors(runs: &mut [(Row, Prepared)]) {
    for formula in Formula::ALL {
        let rows = runs.iter().map(|(row, _)| row);
        let rows = rows.filter(|row| row.formula == formula && row.sweep == Sweep::Depth);
        let deepest = rows.max_by(|a, b| a.setting.total_cmp(&b.setting));
        let floor = deepest.and_then(|row| row.parts).map_or(0.0, |parts| parts.rounding.max);
        for (row, _) in runs.iter_mut().filter(|(row, _)| row.formula == formula) {
            if let Some(parts) = &mut row.parts {
                parts.bound += floor;
            }
        }
    }
}
