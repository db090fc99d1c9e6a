//! Measuring in alternation, so that what disturbs the machine disturbs both.

use std::time::{Duration, Instant};

use catoptric_core::Isa;
use catoptric_scene::{Film, Scene};
use catoptric_tests::scenes::sized;

use super::entry::Entry;
use super::spread::{least, median, relative_spread};
use crate::runner::Runner;
use crate::scenes::{corridor, flake, workshop};
use crate::subject::Subject;

/// Threads of the engine, and of the recursion that it is compared with beside 1.
pub const THREADS: usize = 2;

/// Rounds of a scene, unless the time is up before.
pub const ROUNDS: usize = 25;

/// After it a scene starts no further round, once it has [`LEAST_ROUNDS`].
pub const TIME_LIMIT: Duration = Duration::from_secs(60);

/// Rounds without which no quartile means anything.
pub const LEAST_ROUNDS: usize = 5;

/// What all lines of one recording share.
pub struct Occasion {
    /// When it began, ISO 8601.
    pub date: String,
    /// Of which source.
    pub commit: String,
    /// On which processor.
    pub processor: String,
    /// By which path of the engine.
    pub isa: Isa,
}

/// The scenes of the history: the headline, a corridor of deep paths, many primitives.
#[must_use]
pub fn scenes() -> Vec<(&'static str, Scene)> {
    vec![
        ("workshop", sized(&workshop(), 1920, 1080, 5)),
        ("corridor", sized(&corridor(), 640, 360, 16)),
        ("flake", sized(&flake(), 640, 360, 5)),
    ]
}

/// Times of every rendering, in seconds; entry i of each is round i.
struct Rounds {
    one: Vec<f64>,
    same: Vec<f64>,
    engine_after_one: Vec<f64>,
    engine_after_same: Vec<f64>,
}

/// Checks a scene's picture, then measures it for one line.
///
/// # Panics
/// If the engine's picture is not the recursion's, before or after.
#[must_use]
pub fn entry(occasion: &Occasion, name: &str, scene: &Scene) -> Entry {
    let subject = Subject::checked(name, scene);
    let rounds = alternate(&subject, occasion.isa);
    let rays = subject.rays();
    let engine = [&rounds.engine_after_one[..], &rounds.engine_after_same].concat();
    let pairs = rounds.same.iter().zip(&rounds.engine_after_same);
    let own: Vec<f64> = pairs.map(|(recursion, engine)| recursion / engine).collect();
    let ns_per_ray = |seconds: f64| seconds * 1e9 / rays as f64;
    Entry {
        date: occasion.date.clone(),
        commit: occasion.commit.clone(),
        processor: occasion.processor.clone(),
        isa: occasion.isa.to_string(),
        threads: THREADS,
        scene: name.to_owned(),
        size: format!("{}x{}", scene.image.width, scene.image.height),
        depth: scene.render.max_depth,
        rays,
        rounds: rounds.one.len(),
        over_one_min: least(&rounds.one) / least(&rounds.engine_after_one),
        over_one_median: median(&rounds.one) / median(&rounds.engine_after_one),
        over_same_min: least(&rounds.same) / least(&rounds.engine_after_same),
        over_same_median: median(&rounds.same) / median(&rounds.engine_after_same),
        over_same_spread: relative_spread(&own),
        ns_per_ray_min: ns_per_ray(least(&engine)),
        ns_per_ray_median: ns_per_ray(median(&engine)),
    }
}

/// Recursion on 1 thread, engine, recursion on [`THREADS`], engine; after one round unmeasured.
fn alternate(subject: &Subject, isa: Isa) -> Rounds {
    let (one, same) = (Runner::recursion(1), Runner::recursion(THREADS));
    let engine = Runner::engine(isa, THREADS);
    let mut film = subject.film();
    let mut rounds = Rounds {
        one: Vec::new(),
        same: Vec::new(),
        engine_after_one: Vec::new(),
        engine_after_same: Vec::new(),
    };
    for runner in [one, engine, same, engine] {
        let _ = seconds(runner, subject, &mut film);
    }
    let start = Instant::now();
    while rounds.one.len() < ROUNDS
        && (rounds.one.len() < LEAST_ROUNDS || start.elapsed() < TIME_LIMIT)
    {
        rounds.one.push(seconds(one, subject, &mut film));
        rounds.engine_after_one.push(seconds(engine, subject, &mut film));
        rounds.same.push(seconds(same, subject, &mut film));
        rounds.engine_after_same.push(seconds(engine, subject, &mut film));
    }
    subject.confirm(&film);
    rounds
}

fn seconds(runner: Runner, subject: &Subject, film: &mut Film) -> f64 {
    runner.time(subject, film, 1).as_secs_f64()
}
