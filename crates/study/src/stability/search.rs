//! A search for scenes whose picture is not the true one of a scene nearly as stated.
//!
//! ```text
//! for each seed:
//!     a scene whose sizes, distances and orientations have any magnitude     search/generate.rs
//!     its picture by each robust formula, judged by backward error           backward.rs
//!     where one fails: the fewest things with which it still does            search/shrink.rs
//! ```
//!
//! The criterion tells wrong pixels from pixels on an edge: nothing else is allowed for.

mod generate;
mod shrink;

use catoptric_scene::{Draft, Scene, SceneFormat};
use rayon::prelude::*;

use super::backward::{Backward, Judge, passes};
use super::cases::edges::{brightest, outside};
use crate::formula::Formula;

/// A scene that a formula does not render as it must.
#[derive(Clone, Debug)]
pub struct Fault {
    /// Which generated scene.
    pub seed: u64,
    /// Which formula fails.
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
    /// Of them, those with something else than background in the picture.
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
    let judge = judge(draft);
    let background = draft.render.background;
    let seen = judge.truth().iter().any(|pixel| *pixel != background);
    let mut found = Found { scenes: 1, seen: u64::from(seen), faults: Vec::new() };
    for formula in [Formula::RobustF32, Formula::RobustF64] {
        if wrong(formula, draft, &judge).is_some() {
            let scene = shrink::shrunk(draft, |smaller| fails(formula, smaller).is_some());
            let text = fails(formula, &scene).expect("what is shrunk fails still");
            found.faults.push(Fault { seed, formula, scene, text });
        }
    }
    found
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
