//! Scenes between whose mirrors errors grow: whether a picture of them is the true one of a
//! scene nearly as stated, by the eye ray and by all input; whether truth moves at all; and
//! whether a picture of another scene fails.

use catoptric_scene::family::{Corridor, Kissing, Room};
use catoptric_scene::{Camera, Draft};

use super::super::amplification::Orbit;
use super::super::backward::{ALLOWED, Judge};
use super::super::finding::Findings;
use super::super::generic::{along, norm, placed};
use super::scenes::{between_balls, sized, workshop};
use crate::formula::Formula;

/// A scene whose true answer is ill-conditioned.
struct Stiff {
    /// Names of the cases judged by the eye ray and by all input.
    backward: [&'static str; 2],
    /// Name of the case that truth moves, where it is the mirrors that move it.
    stiff: Option<&'static str>,
    /// Seen along an orbit, so that the median pixel is amplified; else some are.
    orbit: bool,
    tested: String,
    draft: Draft,
}

impl Stiff {
    fn new(cases: [&'static str; 3], orbit: bool, tested: String, draft: Draft) -> Self {
        let [eye, input, stiff] = cases;
        Self { backward: [eye, input], stiff: Some(stiff), orbit, tested, draft }
    }
}

/// All scenes whose true answer is ill-conditioned.
fn all() -> Vec<Stiff> {
    // Pairs of spheres, the further apart the faster an error grows.
    let mut all: Vec<Stiff> = [
        (["pair 2.01, by eye", "pair 2.01, by input", "pair 2.01, stiff"], 2.01, 120),
        (["pair 2.5, by eye", "pair 2.5, by input", "pair 2.5, stiff"], 2.5, 40),
        (["pair 6, by eye", "pair 6, by input", "pair 6, stiff"], 6.0, 40),
        (["pair 10, by eye", "pair 10, by input", "pair 10, stiff"], 10.0, 40),
    ]
    .into_iter()
    .map(|(cases, sigma, depth)| {
        let draft = between_balls(&Orbit::pair(sigma), FIELD, 0.98, depth);
        Stiff::new(
            cases,
            true,
            format!("two mirror balls {sigma} radii apart, {}", seen(depth)),
            draft,
        )
    })
    .collect();
    // Three and four spheres, and a closed room.
    all.push(Stiff::new(
        [
            "three-sphere scatterer, by eye",
            "three-sphere scatterer, by input",
            "three-sphere scatterer, stiff",
        ],
        true,
        format!("three mirror balls 6 radii apart, {}", seen(40)),
        between_balls(&Orbit::triangle(6.0), FIELD, 0.98, 40),
    ));
    let kissing = Kissing { reflect: 0.95, ..Kissing::default() };
    let mut kissing = kissing.draft().expect("in range");
    kissing.camera.fov = 3.0;
    all.push(Stiff::new(
        ["kissing spheres, by eye", "kissing spheres, by input", "kissing spheres, stiff"],
        false,
        "four balls that touch, k 0.95, a field of 3 degrees between them, 80x60, depth 200"
            .to_owned(),
        placed(&sized(kissing, 80, 60, 200)),
    ));
    let room = Room { balls: 3, ..Room::default() }.draft().expect("in range");
    all.push(Stiff::new(
        ["closed room, by eye", "closed room, by input", "closed room, stiff"],
        false,
        "a mirror room of radius 10 with three balls, k 0.9, 60x45, depth 64".to_owned(),
        placed(&sized(room, 60, 45, 64)),
    ));
    // Mirrors as good as flat amplify nothing: an error grows as the way does.
    for (backward, radius) in [
        (["corridor 1e6, by eye", "corridor 1e6, by input"], 1e6),
        (["corridor 1e9, by eye", "corridor 1e9, by input"], 1e9),
    ] {
        let corridor = Corridor { mirror_radius: Some(radius), ..Corridor::default() };
        let tested = format!(
            "two mirrors of radius {radius:e} and k 0.92 that face each other, five balls between, 80x60, depth 200"
        );
        let draft = placed(&sized(corridor.draft().expect("in range"), 80, 60, 200));
        all.push(Stiff { backward, stiff: None, orbit: false, tested, draft });
    }
    all
}

/// The field of view between spheres, degrees: rays 3e-6 apart stay for as many bounces as errors
/// need to grow ten thousandfold.
const FIELD: f64 = 0.01;

fn seen(depth: u32) -> String {
    format!(
        "k 0.98, seen from between along their orbit, a field of {FIELD} degrees, 40x30, depth {depth}"
    )
}

pub(super) fn run(findings: &mut Findings) {
    for Stiff { backward: [eye, input], stiff, orbit, tested, draft } in all() {
        // Judge the picture by how far truth itself moves under rounding.
        let judge = Judge::new(&Formula::RobustF32.scene(&draft)).expect("depth 200");
        for formula in Formula::ALL {
            let picture = formula.picture(&draft).expect("depth 200");
            let found = judge.judge_as(formula, &picture).expect("depth 200");
            let sentence = format!(
                "Raw error: largest {:.1e}, RMSE {:.1e}, {} pixels off by more than a level; {}.",
                found.raw.max,
                found.raw.rmse,
                found.raw.off_by_more,
                found.beyond()
            );
            findings.push(eye, formula, &tested, found.by_eye, sentence.clone());
            findings.push(input, formula, &tested, found.by_input, sentence);
        }
        // Truth must move, or the scene would not be as hard as it is meant to be.
        if let Some(case) = stiff {
            let spreads = judge.spreads(Formula::RobustF32).expect("depth 200");
            let spread = if orbit { spreads.median } else { spreads.p99 };
            let sentence = format!(
                "Truth moves by {:.1} floors in the median, {:.0} at the 99th percentile.",
                spreads.median, spreads.p99
            );
            findings.push(case, None, &tested, 1.0 / spread, sentence);
        }
    }
    // The judge must reject the picture of a scene that is a little different.
    for (case, tested, draft, change) in others() {
        let judge = Judge::new(&Formula::RobustF32.scene(&draft)).expect("depth 200");
        for formula in Formula::ALL {
            let mut other = draft.clone();
            change(&mut other, 1000.0 * formula.u());
            let picture = formula.picture(&other).expect("depth 200");
            let found = judge.judge_as(formula, &picture).expect("depth 200");
            let sentence = format!("Ratio {:.4}; {}.", found.by_input, found.beyond());
            findings.push(case, formula, tested, ALLOWED / found.by_input, sentence);
        }
    }
}

/// A change of that relative size.
type Change = fn(&mut Draft, f64);

/// Scenes, and another scene that each must be told from.
fn others() -> [(&'static str, &'static str, Draft, Change); 4] {
    let of = |case| all().into_iter().find(|s| s.backward[0] == case).expect("that case").draft;
    // Changes of one thing each: a light further away, a sphere aside, a sphere larger.
    let lamp: Change = |draft, size| {
        let eye = draft.camera.position;
        let at = &mut draft.lights[0].position;
        *at = std::array::from_fn(|i| at[i] + size * (at[i] - eye[i]));
    };
    let aside: Change = |draft, size| {
        let Camera { position, up, .. } = draft.camera;
        let center = &mut draft.spheres[1].center;
        let far = norm(std::array::from_fn(|i| center[i] - position[i]));
        *center = along(*center, up, size * far);
    };
    let ball: Change = |draft, size| {
        let sphere = draft.spheres.last_mut().expect("a ball");
        sphere.radius *= 1.0 + size;
    };
    [
        (
            "workshop, another",
            "the workshop's scene, 160x120, depth 8, ground k 0.3; the gray ball larger",
            placed(&workshop(160, 120, 8, 0.3)),
            ball,
        ),
        (
            "pair 6, another",
            "two balls 6 radii apart, as in pair 6; one of them aside",
            of("pair 6, by eye"),
            aside,
        ),
        (
            "kissing spheres, another",
            "four balls that touch, as above; one of them larger",
            of("kissing spheres, by eye"),
            ball,
        ),
        (
            "closed room, another",
            "the mirror room with three balls, as above; the lamp further away",
            of("closed room, by eye"),
            lamp,
        ),
    ]
}
