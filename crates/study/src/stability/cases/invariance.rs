//! What must change nothing: moving the scene, turning it, scaling it, a thing that no ray meets,
//! stating every surface twice.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::family::{Kissing, Room};
use catoptric_scene::{Compiled, Draft, Film, Grid, Material, Plane, Scene, Sphere, View};

use super::super::generic::{PLACE, along, dot, placed, points, unit};
use super::super::suite::{Effort, Finding, Findings};
use super::scenes::{sized, workshop};
use crate::formula::{Formula, pixels};
use crate::metrics::larger;
use crate::tracer::{Renders, Tracer};

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    moved(&mut findings);
    turned(&mut findings);
    unseen(&mut findings);
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

/// Turned by matrices of whole numbers, which f64 states exactly: so are a scene of coordinates
/// with few digits and the same turned, both made N times as large.
fn turned(findings: &mut Findings) {
    const QUATERNIONS: [[f64; 4]; 6] = [
        [1.0, 1.0, 0.0, 0.0],
        [1.0, 1.0, 1.0, 1.0],
        [2.0, 1.0, 0.0, 0.0],
        [3.0, -2.0, 1.0, 5.0],
        [1.0, 7.0, -4.0, 2.0],
        [4.0, 3.0, -9.0, -6.0],
    ];
    const CASES: [(&str, [f64; 3]); 2] = [
        ("turned, stated exactly", [0.0; 3]),
        ("turned and moved, stated exactly", [123_456_789.5, -9_876_543.25, 55_555_555.0]),
    ];
    let tested = "the workshop's scene (80x60, depth 8, ground k 0.3), kissing spheres and a far ball, coordinates rounded to 2^-10, made N times as large and turned by 6 matrices of whole numbers; by both engines";
    let scenes = turnable();
    for formula in Formula::ALL {
        for (case, shift) in CASES {
            let (mut sum, mut each) = (0, Vec::new());
            for quaternion in QUATERNIONS {
                let (rows, size) = whole_turn(quaternion);
                let of_scenes = scenes.iter().map(|draft| {
                    let grown =
                        both(formula, &mapped(draft, size, [0.0; 3], |v| v.map(|x| size * x)));
                    let turn = |v| rows.map(|row| dot(row, v));
                    let turned = both(formula, &mapped(draft, size, shift, turn));
                    differing(&grown, &turned)
                });
                let off = of_scenes.sum::<usize>();
                each.push(off.to_string());
                sum += off;
            }
            let sentence = format!("Pixels that differ, by matrix: {}.", each.join(", "));
            findings.push(case, formula, tested, sum as f64, sentence);
        }
    }
}

/// Scenes whose coordinates are multiples of 2^-10, so that no product of them is rounded.
fn turnable() -> [Draft; 3] {
    let kissing = Kissing::default().draft().expect("the defaults are in range");
    let mut far = workshop(80, 60, 8, 0.3);
    far.camera.position = [5e5, 3e5, 4e5];
    far.camera.look_at = far.spheres[1].center;
    far.camera.fov = 1e-3;
    [workshop(80, 60, 8, 0.3), sized(kissing, 80, 60, 8), far].map(|mut draft| {
        let grained = |x: f64| (x * 1024.0).round() / 1024.0;
        points(&mut draft, |v| v.map(grained));
        draft.camera.up = draft.camera.up.map(grained);
        draft.spheres.iter_mut().for_each(|sphere| sphere.radius = grained(sphere.radius));
        draft
    })
}

/// Everything `size` times as large; places and directions by `turn`, which does that too.
fn mapped(draft: &Draft, size: f64, shift: [f64; 3], turn: impl Fn([f64; 3]) -> [f64; 3]) -> Draft {
    let mut draft = draft.clone();
    points(&mut draft, |x| along(turn(x), shift, 1.0));
    draft.camera.up = turn(draft.camera.up);
    draft.planes.iter_mut().for_each(|plane| plane.normal = turn(plane.normal));
    draft.spheres.iter_mut().for_each(|sphere| sphere.radius *= size);
    draft
}

/// N times a rotation, in whole numbers, and N: the square of the quaternion's length.
fn whole_turn([a, b, c, d]: [f64; 4]) -> ([[f64; 3]; 3], f64) {
    let rows = [
        [a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)],
        [2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)],
        [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d],
    ];
    (rows, a * a + b * b + c * c + d * d)
}

/// Black things behind the eye, under a ground and in other things, near and very far.
fn unseen(findings: &mut Findings) {
    const CASE: &str = "unseen things";
    let tested = "the workshop's scene (80x60, depth 8, ground k 0.3), turned, with balls in its balls and its ground and a closed room with balls and planes outside, 1e-3 to 1e12 large; by both engines";
    let room = Room { balls: 3, ..Room::default() }.draft().expect("in range");
    let outside = room.spheres[0].radius;
    let room = sized(placed(&room), 80, 60, 8);
    let workshop = placed(&workshop(80, 60, 8, 0.3));
    let material = Material::matt([9.0, 0.0, 9.0]);
    let within = workshop.spheres.iter().flat_map(|sphere| {
        [0.5, 1e-2, 1e-4].map(|share| Sphere {
            center: sphere.center,
            radius: share * sphere.radius,
            material,
        })
    });
    let mut pairs: Vec<[Draft; 2]> = within
        .map(|sphere| {
            let mut more = workshop.clone();
            more.spheres.push(sphere);
            [workshop.clone(), more]
        })
        .collect();
    for exponent in -3..=12 {
        let size = 10_f64.powf(f64::from(exponent));
        let way = unit(PLACE);
        let mut more = room.clone();
        let center = along(room.spheres[0].center, way, 1.1 * (outside + size) + 1.0);
        more.spheres.push(Sphere { center, radius: size, material });
        pairs.push([room.clone(), more.clone()]);
        let point = along(room.spheres[0].center, way, 1.1 * outside + size);
        more.planes.push(Plane { point, normal: way, material });
        pairs.push([room.clone(), more]);
    }
    for formula in Formula::ALL {
        let off =
            pairs.iter().map(|[once, more]| differing(&both(formula, once), &both(formula, more)));
        let off: Vec<usize> = off.collect();
        let changed = off.iter().filter(|pixels| **pixels > 0).count();
        let sentence = format!("{changed} of {} things change a pixel.", off.len());
        findings.push(CASE, formula, tested, off.iter().sum::<usize>() as f64, sentence);
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

/// The pictures of both engines, one after the other.
fn both(formula: Formula, draft: &Draft) -> Vec<[f64; 3]> {
    fn recursion<S: Renders>(scene: &Scene) -> Vec<[f64; 3]> {
        let grid = Grid::of(&View::whole(scene));
        let mut film: Film<S> = Film::black(grid.width, grid.height);
        Tracer::Recursive.render(&Compiled::of(scene), &grid, &mut film).expect("depth 20");
        pixels(&film)
    }
    let mut both = formula.picture(draft).expect("depth 20");
    let scene = formula.scene(draft);
    both.extend(match formula {
        Formula::RobustF64 => recursion::<f64>(&scene),
        Formula::TextbookF32 | Formula::RobustF32 => recursion::<f32>(&scene),
    });
    both
}

/// The lowest index is seen, so a second statement in another colour never shows.
fn twice(findings: &mut Findings) {
    const CASE: &str = "coincident surfaces";
    let tested = "the workshop's scene and a closed room with five balls (80x60, depth 20), turned; every surface stated again in another colour; by both engines and by truth";
    let room = Room::default().draft().expect("the defaults are in range");
    let scenes = [workshop(80, 60, 20, 0.3), room].map(|once| {
        let once = sized(placed(&once), 80, 60, 20);
        let mut doubled = once.clone();
        doubled.spheres.extend(once.spheres.iter().rev().copied());
        for sphere in &mut doubled.spheres[once.spheres.len()..] {
            sphere.material = Material::matt([9.0, 0.0, 9.0]);
        }
        [once, doubled]
    });
    let truth = |draft: &Draft| {
        let scene = Formula::RobustF32.scene(draft);
        let truth = Truth::new(&scene, Precision::DoubleDouble);
        truth.render(&View::whole(&scene)).expect("depth 20").pixels
    };
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

/// Pixels with other bits.
fn differing(a: &[[f64; 3]], b: &[[f64; 3]]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a.map(f64::to_bits) != b.map(f64::to_bits)).count()
}
