//! Generated scenes of any magnitude: each is refused by name, or gives finite pictures.

mod generate;

use std::panic::{AssertUnwindSafe, catch_unwind};

use catoptric_scene::{Compiled, Draft, Film, Grid, Scalar, Scene, View};
use rayon::prelude::*;

use super::super::finding::{Effort, Finding, Findings};
use super::edges::{brightest, outside};
use crate::formula::{Formula, packets, pixels};
use crate::tracer::{Renders, Tracer};

/// What became of generated scenes, counted.
#[derive(Clone, Copy, Default)]
struct Outcome {
    refused: u64,
    refused_without_key: u64,
    panics: u64,
    /// Outcomes by formula, in the order of [`Formula::ALL`].
    of: [Pictures; 3],
}

#[derive(Clone, Copy, Default)]
struct Pictures {
    rendered: u64,
    not_finite: u64,
    /// The first scene that is not finite.
    first: Option<u64>,
    engines_differ: u64,
    /// Pictures with a value that is not in [0, B].
    outside: u64,
    /// Pictures that show something else than background.
    hits: u64,
}

pub(crate) fn run(effort: Effort) -> Vec<Finding> {
    let seeds = (0..effort.scenes).into_par_iter();
    let outcome = seeds.map(one).reduce(Outcome::default, Outcome::add);
    let tested = format!(
        "{} generated drafts: coordinates to 1e15, radii 1e-12 to 1e12, ends of every range, odd numbers, 3x1 or 2x2 pixels, depth at most 8",
        effort.scenes
    );
    let mut findings = Findings::new();
    for (formula, of) in Formula::ALL.into_iter().zip(outcome.of) {
        let rendered = format!(
            "Of {} drafts {} are refused by name and {} rendered; {} of these see a surface.",
            effort.scenes, outcome.refused, of.rendered, of.hits
        );
        let first = of.first.map_or_else(String::new, |seed| format!(" First: scene {seed}."));
        let sentence = format!("{rendered}{first}");
        findings.push("extreme, not finite", formula, &tested, of.not_finite as f64, sentence);
        let sentence = format!("Of {} scenes.", of.rendered);
        findings.push("extreme, not in [0, B]", formula, &tested, of.outside as f64, sentence);
        let sentence = format!("Recursion and packets on {} scenes.", of.rendered);
        let differ = of.engines_differ as f64;
        findings.push("extreme, engines differ", formula, &tested, differ, sentence);
    }
    let any = outcome.panics + outcome.refused_without_key;
    let sentence = format!(
        "{} panics, {} errors that name no key.",
        outcome.panics, outcome.refused_without_key
    );
    findings.push("extreme, panics", None, &tested, any as f64, sentence);
    findings.done()
}

impl Outcome {
    fn add(mut self, other: Self) -> Self {
        self.refused += other.refused;
        self.refused_without_key += other.refused_without_key;
        self.panics += other.panics;
        for (sum, part) in self.of.iter_mut().zip(other.of) {
            sum.rendered += part.rendered;
            sum.not_finite += part.not_finite;
            sum.engines_differ += part.engines_differ;
            sum.outside += part.outside;
            sum.hits += part.hits;
            sum.first = match (sum.first, part.first) {
                (Some(a), Some(b)) => Some(a.min(b)),
                (a, b) => a.or(b),
            };
        }
        self
    }
}

/// What became of the scene of that seed.
fn one(seed: u64) -> Outcome {
    let draft = generate::draft(seed);
    catch_unwind(AssertUnwindSafe(|| outcome(seed, &draft)))
        .unwrap_or_else(|_| Outcome { panics: 1, ..Outcome::default() })
}

fn outcome(seed: u64, draft: &Draft) -> Outcome {
    let mut outcome = Outcome::default();
    let scene = match Scene::new(draft.clone()) {
        Ok(scene) => scene,
        Err(error) => {
            outcome.refused = 1;
            outcome.refused_without_key = u64::from(error.key().is_none());
            return outcome;
        }
    };
    for (formula, pictures) in Formula::ALL.into_iter().zip(&mut outcome.of) {
        let scene_of = formula.scene(draft);
        let (picture, differ) = match formula {
            Formula::RobustF64 => both_engines::<f64>(&scene_of),
            _ => both_engines::<f32>(&scene_of),
        };
        let finite = picture.as_flattened().iter().all(|x| x.is_finite());
        let rounded = scene.render.background.map(|x| f64::from(f32::rounded(x)));
        let background = |pixel: &[f64; 3]| *pixel == rounded || *pixel == scene.render.background;
        *pictures = Pictures {
            rendered: 1,
            not_finite: u64::from(!finite),
            first: (!finite).then_some(seed),
            engines_differ: u64::from(differ),
            outside: u64::from(outside(&picture, brightest(&scene_of)) > 0),
            hits: u64::from(!picture.iter().all(background)),
        };
    }
    outcome
}

/// The recursion's picture, and whether the packets' differs in any bit or count.
fn both_engines<S: Renders>(scene: &Scene) -> (Vec<[f64; 3]>, bool) {
    let (compiled, grid) = (Compiled::of(scene), Grid::of(&View::whole(scene)));
    let mut film: Film<S> = Film::black(grid.width, grid.height);
    let counts = Tracer::Recursive.render(&compiled, &grid, &mut film).expect("depth 8");
    let (packets, counted) = packets::<S>(scene).expect("depth 8");
    let (by_recursion, by_packets) = (pixels(&film), pixels(&packets));
    // To f64 every number is widened to a different one.
    let same = |a: &f64, b: &f64| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
    let pairs = by_recursion.as_flattened().iter().zip(by_packets.as_flattened());
    let equal = pairs.into_iter().all(|(a, b)| same(a, b));
    (by_recursion, !(equal && counts == counted))
}
