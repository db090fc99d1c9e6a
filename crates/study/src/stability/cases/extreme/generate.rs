//! A scene for each seed: magnitudes log-uniform over all that the format takes and the ends of
//! every range; now and then a number that it does not take.

use catoptric_scene::family::Draws;
use catoptric_scene::{Camera, Draft, Light, Material, Plane, Sphere};

use super::super::super::generic::{across, along, direction, norm, unit};

/// What no key takes, or hardly any.
const ODD: [f64; 8] =
    [f64::NAN, f64::INFINITY, f64::NEG_INFINITY, -1.0, -1e-300, f64::MAX, 3.5e38, 2e15];

/// Amounts of light and factors at which something changes.
const AMOUNTS: [f64; 10] = [0.0, 5e-324, 1e-45, 1.2e-38, 1e-30, 1.0, 2.0, 1e6, 1e10, 1e20];

/// Exponents at which the formula changes.
const EXPONENTS: [f64; 10] =
    [0.0, 5e-324, 1e-30, 0.5, 1.0, 1023.0, 1024.0, 1024.5, 1e30, f32::MAX as f64];

/// Mirror factors: none, the least, one step below 1 in f64 and in f32, and 1.
const MIRRORS: [f64; 7] =
    [0.0, 5e-324, 1e-45, 0.5, 1.0 - f64::EPSILON / 2.0, 1.0 - f32::EPSILON as f64 / 2.0, 1.0];

/// Degrees near the ends.
const FIELDS: [f64; 9] =
    [5e-324, 1e-38, 1e-35, 1e-10, 1e-3, 179.0, 179.999_999, 180.0_f64.next_down(), 180.0];

/// The draft of a seed, valid or not.
pub(super) fn draft(seed: u64) -> Draft {
    let draws = &mut Draws::new(seed);
    let mut draft = Draft::default();
    (draft.image.width, draft.image.height) = one(draws, [(3, 1), (2, 2)]);
    draft.render.max_depth = u32::try_from(draws.below(9)).expect("at most 8");
    draft.render.min_weight = one(draws, [0.0, 0.0, 0.0, 1e-30, 0.5, 1.0]);
    draft.render.background = colour(draws);
    draft.render.ambient = colour(draws);

    // Most scenes have one size, or next to no ray would meet anything.
    let size = draws.log_between(1e-12, 1e12);
    let position = point(draws, size);
    for _ in 0..draws.below(5) {
        let radius = radius(draws, size);
        let center = center(draws, &draft.spheres, position, size, radius);
        draft.spheres.push(Sphere {
            center,
            radius,
            material: draft.materials.add(material(draws)),
        });
    }
    for _ in 0..draws.below(3) {
        let normal = direction(draws);
        let (away, length) = (size * draws.between(-1.0, 1.0), length(draws));
        let point = along(position, normal, away);
        let normal = normal.map(|x| x * length);
        draft.planes.push(Plane { point, normal, material: draft.materials.add(material(draws)) });
    }
    for _ in 0..draws.below(3) {
        let position = lamp(draws, &draft.spheres, position, size);
        draft.lights.push(Light { position, intensity: colour(draws) });
    }
    draft.camera = camera(draws, &draft.spheres, position, size);
    // Some scenes get a number that is hardly allowed, or not at all.
    if draws.below(12) == 0 {
        spoil(draws, &mut draft);
    }
    draft
}

fn one<T: Copy, const N: usize>(draws: &mut Draws, of: [T; N]) -> T {
    of[usize::try_from(draws.below(N as u64)).expect("an index")]
}

fn sign(draws: &mut Draws) -> f64 {
    one(draws, [-1.0, 1.0])
}

/// Any coordinate.
fn coordinate(draws: &mut Draws) -> f64 {
    match draws.below(6) {
        0 => 0.0,
        1 => sign(draws) * 1e15,
        2 => one(draws, [-0.0, 5e-324, 1.0, 16_777_217.0, 1e-15]),
        _ => sign(draws) * draws.log_between(1e-15, 1e15),
    }
}

/// A place in a scene of that size, or anywhere.
fn point(draws: &mut Draws, size: f64) -> [f64; 3] {
    match draws.below(5) {
        0 => [0; 3].map(|_| coordinate(draws)),
        1 => [0.0; 3],
        _ => [0; 3].map(|_| size * draws.between(-3.0, 3.0)),
    }
}

fn radius(draws: &mut Draws, size: f64) -> f64 {
    match draws.below(8) {
        0 => draws.log_between(1e-12, 1e12),
        1 => one(draws, [1e-12, 1e12, 1e-13, 1e13, 1.0]),
        _ => size * draws.log_between(1e-3, 1e3),
    }
}

/// Around the eye, under it, before it, on another sphere, or anywhere.
fn center(draws: &mut Draws, others: &[Sphere], eye: [f64; 3], size: f64, radius: f64) -> [f64; 3] {
    let way = direction(draws);
    match draws.below(8) {
        0 => along(eye, way, radius),
        1 => along(eye, way, radius * draws.unit()),
        2 => eye,
        3 => point(draws, size),
        4 | 5 if !others.is_empty() => {
            let other =
                others[usize::try_from(draws.below(others.len() as u64)).expect("an index")];
            let apart = one(draws, [0.0, other.radius + radius, other.radius - radius]);
            along(other.center, way, apart)
        }
        _ => along(eye, way, radius + size * draws.unit()),
    }
}

/// Inside a sphere, at its surface, just behind it, at the eye, or anywhere.
fn lamp(draws: &mut Draws, balls: &[Sphere], eye: [f64; 3], size: f64) -> [f64; 3] {
    let Some(ball) = balls.first() else { return point(draws, size) };
    let toward: [f64; 3] = std::array::from_fn(|i| eye[i] - ball.center[i]);
    let toward = if norm(toward) > 0.0 { unit(toward) } else { direction(draws) };
    match draws.below(6) {
        0 => along(ball.center, direction(draws), ball.radius),
        1 => along(ball.center, toward, ball.radius),
        2 => along(ball.center, toward, ball.radius * draws.between(0.9, 1.1)),
        3 => ball.center,
        4 => eye,
        _ => point(draws, size),
    }
}

fn amount(draws: &mut Draws) -> f64 {
    match draws.below(20) {
        0 => one(draws, AMOUNTS),
        1 => draws.log_between(1e-40, 3e38),
        2 => 0.0,
        _ => draws.unit(),
    }
}

fn colour(draws: &mut Draws) -> [f64; 3] {
    [0; 3].map(|_| amount(draws))
}

fn material(draws: &mut Draws) -> Material {
    let shininess = match draws.below(3) {
        0 => one(draws, EXPONENTS),
        1 => draws.log_between(1e-6, 1e30),
        _ => draws.between(0.0, 300.0),
    };
    let reflect = match draws.below(4) {
        0 => None,
        1 => Some(draws.unit()),
        _ => Some(one(draws, MIRRORS)),
    };
    let (color, diffuse, specular) = (colour(draws), amount(draws), amount(draws));
    Material { color, diffuse, specular, shininess, reflect }
}

/// The length of a direction that may have any.
fn length(draws: &mut Draws) -> f64 {
    match draws.below(4) {
        0 => one(draws, [5e-324, 1e-200, 1e-38, 1e38, 1e200, 1e308]),
        _ => 1.0,
    }
}

fn camera(draws: &mut Draws, balls: &[Sphere], position: [f64; 3], size: f64) -> Camera {
    let way = direction(draws);
    let look_at = match (draws.below(4), balls.last()) {
        (0, _) => along(position, way, draws.log_between(1e-12, 1e12)),
        (1, _) | (_, None) => point(draws, size),
        (_, Some(ball)) => along(ball.center, way, 0.5 * ball.radius),
    };
    let view: [f64; 3] = std::array::from_fn(|i| look_at[i] - position[i]);
    let axis = if norm(view) > 0.0 && norm(view).is_finite() { unit(view) } else { way };
    let tilt = match draws.below(4) {
        // Up nearly along the view: refused below a sine of 1e-8.
        0 => draws.log_between(1e-10, 1e-6),
        _ => 1.0,
    };
    let long = length(draws);
    let up = along(axis, across(draws, axis), tilt).map(|x| x * long);
    let fov = match draws.below(4) {
        0 => one(draws, FIELDS),
        1 => draws.log_between(1e-36, 179.0),
        _ => draws.between(1.0, 120.0),
    };
    Camera { position, look_at, up, fov }
}

/// One number replaced by one that its key hardly takes.
fn spoil(draws: &mut Draws, draft: &mut Draft) {
    let odd = one(draws, ODD);
    let axis = usize::try_from(draws.below(3)).expect("an axis");
    match draws.below(10) {
        0 => draft.camera.position[axis] = odd,
        1 => draft.camera.look_at[axis] = odd,
        2 => draft.camera.up[axis] = odd,
        3 => draft.camera.fov = odd,
        4 => draft.render.background[axis] = odd,
        5 => draft.lights.iter_mut().for_each(|light| light.position[axis] = odd),
        6 => draft.lights.iter_mut().for_each(|light| light.intensity[axis] = odd),
        7 => draft.spheres.iter_mut().for_each(|sphere| sphere.radius = odd),
        8 => (draft.spheres.iter())
            .for_each(|sphere| draft.materials[sphere.material].reflect = Some(odd)),
        _ => draft.planes.iter_mut().for_each(|plane| plane.normal[axis] = odd),
    }
}
