//! Generic positions. Neat numbers flatter: 10004^2, 20^2 and 1e8 are exact in f32.

use catoptric_scene::Draft;
use catoptric_scene::family::Draws;

/// The place of the cases' eye or middle, unless they say otherwise.
pub(crate) const PLACE: [f64; 3] = [12.345_67, -5.678_91, 8.912_34];

/// A unit vector, all directions alike.
pub(crate) fn direction(draws: &mut Draws) -> [f64; 3] {
    loop {
        let v = [0; 3].map(|_| draws.between(-1.0, 1.0));
        let length = norm(v);
        if (0.1..=1.0).contains(&length) {
            return v.map(|x| x / length);
        }
    }
}

/// A unit vector across a unit vector.
pub(crate) fn across(draws: &mut Draws, axis: [f64; 3]) -> [f64; 3] {
    loop {
        let v = direction(draws);
        let part = dot(v, axis);
        let rest: [f64; 3] = std::array::from_fn(|i| v[i] - part * axis[i]);
        let length = norm(rest);
        if length > 0.1 {
            return rest.map(|x| x / length);
        }
    }
}

/// a + b t.
pub(crate) fn along(a: [f64; 3], b: [f64; 3], t: f64) -> [f64; 3] {
    std::array::from_fn(|i| a[i] + b[i] * t)
}

pub(crate) fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

pub(crate) fn norm(v: [f64; 3]) -> f64 {
    dot(v, v).sqrt()
}

/// The unit vector of that direction.
pub(crate) fn unit(v: [f64; 3]) -> [f64; 3] {
    let length = norm(v);
    v.map(|x| x / length)
}

/// The scene turned about the origin, by about 50 degrees about a generic axis, then moved by
/// [`PLACE`].
pub(crate) fn placed(draft: &Draft) -> Draft {
    let mut placed = draft.clone();
    points(&mut placed, |x| along(turned(x), PLACE, 1.0));
    placed.camera.up = turned(placed.camera.up);
    for plane in &mut placed.planes {
        plane.normal = turned(plane.normal);
    }
    placed
}

/// Every point of the scene replaced.
pub(crate) fn points(draft: &mut Draft, of: impl Fn([f64; 3]) -> [f64; 3]) {
    draft.camera.position = of(draft.camera.position);
    draft.camera.look_at = of(draft.camera.look_at);
    draft.lights.iter_mut().for_each(|light| light.position = of(light.position));
    draft.spheres.iter_mut().for_each(|sphere| sphere.center = of(sphere.center));
    draft.planes.iter_mut().for_each(|plane| plane.point = of(plane.point));
}

/// Turned by the unit quaternion of these four numbers.
fn turned(v: [f64; 3]) -> [f64; 3] {
    const Q: [f64; 4] = [0.907_3, 0.271_3, -0.193_7, 0.256_1];
    let size = Q.iter().map(|x| x * x).sum::<f64>().sqrt();
    let [w, x, y, z] = Q.map(|part| part / size);
    let rows = [
        [1.0 - 2.0 * (y * y + z * z), 2.0 * (x * y - w * z), 2.0 * (x * z + w * y)],
        [2.0 * (x * y + w * z), 1.0 - 2.0 * (x * x + z * z), 2.0 * (y * z - w * x)],
        [2.0 * (x * z - w * y), 2.0 * (y * z + w * x), 1.0 - 2.0 * (x * x + y * y)],
    ];
    rows.map(|row| dot(row, v))
}
