//! What must change nothing: moving the scene, scaling it, stating every surface twice.

use catoptric_scene::family::Room;
use catoptric_scene::{Compiled, Draft, Film, Grid, Material, View};

use super::super::generic::{along, placed, points};
use super::super::suite::{Effort, Finding, Findings};
use super::scenes::{sized, workshop};
use crate::formula::Formula;

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    moved(&mut findings);
    scaled(&mut findings);
    twice(&mut findings);
    findings.done()
}

fn moved(findings: &mut Findings) {
    const CASES: [(&str, f64); 3] =
        [("moved by 1e2", 1e2), ("moved by 1e4", 1e4), ("moved by 1e6", 1e6)];
    let draft = workshop(320, 240, 8, 0.3);
    for formula in Formula::ALL {
        let unmoved = formula.picture(&draft).expect("depth 8");
        for (case, distance) in CASES {
            let shift = [1.234_567, -1.076_543, 1.357_911].map(|x| x * distance);
            let tested = format!(
                "the workshop's scene (320x240, depth 8, ground k 0.3) moved by ({}, {}, {})",
                shift[0], shift[1], shift[2]
            );
            let mut draft = draft.clone();
            points(&mut draft, |x| along(x, shift, 1.0));
            let picture = formula.picture(&draft).expect("depth 8");
            let pairs = picture.as_flattened().iter().zip(unmoved.as_flattened());
            let differences = pairs.map(|(a, b)| (a - b).abs());
            let most = differences.fold(0.0, |m: f64, x| if x <= m { m } else { x });
            let off = picture.iter().zip(&unmoved).filter(|(a, b)| a != b).count();
            let sentence = format!("{off} of {} pixels differ at all.", picture.len());
            findings.push(case, formula, &tested, most, sentence);
        }
    }
}

/// Powers of two change no bit of any operation, only exponents.
fn scaled(findings: &mut Findings) {
    const CASE: &str = "scaled by powers of two";
    const EXPONENTS: [i32; 8] = [-20, -13, -7, -1, 1, 7, 13, 20];
    let tested = "the workshop's scene (160x120, depth 8, ground k 0.3), turned, scaled by 2^-20, 2^-13, 2^-7, 2^-1, 2, 2^7, 2^13, 2^20; in f32 by both engines";
    let draft = placed(&workshop(160, 120, 8, 0.3));
    for formula in Formula::ALL {
        let as_stated = both(formula, &draft);
        let mut off = Vec::new();
        for exponent in EXPONENTS {
            let factor = f64::from(exponent).exp2();
            let mut draft = draft.clone();
            points(&mut draft, |x| x.map(|x| x * factor));
            draft.spheres.iter_mut().for_each(|sphere| sphere.radius *= factor);
            let found = both(formula, &draft);
            let pairs = found.iter().zip(&as_stated);
            off.push(pairs.filter(|(a, b)| a.map(f64::to_bits) != b.map(f64::to_bits)).count());
        }
        let each = off.iter().map(usize::to_string).collect::<Vec<_>>().join(", ");
        let sum = off.iter().sum::<usize>() as f64;
        findings.push(CASE, formula, tested, sum, format!("Pixels by factor: {each}."));
    }
}

/// The pictures of all engines, one after the other.
fn both(formula: Formula, draft: &Draft) -> Vec<[f64; 3]> {
    let mut pixels = formula.picture(draft).expect("depth 8");
    if formula != Formula::RobustF64 {
        let scene = formula.scene(draft);
        let grid = Grid::new(&View::whole(&scene));
        let mut film = Film::new(grid.width, grid.height);
        let compiled = Compiled::new(&scene);
        catoptric_reference::render(&compiled, &grid, &mut film, &|_| ()).expect("depth 8");
        pixels.extend(crate::metrics::widened(film.pixels()));
    }
    pixels
}

/// The lowest index is seen, so a second statement in another colour never shows.
fn twice(findings: &mut Findings) {
    const CASE: &str = "coincident surfaces";
    let tested = "the workshop's scene and a closed room with five balls (80x60, depth 20), turned; every surface stated again in another colour";
    let room = Room::default().draft().expect("the defaults are in range");
    for formula in Formula::ALL {
        let mut off = [0; 2];
        for (of_scene, once) in [workshop(80, 60, 20, 0.3), room.clone()].iter().enumerate() {
            let once = sized(placed(once), 80, 60, 20);
            let mut doubled = once.clone();
            doubled.spheres.extend(once.spheres.iter().rev().copied());
            for sphere in &mut doubled.spheres[once.spheres.len()..] {
                sphere.material = Material::matt([9.0, 0.0, 9.0]);
            }
            let found = picture_bits(formula, &doubled);
            let pairs = found.iter().zip(picture_bits(formula, &once));
            off[of_scene] = pairs.filter(|(a, b)| **a != *b).count();
        }
        let sentence = format!("Pixels that differ: workshop {}, room {}.", off[0], off[1]);
        findings.push(CASE, formula, tested, (off[0] + off[1]) as f64, sentence);
    }
}

fn picture_bits(formula: Formula, draft: &Draft) -> Vec<[u64; 3]> {
    let pixels = formula.picture(draft).expect("depth 20");
    pixels.iter().map(|pixel| pixel.map(f64::to_bits)).collect()
}
