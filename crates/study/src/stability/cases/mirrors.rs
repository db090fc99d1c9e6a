//! Paths of many reflections in closed rooms; between spheres and along a corridor, see `stiff.rs`.

use catoptric_scene::family::Room;
use catoptric_scene::{Draft, View};

use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{norm, placed};
use super::super::paths::Paths;
use super::scenes::{empty_room, sized};
use crate::formula::{Formula, packets};
use crate::metrics::larger;

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    super::stiff::run(&mut findings);
    leaks(&mut findings);
    drift(&mut findings);
    closed_forms(&mut findings);
    findings.done()
}

/// Rays that escape from inside a closed mirror: none may, however deep.
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
        leaks_of(findings, case, &tested, &placed(&empty_room(width, height, depth, 1.0)));
    }
    let mut room = Room { balls: 5, ..Room::default() }.draft().expect("in range");
    room.materials.iter_mut().for_each(|material| material.reflect = Some(1.0));
    let tested =
        "a mirror room of radius 10 with five balls, k 1 all of them, 16x12 rays to depth 10 000";
    let case = "leaks among balls, depth 10 000";
    leaks_of(findings, case, tested, &placed(&sized(room, 16, 12, 10_000)));
}

fn leaks_of(findings: &mut Findings, case: &'static str, tested: &str, draft: &Draft) {
    for formula in Formula::ALL {
        let scene = formula.scene(draft);
        let counts = match formula {
            Formula::RobustF64 => packets::<f64>(&scene).map(|(_, counts)| counts),
            _ => packets::<f32>(&scene).map(|(_, counts)| counts),
        };
        let counts = counts.expect("the engine's stacks hold a million levels");
        let leaked: u64 = counts.depths.iter().map(|depth| depth.rays - depth.hits).sum();
        let sentence = format!("Of {} rays.", draft.image.width * draft.image.height);
        findings.push(case, formula, tested, leaked as f64, sentence);
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
        let most = if complete { found.iter().copied().fold(0.0, larger) } else { f64::INFINITY };
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
            let most = errors.fold(0.0, larger);
            let sentence = format!("First pixel {:.7}, exact {exact:.7}.", picture[0][0]);
            findings.push(case, formula, &tested, most, sentence);
        }
    }
}
