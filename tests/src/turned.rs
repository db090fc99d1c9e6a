//! Scenes turned and moved so that f64 states it exactly.
//!
//! A quaternion of whole numbers a, b, c, d gives a matrix of whole numbers that turns, and makes
//! everything N = a² + b² + c² + d² times as large. A scene whose coordinates have few digits is
//! made N times as large as it stands, and by the matrix: the two are the same scene turned.

use catoptric_scene::{Draft, Numerics, Scene};
use proptest::prelude::*;

use crate::generate;

/// Coordinates are whole multiples of this: with matrix and move they need less than 53 bits.
const GRAIN: f64 = 1.0 / 4096.0;

/// A scene, and the same turned and moved.
pub fn pair() -> impl Strategy<Value = [Scene; 2]> {
    let quaternion = prop::array::uniform4(-5i32..=5).prop_filter("not zero", |q| *q != [0; 4]);
    let moved = prop_oneof![
        1 => Just([0.0; 3]),
        2 => prop::array::uniform3(-(1i64 << 32)..1i64 << 32).prop_map(|v| v.map(whole)),
    ];
    (generate::scene(8, (1u32..=24, 1u32..=18)), quaternion, moved).prop_filter_map(
        "a valid scene after rounding",
        |(scene, quaternion, moved)| {
            let mut draft = scene.into_draft();
            draft.render.numerics = Numerics::Robust;
            let (rows, size) = matrix(quaternion.map(f64::from));
            let grown = |v: [f64; 3]| grained(v).map(|x| size * x);
            let turned = |v: [f64; 3]| {
                let v = grained(v);
                rows.map(|row| row[0] * v[0] + row[1] * v[1] + row[2] * v[2])
            };
            let place = |v| {
                let v = turned(v);
                [0, 1, 2].map(|i| v[i] + moved[i])
            };
            let as_stated = mapped(&draft, size, grown, grown);
            let elsewhere = mapped(&draft, size, place, turned);
            Some([Scene::new(as_stated).ok()?, Scene::new(elsewhere).ok()?])
        },
    )
}

/// The draft with all places, directions and radii replaced.
fn mapped(
    draft: &Draft,
    size: f64,
    place: impl Fn([f64; 3]) -> [f64; 3],
    direction: impl Fn([f64; 3]) -> [f64; 3],
) -> Draft {
    let mut draft = draft.clone();
    draft.camera.position = place(draft.camera.position);
    draft.camera.look_at = place(draft.camera.look_at);
    draft.camera.up = direction(draft.camera.up);
    for light in &mut draft.lights {
        light.position = place(light.position);
    }
    for sphere in &mut draft.spheres {
        sphere.center = place(sphere.center);
        sphere.radius = size * grained([sphere.radius, 0.0, 0.0])[0];
    }
    for plane in &mut draft.planes {
        plane.point = place(plane.point);
        plane.normal = direction(plane.normal);
    }
    draft
}

fn grained(v: [f64; 3]) -> [f64; 3] {
    v.map(|x| (x / GRAIN).round() * GRAIN)
}

/// Times N a rotation, and N.
fn matrix([a, b, c, d]: [f64; 4]) -> ([[f64; 3]; 3], f64) {
    let rows = [
        [a * a + b * b - c * c - d * d, 2.0 * (b * c - a * d), 2.0 * (b * d + a * c)],
        [2.0 * (b * c + a * d), a * a - b * b + c * c - d * d, 2.0 * (c * d - a * b)],
        [2.0 * (b * d - a * c), 2.0 * (c * d + a * b), a * a - b * b - c * c + d * d],
    ];
    (rows, a * a + b * b + c * c + d * d)
}

#[expect(clippy::cast_precision_loss, reason = "33 bits are exact in f64")]
fn whole(n: i64) -> f64 {
    n as f64 * GRAIN
}
