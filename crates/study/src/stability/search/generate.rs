//! A scene for each seed: sizes, distances, heights, fields of view and places drawn log-uniformly
//! over as many decades as the format takes, seen so that something of it is in the picture.
//!
//! A subject, a sphere or a plane, and the eye at any distance from it: from far, from close to
//! its surface, from inside. Up to four more things stand about it, about the eye, at what the eye
//! sees of the subject, behind the eye, or around everything. Lights stand near and far. The whole
//! lies along the axes, or turned by neat numbers, or any way; with the eye at the origin, or the
//! subject, or neither.

use catoptric_scene::family::Draws;
use catoptric_scene::{Draft, Light, Material, Plane, Sphere};

use super::super::generic::{across, along, direction, norm, unit};

/// Neat unit vectors: ratios of whole numbers, and half a right angle.
const NEAT: [[f64; 3]; 6] = [
    [0.6, 0.0, 0.8],
    [0.0, 0.28, -0.96],
    [1.0 / 3.0, 2.0 / 3.0, 2.0 / 3.0],
    [2.0 / 7.0, -3.0 / 7.0, 6.0 / 7.0],
    [0.0, std::f64::consts::FRAC_1_SQRT_2, std::f64::consts::FRAC_1_SQRT_2],
    [-4.0 / 9.0, 4.0 / 9.0, 7.0 / 9.0],
];

/// Farther apart than this nothing is placed.
const FAR: f64 = 1e14;

/// The draft of a seed; a few are no scenes.
pub(super) fn draft(seed: u64) -> Draft {
    let draws = &mut Draws::new(seed);
    let mut draft = Draft::default();
    (draft.image.width, draft.image.height) = one(draws, [(13, 9), (16, 8), (9, 12)]);
    draft.render.max_depth = one(draws, [0, 1, 2, 3, 6]);
    draft.render.background = [0.2, 0.25, 0.4];

    // Sizes and gaps of any magnitude, ordinary ones more often.
    let size = match draws.below(3) {
        0 => 1.0,
        1 => draws.log_between(1e-3, 1e3),
        _ => draws.log_between(1e-12, 1e12),
    };
    // From the eye to the subject's nearest point.
    let toward = orientation(draws);
    let gap = match draws.below(4) {
        0 => size * draws.log_between(0.1, 10.0),
        1 => size * draws.log_between(1e-9, 0.1),
        _ => size * draws.log_between(10.0, 1e12),
    };
    let gap = if gap > FAR { FAR } else { gap };
    let flat = draws.below(8) == 0;
    // Inside the subject the eye is less than a radius from its surface.
    let inside = !flat && draws.below(6) == 0;
    let gap = if inside { size * draws.log_between(1e-9, 1.0) } else { gap };
    let to_center = if inside { gap - size } else { gap + size };
    let eye = match draws.below(3) {
        0 => [0.0; 3],
        1 => along([0.0; 3], toward, -to_center),
        _ => {
            let off = draws.log_between(1e-6, 1e6) * if gap > size { gap } else { size };
            along([0.0; 3], direction(draws), if off > FAR { FAR } else { off })
        }
    };
    // The subject: a plane or a sphere, nearest to the eye at `nearest`.
    let nearest = along(eye, toward, gap);
    if flat {
        let aside = across(draws, toward);
        let point = along(nearest, aside, one(draws, [0.0, 1.0, 1e3]) * gap);
        let normal = toward.map(|x| -x);
        draft.planes.push(Plane { point, normal, material: draft.materials.add(material(draws)) });
    } else {
        let center = along(eye, toward, to_center);
        draft.spheres.push(Sphere {
            center,
            radius: size,
            material: draft.materials.add(material(draws)),
        });
    }
    // Other things about it, near or far, and one or two lights.
    camera(draws, &mut draft, eye, toward, gap, if flat { 1e3 * gap } else { size });
    for _ in 0..draws.below(5) {
        another(draws, &mut draft, nearest, size, gap);
    }
    for _ in 0..1 + draws.below(2) {
        let reach = one(draws, [size, gap, if size < gap { size } else { gap }]);
        let from = one(draws, [nearest, eye]);
        let way = if draws.below(3) == 0 { toward.map(|x| -x) } else { direction(draws) };
        let position = along(from, way, reach * draws.log_between(1e-3, 1e6));
        draft.lights.push(Light { position, intensity: [0.7, 0.8, 0.75] });
    }
    draft
}

fn one<T: Copy, const N: usize>(draws: &mut Draws, of: [T; N]) -> T {
    of[usize::try_from(draws.below(N as u64)).expect("an index")]
}

/// Along an axis, by neat numbers, or any way.
fn orientation(draws: &mut Draws) -> [f64; 3] {
    let sign = one(draws, [-1.0, 1.0]);
    let way = match draws.below(6) {
        0 | 1 => one(draws, [[1.0, 0.0, 0.0], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]]),
        2 => one(draws, NEAT),
        _ => direction(draws),
    };
    way.map(|x| sign * x)
}

/// Looks at the subject, which fills some part of the picture; or along its surface.
fn camera(
    draws: &mut Draws,
    draft: &mut Draft,
    eye: [f64; 3],
    toward: [f64; 3],
    gap: f64,
    size: f64,
) {
    let aside = across(draws, toward);
    // How wide the subject is seen, as a tangent, no more than some 60 degrees.
    let seen = size / (gap * (gap + 2.0 * size)).sqrt();
    let seen = if seen > 1.7 { 1.7 } else { seen };
    let half = match draws.below(4) {
        0 => seen * draws.log_between(1e-6, 1.0),
        1 => draws.between(0.05, 1.2),
        _ => seen * draws.log_between(0.1, 3.0),
    };
    // Within what is seen of the subject, at its rim, or along its surface.
    let share = match draws.below(4) {
        0 => 0.0,
        1 => draws.between(0.0, 1.0),
        2 => 1.0,
        _ => draws.between(0.0, 2.0),
    };
    let view = unit(along(toward, aside, share * seen));
    draft.camera.position = eye;
    draft.camera.look_at = along(eye, view, gap * draws.log_between(1e-2, 1e2));
    draft.camera.up = match draws.below(3) {
        0 => one(draws, [[0.0, 1.0, 0.0], [0.0, 0.0, 1.0], [1.0, 0.0, 0.0]]),
        _ => across(draws, view),
    };
    draft.camera.fov = 2.0 * half.atan().to_degrees();
}

fn another(draws: &mut Draws, draft: &mut Draft, nearest: [f64; 3], size: f64, gap: f64) {
    let eye = draft.camera.position;
    let scale = one(draws, [size, gap, if size < gap { size } else { gap }]);
    let way = orientation(draws);
    let factor = match draws.below(3) {
        0 => 1.0,
        1 => draws.log_between(1e-3, 1.0),
        _ => draws.log_between(1.0, 1e6),
    };
    let radius = scale * factor;
    let radius = radius.clamp(1e-12, 1e12);
    let material = material(draws);
    if draws.below(5) == 0 {
        let height = scale * draws.log_between(1e-3, 1e6);
        let from = one(draws, [nearest, eye]);
        let point = along(from, way, if height > FAR { FAR } else { height });
        draft.planes.push(Plane { point, normal: way, material: draft.materials.add(material) });
        return;
    }
    let center = match draws.below(6) {
        // Touching or nearly, at what is seen of the subject.
        0 | 1 => along(nearest, way, radius * draws.between(0.5, 3.0)),
        // Anywhere about the subject, or about the eye.
        2 => along(nearest, way, radius + scale * draws.log_between(1e-3, 1e6)),
        3 => along(eye, way, radius + scale * draws.log_between(1e-6, 1e6)),
        // Beside the way from the eye to the subject.
        4 => {
            let view: [f64; 3] = std::array::from_fn(|i| nearest[i] - eye[i]);
            let view = if norm(view) > 0.0 { unit(view) } else { way };
            along(along(eye, view, gap * draws.unit()), across(draws, view), 1.5 * radius)
        }
        // Around the eye.
        _ => along(eye, way, radius * draws.unit()),
    };
    draft.spheres.push(Sphere { center, radius, material: draft.materials.add(material) });
}

/// Matt, glossy or a mirror; never so bright that the picture's floor drowns all else.
fn material(draws: &mut Draws) -> Material {
    let color = [0; 3].map(|_| draws.between(0.2, 0.9));
    let mut material = Material::matt(color);
    if draws.below(3) == 0 {
        material.specular = draws.between(0.1, 0.6);
        material.shininess = one(draws, [1.0, 20.0, 200.0]);
    }
    material.reflect = Some(one(draws, [0.0, 0.0, 0.4, 0.9]));
    material
}
