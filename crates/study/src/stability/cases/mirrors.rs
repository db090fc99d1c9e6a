//! Paths of many reflections: between balls, in closed rooms, along a corridor.

use catoptric_scene::family::{Corridor, Kissing, Room};
use catoptric_scene::{Draft, View};

use super::super::backward::Judge;
use super::super::generic::{norm, placed};
use super::super::paths::Paths;
use super::super::suite::{Effort, Finding, Findings};
use super::scenes::{balls, empty_room, sized};
use crate::formula::{Formula, packets};

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    for (case, tested, draft) in amplifiers() {
        backward(&mut findings, case, &tested, &placed(&draft));
    }
    leaks(&mut findings);
    drift(&mut findings);
    closed_forms(&mut findings);
    findings.done()
}

/// Scenes whose true answer is ill-conditioned.
fn amplifiers() -> Vec<(&'static str, String, Draft)> {
    let mut all = Vec::new();
    let pairs = [("pair 2.01", 2.01), ("pair 2.5", 2.5), ("pair 6", 6.0), ("pair 10", 10.0)];
    for (case, sigma) in pairs {
        let half = sigma / 2.0;
        let draft =
            balls(&[[-half, 0.0, 0.0], [half, 0.0, 0.0]], 0.9, [0.07, 0.83, 2.9 * half], 40);
        let tested = format!("two mirror balls of k 0.9, {sigma} radii apart, 80x60, depth 40");
        all.push((case, tested, draft));
    }
    let triangle = [[0.0, 3.464_1, 0.0], [-3.0, -1.732_1, 0.0], [3.0, -1.732_1, 0.0]];
    all.push((
        "three-sphere scatterer",
        "three mirror balls of k 0.9, 6 radii apart, 80x60, depth 40".to_owned(),
        balls(&triangle, 0.9, [0.31, 0.73, 8.9], 40),
    ));
    let kissing = Kissing { reflect: 0.95, ..Kissing::default() };
    let kissing = kissing.draft().expect("in range");
    all.push((
        "four kissing spheres",
        "four balls that touch, k 0.95, 80x60, depth 200".to_owned(),
        sized(kissing, 80, 60, 200),
    ));
    let room = Room { balls: 3, ..Room::default() }.draft().expect("in range");
    all.push((
        "closed room",
        "a mirror room of radius 10 with three balls, k 0.9, 60x45, depth 64".to_owned(),
        sized(room, 60, 45, 64),
    ));
    for (case, radius) in [("corridor 1e6", 1e6), ("corridor 1e9", 1e9)] {
        let corridor = Corridor { mirror_radius: Some(radius), ..Corridor::default() };
        let tested = format!(
            "two mirrors of radius {radius:e} and k 0.92 that face each other, five balls between, 80x60, depth 200"
        );
        all.push((case, tested, sized(corridor.draft().expect("in range"), 80, 60, 200)));
    }
    all
}

fn backward(findings: &mut Findings, case: &'static str, tested: &str, draft: &Draft) {
    let judge = Judge::new(&Formula::RobustF32.scene(draft)).expect("depth 200");
    for formula in Formula::ALL {
        let found = judge.judge(&formula.picture(draft).expect("depth 200")).expect("depth 200");
        let sentence = format!(
            "By all input; {}. Raw error: largest {:.1e}, RMSE {:.1e}, {} pixels off by more than a level.",
            found.beside(found.by_eye),
            found.raw.max,
            found.raw.rmse,
            found.raw.off_by_more
        );
        findings.push(case, formula, tested, found.by_input, sentence);
    }
}

/// From inside a closed mirror no ray escapes, however deep.
fn leaks(findings: &mut Findings) {
    let of_depth = [
        ("leaks, depth 1000", 1_000, [40, 20]),
        ("leaks, depth 100 000", 100_000, [8, 4]),
        ("leaks, depth 1 000 000", 1_000_000, [8, 1]),
    ];
    for (case, depth, [width, height]) in of_depth {
        let tested = format!(
            "inside an empty mirror sphere of radius 10 and k 1, {width}x{height} rays to depth {depth}"
        );
        let draft = placed(&empty_room(width, height, depth, 1.0));
        for formula in Formula::ALL {
            let scene = formula.scene(&draft);
            let counts = match formula {
                Formula::RobustF64 => packets::<f64>(&scene).map(|(_, counts)| counts),
                _ => packets::<f32>(&scene).map(|(_, counts)| counts),
            };
            let counts = counts.expect("the engine's stacks hold a million levels");
            let leaked: u64 = counts.depths.iter().map(|depth| depth.rays - depth.hits).sum();
            let sentence = format!("Of {} rays.", width * height);
            findings.push(case, formula, &tested, leaked as f64, sentence);
        }
    }
}

/// After many reflections a path in an empty ball is still on the ball. An eye near the middle
/// makes it a ball to the robust forms, an eye near the wall a flat.
fn drift(findings: &mut Findings) {
    let eyes = [
        ("drift, eye near the middle", [1.37, -0.71, 2.13]),
        ("drift, eye near the wall", [1.37, -0.71, 6.13]),
    ];
    for (case, eye) in eyes {
        let mut draft = empty_room(1, 1, DRIFT_DEPTH, 1.0);
        draft.camera.position = eye;
        drift_from(findings, case, &placed(&draft));
    }
}

const DRIFT_DEPTH: u32 = 100_000;

fn drift_from(findings: &mut Findings, case: &'static str, draft: &Draft) {
    let tested =
        format!("a path inside an empty mirror sphere of radius 10 to depth {DRIFT_DEPTH}");
    let sphere = draft.spheres[0];
    let off = |at: [f64; 3]| {
        let out: [f64; 3] = std::array::from_fn(|i| at[i] - sphere.center[i]);
        (norm(out) / sphere.radius - 1.0).abs()
    };
    for formula in Formula::ALL {
        let scene = formula.scene(draft);
        let path = Paths::new(&scene, &View::whole(&scene), formula.arithmetic()).path(0, 0);
        let found: Vec<f64> = path.iter().map(|vertex| off(vertex.point)).collect();
        let complete = found.len() == DRIFT_DEPTH as usize + 1;
        let most = if complete { found.iter().copied().fold(0.0, f64::max) } else { f64::INFINITY };
        let after = |n: usize| found.get(n).copied().unwrap_or(f64::NAN);
        let sentence = format!(
            "{} reflections were followed; after 8, 64, 1000, 10 000 it is {:.0e}, {:.0e}, {:.0e}, {:.0e} off.",
            found.len().saturating_sub(1),
            after(8),
            after(64),
            after(1000),
            after(10_000)
        );
        findings.push(case, formula, &tested, most, sentence);
    }
}

/// Every reflection adds the same light L: L (d + 1) for k = 1, L (1 - k^(d+1))/(1 - k) else.
fn closed_forms(findings: &mut Findings) {
    const DEPTH: u32 = 1000;
    for (case, k) in [("closed form, k 1", 1.0), ("closed form, k 0.999", 0.999_f64)] {
        let tested = format!(
            "inside an empty mirror sphere of radius 10 and k {k} without lamps, 16x8 rays to depth {DEPTH}"
        );
        let draft = placed(&empty_room(16, 8, DEPTH, k));
        let terms = f64::from(DEPTH + 1);
        let sum = if k < 1.0 { (1.0 - k.powf(terms)) / (1.0 - k) } else { terms };
        let exact = 0.1 * sum;
        for formula in Formula::ALL {
            let picture = formula.picture(&draft).expect("depth 1000");
            let errors = picture.as_flattened().iter().map(|x| (x / exact - 1.0).abs());
            let most = errors.fold(0.0, |m: f64, x| if x <= m { m } else { x });
            let sentence = format!("First pixel {:.7}, exact {exact:.7}.", picture[0][0]);
            findings.push(case, formula, &tested, most, sentence);
        }
    }
}
