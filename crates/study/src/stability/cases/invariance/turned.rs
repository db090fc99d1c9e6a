//! The scene turned, and turned and moved, as f64 states it exactly.

use catoptric_scene::Draft;
use catoptric_scene::family::Kissing;

use super::super::super::finding::Findings;
use super::super::super::generic::{along, dot, points};
use super::super::scenes::{sized, workshop};
use super::engines::{both, differing};
use crate::formula::Formula;

/// Turned by matrices of whole numbers, which f64 states exactly: so are a scene of coordinates
/// with few digits and the same turned, both made N times as large.
pub(super) fn run(findings: &mut Findings) {
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
                // The matrix is whole, so it scales too: compare with the scene grown alike.
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
