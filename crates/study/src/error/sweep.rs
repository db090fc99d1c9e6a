//! The knobs, one at a time.

use catoptric_scene::{Scene, View};

use super::floors::{self, Floor};
use super::request::Request;
use super::row::{Parts, Row, Sweep, Unflipped};
use super::sample::Prepared;
use super::truth::{self, Settled};
use super::{size, words};
use crate::Watch;
use crate::formula::Formula;
use crate::light::LightBounds;
use crate::metrics::Metrics;
use crate::subject::Subject;
use crate::timing::{Times, more_in_turn};

/// All of a scene.
pub(super) struct Measured {
    /// What was made the truth, in words.
    pub(super) about: String,
    pub(super) rows: Vec<Row>,
    pub(super) floors: Vec<Floor>,
}

const DEPTHS: [u32; 14] = [0, 1, 2, 3, 4, 6, 8, 12, 16, 24, 32, 64, 128, 256];
/// Weight cuts from the coarsest to the finest, as every list of settings here.
const WEIGHTS: [f64; 10] = [0.5, 0.2, 0.1, 0.05, 0.02, 1.0 / 255.0, 1e-3, 1e-4, 1e-5, 1e-6];
const SAMPLES: [u32; 6] = [1, 2, 3, 4, 6, 8];

/// Measures all rows of a scene. Stopped, it keeps those that it has, each timed at least once.
pub(super) fn measure(subject: &Subject, request: &Request, watch: &dyn Watch) -> Measured {
    let threads = request.threads.most();
    let Some(mut study) = threads.install(|| Study::begin(subject, request, watch)) else {
        let about = "Interrupted before there was a truth to compare with.".to_owned();
        return Measured { about, rows: Vec::new(), floors: Vec::new() };
    };
    // `None` once it is stopped.
    let _ = study.sweep(subject);
    // Floors are left out once it is stopped.
    let scene = &study.truth.scene;
    let floors = if watch.stopped() {
        Vec::new()
    } else {
        watch.say(&format!("{}: judging what formulas leave", subject.name));
        threads.install(|| floors::measure(scene, watch))
    };
    let mut about = study.truth.words();
    about += &words::left_out(&subject.scene);
    if !watch.stopped() {
        about += &words::enough_depths(&subject.scene, scene, request);
    }

    // Time all settings in turn; one that failed has no time.
    let mut runs = study.runs;
    watch.say(&format!("{}: timing {} settings", subject.name, runs.len()));
    let times = runs.iter().map(|(row, _)| row.times.clone()).collect();
    let times = more_in_turn(times, request.repeat, watch, |i| {
        let (row, prepared) = &mut runs[i];
        row.error.as_ref()?;
        Some(time(prepared, request))
    });
    let rows = runs.into_iter().zip(times).map(|((row, _), times)| Row { times, ..row });
    Measured { about, rows: rows.collect(), floors }
}

/// A scene's truth, and what was measured against it.
struct Study<'a> {
    request: &'a Request<'a>,
    watch: &'a dyn Watch,
    truth: Settled,
    bounds: LightBounds,
    flips: Vec<(Formula, Vec<u32>)>,
    runs: Vec<(Row, Prepared)>,
}

impl<'a> Study<'a> {
    fn begin(subject: &Subject, request: &'a Request<'a>, watch: &'a dyn Watch) -> Option<Self> {
        let truth = Settled::of(subject, watch)?;
        let flips = |formula| Some((formula, truth::flips(&truth.scene, formula, watch)?));
        let flips = Formula::ALL.into_iter().map(flips).collect::<Option<_>>()?;
        let bounds = LightBounds::new(&truth.scene);
        Some(Self { request, watch, truth, bounds, flips, runs: Vec::new() })
    }

    /// Every knob. `None` if it was stopped.
    fn sweep(&mut self, subject: &Subject) -> Option<()> {
        let full = self.truth.depth;
        for depth in DEPTHS.into_iter().filter(|&depth| depth < full).chain([full]) {
            self.depth(depth)?;
        }
        if let Some(target) = self.request.target {
            self.refine(target)?;
        }
        for weight in WEIGHTS {
            let scene = self.changed(|scene| scene.min_weight = weight);
            let bound = self.bounds.left_out_by_weight(weight, full);
            self.formulas(Sweep::Weight, weight, &scene, bound)?;
        }
        self.watch.say(&format!("{}: truth with many samples", subject.name));
        let sized = Subject { name: subject.name.clone(), scene: self.truth.scene.clone() };
        let small = size::small(&sized);
        let threads = self.request.threads.most();
        let many = threads.install(|| truth::many_samples(&small, self.watch))?;
        for samples in SAMPLES {
            self.samples(samples, &small, &many)?;
        }
        Some(())
    }

    fn depth(&mut self, depth: u32) -> Option<()> {
        let scene = self.changed(|scene| scene.max_depth = depth);
        let bound = self.bounds.left_out_by_cap(depth, self.truth.depth);
        self.formulas(Sweep::Depth, depth.into(), &scene, bound)
    }

    /// Adds depths until of each formula the smallest one is known whose RMSE is at most the
    /// target: the one above it that misses is measured too.
    fn refine(&mut self, target: f64) -> Option<()> {
        for formula in Formula::ALL {
            loop {
                let rows = self.runs.iter().map(|(row, _)| row).filter(|r| r.formula == formula);
                let (meets, misses): (Vec<&Row>, Vec<&Row>) =
                    rows.partition(|row| row.sound().is_some_and(|error| error.rmse <= target));
                let depth = |row: &&Row| row.setting as u32;
                let Some(first) = meets.iter().map(depth).min() else { break };
                let below = misses.iter().map(depth).filter(|&depth| depth < first).max();
                let Some(last) = below.filter(|last| last + 1 < first) else { break };
                self.depth(last + (first - last) / 2)?;
            }
        }
        self.runs.sort_by(|(a, _), (b, _)| a.setting.total_cmp(&b.setting));
        Some(())
    }

    fn changed(&self, change: impl FnOnce(&mut catoptric_scene::Render)) -> Scene {
        let sized = Subject { name: String::new(), scene: self.truth.scene.clone() };
        sized.with(|draft| change(&mut draft.render))
    }

    /// A setting with each formula. `None` if it was stopped.
    fn formulas(&mut self, sweep: Sweep, setting: f64, scene: &Scene, bound: f64) -> Option<()> {
        if self.watch.stopped() {
            return None;
        }
        // Truth at this setting tells what ending paths early costs, whatever the formula.
        let (threads, exact) = (self.request.threads.most(), &self.truth.pixels);
        let at_setting = if *scene == self.truth.scene {
            exact.clone()
        } else {
            threads.install(|| truth::pixels(scene, self.watch))?
        };
        let transfer = scene.image.transfer;
        let truncation = Metrics::over(&at_setting, exact, transfer, |_| true).max;
        // Pixels whose path has left truth's by this depth are counted apart.
        for (formula, flips) in &self.flips {
            let kept = |index: usize| flips[index] > scene.render.max_depth;
            let flipped = (0..flips.len()).filter(|&index| !kept(index)).count();
            let scene = formula.scene(scene);
            let mut prepared = Prepared::new(*formula, &scene, &View::whole(&scene));
            let pixels = render(&mut prepared, self.request);
            let unflipped = pixels.as_ref().filter(|_| flipped < flips.len()).map(|pixels| {
                let error = Metrics::over(pixels, exact, transfer, kept);
                Unflipped { error, floor: Metrics::over(pixels, &at_setting, transfer, kept) }
            });
            // The whole error is against the full truth; its parts say what makes it.
            let row = Row {
                sweep,
                setting,
                formula: *formula,
                times: first_time(&mut prepared, pixels.is_some(), self.request),
                error: pixels.map(|pixels| Metrics::over(&pixels, exact, transfer, |_| true)),
                parts: Some(Parts { truncation, bound_truncation: bound, flipped, unflipped }),
            };
            self.runs.push((row, prepared));
        }
        Some(())
    }

    /// A number of samples with each formula. `None` if it was stopped.
    fn samples(&mut self, samples: u32, scene: &Scene, exact: &[[f64; 3]]) -> Option<()> {
        if self.watch.stopped() {
            return None;
        }
        for formula in Formula::ALL {
            let scene = formula.scene(scene);
            let view = View::new(&scene, None, samples).expect("1 to 256 samples");
            let mut prepared = Prepared::new(formula, &scene, &view);
            let pixels = render(&mut prepared, self.request);
            let transfer = scene.image.transfer;
            let row = Row {
                sweep: Sweep::Samples,
                setting: samples.into(),
                formula,
                times: first_time(&mut prepared, pixels.is_some(), self.request),
                error: pixels.map(|pixels| Metrics::over(&pixels, exact, transfer, |_| true)),
                parts: None,
            };
            self.runs.push((row, prepared));
        }
        Some(())
    }
}

/// The picture; `None` where a path is too deep.
fn render(prepared: &mut Prepared, request: &Request) -> Option<Vec<[f64; 3]>> {
    let rendered = request.threads.most().install(|| prepared.render(request.tracer));
    rendered.ok().map(|()| prepared.pixels())
}

/// Times what was rendered once, so that whatever is kept of a stopped study has a time.
fn first_time(prepared: &mut Prepared, rendered: bool, request: &Request) -> Times {
    let mut times = Times::default();
    if rendered {
        times.add(time(prepared, request));
    }
    times
}

fn time(prepared: &mut Prepared, request: &Request) -> std::time::Duration {
    request.threads.time(request.timed_on, || prepared.render(request.tracer)).1
}
