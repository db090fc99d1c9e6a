//! What must change nothing: moving the scene, turning it, scaling it, a thing that no ray meets,
//! stating every surface twice.

mod engines;
mod turned;
mod unseen;

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::family::Room;
use catoptric_scene::{Draft, Material, View};

use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{along, placed, points};
use super::scenes::{sized, workshop};
use crate::formula::Formula;
use crate::metrics::larger;
use engines::{both, differing};

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    moved(&mut findings);
    turned::run(&mut findings);
    unseen::run(&mut findings);
    scaled(&mut findings);
    twice(&mut findings);
    findings.done()
}

fn moved(findings: &mut Findings) {
    const CASES: [(&str, f64); 3] =
        [("moved by 1e2", 1e2), ("moved by 1e4", 1e4), ("moved by 1e6", 1e6)];
    let draft = placed(&workshop(320, 240, 8, 0.3));
    for formula in Formula::ALL {
        let unmoved = formula.picture(&draft).expect("depth 8");
        for (case, distance) in CASES {
            let shift = [1.234_567, -1.076_543, 1.357_911].map(|x| x * distance);
            let tested = format!(
                "the workshop's scene (320x240, depth 8, ground k 0.3), turned, moved by ({}, {}, {})",
                shift[0], shift[1], shift[2]
            );
            let mut draft = draft.clone();
            points(&mut draft, |x| along(x, shift, 1.0));
            let picture = formula.picture(&draft).expect("depth 8");
            let pairs = picture.as_flattened().iter().zip(unmoved.as_flattened());
            let differences = pairs.map(|(a, b)| (a - b).abs());
            let most = differences.fold(0.0, larger);
            let off = picture.iter().zip(&unmoved).filter(|(a, b)| a != b).count();
            let sentence = format!("{off} of {} pixels differ at all.", picture.len());
            findings.push(case, formula, &tested, most, sentence);
        }
    }
}

/// Powers of two change no bit of any operation, only exponents.
fn scaled(findings: &mut Findings) {
    const CASE: &str = "scaled by powers of two";
    let tested = "the workshop's scene (80x60, depth 8, ground k 0.3), turned, scaled by each power of two from 2^-20 to 2^20; by both engines";
    let draft = placed(&workshop(80, 60, 8, 0.3));
    for formula in Formula::ALL {
        let as_stated = both(formula, &draft);
        let off = (-20..=20).map(|exponent| {
            let factor = f64::from(exponent).exp2();
            let mut draft = draft.clone();
            points(&mut draft, |x| x.map(|x| x * factor));
            draft.spheres.iter_mut().for_each(|sphere| sphere.radius *= factor);
            (exponent, differing(&both(formula, &draft), &as_stated))
        });
        let off: Vec<(i32, usize)> = off.filter(|(_, pixels)| *pixels > 0).collect();
        let sum = off.iter().map(|(_, pixels)| pixels).sum::<usize>() as f64;
        let sentence = match off.first() {
            None => "The same bits at each of 41 scales.".to_owned(),
            Some((exponent, _)) => format!("At {} scales, first at 2^{exponent}.", off.len()),
        };
        findings.push(CASE, formula, tested, sum, sentence);
    }
}

/// The lowest index is seen, so a second statement in another colour never shows.
fn twice(findings: &mut Findings) {
    const CASE: &str = "coincident surfaces";
    let tested = "the workshop's scene and a closed room with five balls (80x60, depth 20), turned; every surface stated again in another colour; by both engines and by truth";
    let room = Room::default().draft().expect("the defaults are in range");
    let scenes = [workshop(80, 60, 20, 0.3), room].map(|once| {
        let once = sized(placed(&once), 80, 60, 20);
        // State every sphere again, in another colour and in reverse order.
        let mut doubled = once.clone();
        doubled.spheres.extend(once.spheres.iter().rev().copied());
        let magenta = doubled.materials.add(Material::matt([9.0, 0.0, 9.0]));
        for sphere in &mut doubled.spheres[once.spheres.len()..] {
            sphere.material = magenta;
        }
        [once, doubled]
    });
    let truth = |draft: &Draft| {
        let scene = Formula::RobustF32.scene(draft);
        let truth = Truth::new(&scene, Precision::DoubleDouble);
        truth.render(&View::whole(&scene)).expect("depth 20").pixels
    };
    // Truth must not tell the two apart either, or the case would be wrong.
    let of_truth = scenes.each_ref().map(|[once, again]| differing(&truth(once), &truth(again)));
    for formula in Formula::ALL {
        let [workshop, room] = scenes
            .each_ref()
            .map(|[once, again]| differing(&both(formula, once), &both(formula, again)));
        let sentence = format!(
            "Pixels that differ: workshop {workshop}, room {room}; of truth {} and {}.",
            of_truth[0], of_truth[1]
        );
        let sum = workshop + room + of_truth[0] + of_truth[1];
        findings.push(CASE, formula, tested, sum as f64, sentence);
    }
}
