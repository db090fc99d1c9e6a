//! A search for scenes whose picture is not the true one of a scene nearly as stated.
//!
//! ```text
//! for each seed:
//!     a scene whose sizes, distances and orientations have any magnitude     search/generate.rs
//!     its picture by each robust formula, judged by backward error           backward.rs
//!     where one fails: the fewest things with which it still does            search/shrink.rs
//! ```
//!
//! The criterion tells wrong pixels from pixels on an edge: nothing else is allowed for. It asks
//! for two things, which leave out some scenes in f64. Truth's plain formula loses the square of a
//! sphere's distance over its radius, of 32 digits; where that reaches the formula's own digits
//! there is no truth to judge by. And input can be moved by some roundings only where f64 can state
//! it: in f64 the scene is first stated in the camera's own axes.

mod generate;
mod shrink;

use catoptric_scene::{CameraAxes, DoubleDouble, Draft, Scene, SceneFormat};
use rayon::prelude::*;

use super::backward::{Backward, Judge, passes};
use super::cases::edges::{brightest, outside};
use super::exact;
use crate::formula::Formula;

/// A scene that a formula does not render as it must.
#[derive(Clone, Debug)]
pub struct Fault {
    /// Seed of the generated scene.
    pub seed: u64,
    /// The formula that fails.
    pub formula: Formula,
    /// The scene, with nothing in it that the failure does not need.
    pub scene: Draft,
    /// How it fails, in words.
    pub text: String,
}

/// What a search looked at.
#[derive(Clone, Debug, Default)]
pub struct Found {
    /// Generated drafts that are scenes.
    pub scenes: u64,
    /// Scenes with something else than background in the picture.
    pub seen: u64,
    /// One for each scene and formula that fails, by seed.
    pub faults: Vec<Fault>,
}

impl Fault {
    /// The scene as TOML, ready to render, headed by what is wrong with it.
    #[must_use]
    pub fn to_toml(&self) -> String {
        let scene = Scene::new(self.scene.clone()).expect("it was rendered");
        let text = scene.to_text(SceneFormat::Toml);
        format!("# seed {}, {}: {}\n{text}", self.seed, self.formula.name(), self.text)
    }
}

/// Searches the scenes of these seeds, on rayon's current threads.
#[must_use]
pub fn search(seeds: std::ops::Range<u64>) -> Found {
    let each = seeds.into_par_iter().filter_map(|seed| {
        let draft = generate::draft(seed);
        Scene::new(draft.clone()).is_ok().then(|| one(seed, &draft))
    });
    let mut found = each.reduce(Found::default, |mut all, one| {
        all.scenes += one.scenes;
        all.seen += one.seen;
        all.faults.extend(one.faults);
        all
    });
    found.faults.sort_by_key(|fault| fault.seed);
    found
}

fn one(seed: u64, draft: &Draft) -> Found {
    let mut found = Found { scenes: 1, ..Found::default() };
    let judged = judge(draft);
    let background = draft.render.background;
    found.seen = u64::from(judged.truth().iter().any(|pixel| *pixel != background));
    let mut add = |formula, draft: &Draft, judge: &Judge| {
        if truth_tells(formula, draft) && wrong(formula, draft, judge).is_some() {
            let scene = shrink::shrunk(draft, |smaller| fails(formula, smaller).is_some());
            let text = fails(formula, &scene).expect("what is shrunk fails still");
            found.faults.push(Fault { seed, formula, scene, text });
        }
    };
    add(Formula::RobustF32, draft, &judged);
    let draft = in_camera_axes(draft);
    if Scene::new(draft.clone()).is_ok() {
        add(Formula::RobustF64, &draft, &judge(&draft));
    }
    found
}

/// Whether truth has more digits of every sphere than the formula.
fn truth_tells(formula: Formula, draft: &Draft) -> bool {
    const LAST: f64 = f64::EPSILON * f64::EPSILON / 4.0;
    draft.spheres.iter().all(|sphere| {
        let far = exact::length(exact::between(sphere.center, draft.camera.position)).to_f64();
        let radii = far / sphere.radius;
        radii * radii * LAST <= formula.u()
    })
}

/// The same scene as seen, up to a rounding of each coordinate: the eye at the origin, looking down
/// the z axis.
fn in_camera_axes(draft: &Draft) -> Draft {
    let axes = CameraAxes::new(&draft.camera);
    let point = |x| axes.point(x).map(DoubleDouble::to_f64);
    let mut seen = draft.clone();
    seen.lights.iter_mut().for_each(|light| light.position = point(light.position));
    seen.spheres.iter_mut().for_each(|sphere| sphere.center = point(sphere.center));
    for plane in &mut seen.planes {
        plane.point = point(plane.point);
        plane.normal = axes.turned(plane.normal.map(DoubleDouble::from)).map(DoubleDouble::to_f64);
    }
    seen.camera.position = [0.0; 3];
    seen.camera.look_at = [0.0, 0.0, -1.0];
    seen.camera.up = [0.0, 1.0, 0.0];
    seen
}

/// How a formula fails on a draft; nothing where it holds, or where the draft is no scene.
fn fails(formula: Formula, draft: &Draft) -> Option<String> {
    Scene::new(draft.clone()).is_ok().then(|| wrong(formula, draft, &judge(draft))).flatten()
}

fn judge(draft: &Draft) -> Judge {
    Judge::new(&Formula::RobustF32.scene(draft)).expect("at most eight reflections")
}

fn wrong(formula: Formula, draft: &Draft, judge: &Judge) -> Option<String> {
    let picture = formula.picture(draft).expect("at most eight reflections");
    let outside = outside(&picture, brightest(&formula.scene(draft)));
    let found = judge.judge_as(formula, &picture).expect("at most eight reflections");
    let Backward { by_input, raw, .. } = found;
    let holds = passes(by_input) && raw.not_finite == 0 && outside == 0;
    (!holds).then(|| {
        format!(
            "backward ratio {by_input:.3e}, {}; largest error {:.3e}, {} pixels off by more than a level, {} values not finite, {outside} pixels not in [0, B]",
            found.beyond(),
            raw.max,
            raw.off_by_more,
            raw.not_finite
        )
    })
}
