//! The workshop's scene, which is itself stiff: a ground of radius 10 000 seen from 4 units.

use super::super::backward::Judge;
use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::placed;
use super::scenes;
use crate::formula::Formula;

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    let as_stated = |ground| scenes::workshop(640, 480, 8, ground);
    let turned = placed(&scenes::workshop(320, 240, 8, 0.3));
    // The scene as stated, with a mirror ground, and turned off neat numbers.
    let scenes = [
        (
            ["workshop, levels", "workshop, backward"],
            as_stated(0.0),
            "640x480, depth 8, ground k 0",
        ),
        (
            ["workshop mirror, levels", "workshop mirror, backward"],
            as_stated(0.3),
            "640x480, depth 8, ground k 0.3",
        ),
        (
            ["workshop turned, levels", "workshop turned, backward"],
            turned,
            "320x240, depth 8, ground k 0.3, turned and moved by no neat numbers",
        ),
    ];
    for ([levels, backward], draft, parameters) in scenes {
        let tested = format!("the workshop's scene: {parameters}");
        // Two findings a scene: levels, and backward error.
        let judge = Judge::new(&Formula::RobustF32.scene(&draft)).expect("depth 8");
        for formula in Formula::ALL {
            let picture = formula.picture(&draft).expect("depth 8");
            let found = judge.judge_as(formula, &picture).expect("depth 8");
            let raw = format!(
                "Raw error: largest {:.1e}, RMSE {:.1e}, {} levels differ at all.",
                found.raw.max, found.raw.rmse, found.raw.off
            );
            findings.push(levels, formula, &tested, found.raw.off_by_more as f64, raw.clone());
            let sentence = format!("By all input {:.3}; {}. {raw}", found.by_input, found.beyond());
            findings.push(backward, formula, &tested, found.by_eye, sentence);
        }
    }
    findings.done()
}
