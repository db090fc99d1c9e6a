//! Things of very different sizes and distances in one picture, and narrow views from afar.

use catoptric_scene::{Draft, Light, Material, Plane, Sphere};

use super::super::backward::Judge;
use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{PLACE, along, points, unit};
use super::scenes::{sized, workshop};
use crate::formula::Formula;
use crate::metrics::larger;

/// Scenes of one kind, judged together.
struct Kind {
    /// Pixels off by more than a level, and the backward ratio by all input.
    cases: [&'static str; 2],
    tested: String,
    scenes: Vec<Draft>,
}

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    for kind in [unseen_balls(), far_things(), oblique_views(), small_balls()] {
        measured(&mut findings, &kind);
    }
    findings.done()
}

fn measured(findings: &mut Findings, kind: &Kind) {
    let judges = kind.scenes.iter().map(|draft| {
        let judge = Judge::new(&Formula::RobustF32.scene(draft)).expect("few reflections");
        (draft, judge)
    });
    let judges: Vec<_> = judges.collect();
    for formula in Formula::ALL {
        let (mut off, mut worst, mut each) = (0, 0.0, Vec::new());
        for (draft, judge) in &judges {
            let picture = formula.picture(draft).expect("few reflections");
            let found = judge.judge_as(formula, &picture).expect("few reflections");
            off += found.raw.off_by_more;
            worst = larger(worst, found.by_input);
            each.push(format!("{:.1e}", found.by_input));
        }
        let [levels, backward] = kind.cases;
        let sentence = format!("Ratios by scene: {}.", each.join(", "));
        findings.push(levels, formula, &kind.tested, off as f64, sentence.clone());
        let sentence = format!("{off} pixels off by more than a level. {sentence}");
        findings.push(backward, formula, &kind.tested, worst, sentence);
    }
}

/// A sphere on a large ground, and a black moon far behind the eye.
fn unseen_balls() -> Kind {
    const GROUNDS: [f64; 4] = [6_371_000.0, 217.0, 44.0, 2.0];
    let scenes = GROUNDS.map(|radius| {
        let mut draft = Draft::default();
        draft.camera.position = [0.0, 1.7, 6.0];
        draft.camera.look_at = [0.0, 0.8, 0.0];
        draft.camera.fov = 40.0;
        draft.render.background = [0.6, 0.7, 0.9];
        draft.lights.push(Light { position: [30.0, 50.0, 20.0], intensity: [1.0; 3] });
        let mut ball = |center, radius, color| {
            draft.spheres.push(Sphere {
                center,
                radius,
                material: draft.materials.add(Material::matt(color)),
            });
        };
        ball([0.0, -radius, 0.0], radius, [0.4, 0.5, 0.3]);
        ball([0.0, 1.0, 0.0], 1.0, [0.9, 0.3, 0.2]);
        ball([0.0, 0.0, 5e7], 1_737_000.0, [0.0; 3]);
        sized(draft, 160, 120, 5)
    });
    Kind {
        cases: ["unseen ball, levels", "unseen ball, by input"],
        tested: "a ball of radius 1 on grounds of 6371000, 217, 44 and 2, a black moon of 1737000 behind the eye at 5e7 (160x120)".to_owned(),
        scenes: scenes.to_vec(),
    }
}

/// The workshop's scene under a dome, before a far plane, and with a sphere far away.
fn far_things() -> Kind {
    let material = Material::matt([0.3, 0.5, 0.9]);
    let [mut dome, mut wall, mut planet] = [0; 3].map(|_| workshop(160, 120, 5, 0.0));
    dome.spheres.push(Sphere {
        center: [0.0, 0.0, -20.0],
        radius: 1e4,
        material: dome.materials.add(material),
    });
    wall.planes.push(Plane {
        point: [0.0, 0.0, -1e6],
        normal: [0.0, 0.0, 1.0],
        material: wall.materials.add(material),
    });
    planet.spheres.push(Sphere {
        center: [3e7, 4e7, -9e7],
        radius: 1e7,
        material: planet.materials.add(material),
    });
    Kind {
        cases: ["far things, levels", "far things, by input"],
        tested: "the workshop's scene (160x120, depth 5) under a dome of radius 10 000, before a plane a million away, with a planet of 1e7 at 1e8".to_owned(),
        scenes: vec![dome, wall, planet],
    }
}

/// Ways along which far things are seen: along an axis, aslant by neat numbers, by no neat ones.
fn ways() -> [[f64; 3]; 4] {
    let half = std::f64::consts::FRAC_1_SQRT_2;
    [[0.0, 0.0, 1.0], [-1.0, 0.0, 0.0], [0.0, half, half], unit(PLACE)]
}

/// A sphere at the origin that fills most of the picture; the eye is so many radii away. Its light
/// stands about the sphere or about the eye.
fn far_ball(way: [f64; 3], radius: f64, distance: f64, lamp_at_eye: bool) -> Draft {
    let mut draft = Draft::default();
    draft.camera.position = way.map(|x| x * distance);
    draft.camera.look_at = [0.0; 3];
    draft.camera.up = [0.13, 0.92, 0.37];
    draft.camera.fov = 2.0 * (1.25 * radius / distance).atan().to_degrees();
    draft.render.background = [0.2, 0.2, 0.3];
    let lamp = if lamp_at_eye {
        along(draft.camera.position, [3.0, 4.0, 5.0], 1e-7 * distance)
    } else {
        // Far enough that rounding the sphere's distance does not move its light.
        [3.0, 4.0, 5.0].map(|x| x * distance)
    };
    draft.lights.push(Light { position: lamp, intensity: [1.0; 3] });
    let material = Material::matt([0.8; 3]);
    draft.spheres.push(Sphere {
        center: [0.0; 3],
        radius,
        material: draft.materials.add(material),
    });
    sized(draft, 61, 61, 5)
}

fn oblique_views() -> Kind {
    let mut scenes = Vec::new();
    for distance in [1e3, 7.071_067_8e5, 1e7, 1e10] {
        scenes.extend(ways().map(|way| far_ball(way, 1.0, distance, true)));
    }
    Kind {
        cases: ["far oblique, levels", "far oblique, by input"],
        tested: "a ball of radius 1 that fills the picture (61x61) from 1e3, 7e5, 1e7 and 1e10, each along two axes and two ways aslant".to_owned(),
        scenes,
    }
}

fn small_balls() -> Kind {
    let mut scenes = Vec::new();
    for (radius, distance) in [(0.1, 1e7), (1e-3, 1e5), (1e-9, 1.0), (10.0, 1e10), (1e3, 1e11)] {
        for lamp_at_eye in [true, false] {
            scenes.extend(ways().map(|way| far_ball(way, radius, distance, lamp_at_eye)));
        }
    }
    // Far from the origin, as far as f64 can state the sphere.
    let mut elsewhere = far_ball(ways()[3], 0.1, 1e6, true);
    points(&mut elsewhere, |x| along(x, [1.0, -2.0, 0.5], 1e6));
    scenes.push(elsewhere);
    Kind {
        cases: ["far small, levels", "far small, by input"],
        tested: "lit balls a hundred million times as far as they are large, radii 1e-9 to 1e3, lamps about the eye and beyond (61x61)".to_owned(),
        scenes,
    }
}
