//! Surfaces that all but touch: pairs with small gaps, shadows at a contact, and the surface
//! that a ray has just left.

use catoptric_scene::family::Draws;
use catoptric_scene::{DoubleDouble, Draft, Light, Sphere, View};

use super::super::exact::{self, Meeting, between, length, vector};
use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{PLACE, across, along, direction, dot, norm, placed, unit};
use super::super::rays::{Met, Rays, Start};
use super::scenes::{glossy, mirror, sized};
use crate::formula::Formula;
use catoptric_reference::truth::{Precision, Truth};

pub(crate) fn run(effort: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    gaps(effort, &mut findings);
    shadows(&mut findings);
    own_sphere(effort, &mut findings);
    findings.done()
}

/// Two spheres a gap apart, their contact seen from aside: rays that leave the first next to the
/// contact must meet the second, where it is.
fn gaps(effort: Effort, findings: &mut Findings) {
    const CASE: &str = "pairs, second hit";
    const RADII: [f64; 2] = [1.037, 0.831];
    const GAPS: [f64; 4] = [0.0, 1e-6, 1e-4, 1e-2];
    let tested = format!(
        "balls of radius {} and {} with gaps of 0, 1e-6, 1e-4 and 1e-2 radii, {} rays each that leave the first next to the contact",
        RADII[0], RADII[1], effort.rays
    );
    let axis = direction(&mut Draws::new(21));
    for formula in Formula::ALL {
        let mut wrong = [0_u64; 4];
        let mut asked = 0_u64;
        for (of_gap, gap) in GAPS.into_iter().enumerate() {
            // Two spheres on an axis, seen from the side of the contact.
            let mut draft = Draft::default();
            let draws = &mut Draws::new(22);
            draft.camera.position = PLACE;
            let view = across(draws, axis);
            let first = along(along(PLACE, view, 5.1), axis, -RADII[0]);
            let second = along(first, axis, RADII[0] * (1.0 + gap) + RADII[1]);
            draft.camera.look_at = along(PLACE, view, 1.0);
            draft.camera.up = axis;
            draft.render.max_depth = 0;
            let material = draft.materials.add(mirror(0.0));
            draft.spheres = [(first, RADII[0]), (second, RADII[1])]
                .map(|(center, radius)| Sphere { center, radius, material })
                .to_vec();
            // Count wrong answers among the rays that ask a sound question.
            let rays = Rays::new(formula, &draft);
            for _ in 0..effort.rays {
                if let Some(is_right) = second_hit(formula, draws, &draft, &rays, axis) {
                    wrong[of_gap] += u64::from(!is_right);
                    asked += 1;
                }
            }
        }
        let [a, b, c, d] = wrong;
        let shot = effort.rays * 4;
        let sentence = format!("By gap: {a}, {b}, {c}, {d}; {asked} of {shot} rays were asked.");
        let wrong = most_asked(asked, shot, wrong.iter().sum());
        findings.push(CASE, formula, &tested, wrong, sentence);
    }
}

/// The count of what is wrong; infinite if less than half of the rays were asked, which would
/// say nothing.
fn most_asked(asked: u64, shot: u64, wrong: u64) -> f64 {
    if 2 * asked >= shot { wrong as f64 } else { f64::INFINITY }
}

/// An eye ray to the first sphere next to the contact, and from there a ray to about the second;
/// whether that one finds what it must. `None` where the question is one of rounding.
fn second_hit(
    formula: Formula,
    draws: &mut Draws,
    draft: &Draft,
    rays: &Rays,
    axis: [f64; 3],
) -> Option<bool> {
    let [first, second] = [draft.spheres[0], draft.spheres[1]];
    let relative = |center: [f64; 3]| between(center, PLACE);
    // A point of the first sphere that the eye sees.
    let angle = draws.log_between(1e-3, 0.3);
    let to_eye = unit(std::array::from_fn(|i| PLACE[i] - first.center[i]));
    let aside = unit(along(to_eye, axis, -dot(to_eye, axis)));
    let normal = unit(along(axis, aside, angle));
    let at = along(first.center, normal, first.radius);
    let toward = unit(std::array::from_fn(|i| at[i] - PLACE[i]));
    let Met { primitive, point, start: leave, left, .. } =
        rays.first([0.0; 3], formula.rounded(toward))?;
    if primitive != 0 {
        return None;
    }
    // The point found, put on the sphere exactly.
    let found = vector(point);
    let out = exact::minus(found, relative(first.center));
    let start =
        exact::along(relative(first.center), out, DoubleDouble::from(first.radius) / length(out));
    // Through the second sphere, or past it.
    let way = direction(draws);
    let reach = second.radius * draws.between(0.0, 1.5);
    let target = along(second.center, way, reach);
    let target: [f64; 3] = std::array::from_fn(|i| target[i] - PLACE[i] - start[i].to_f64());
    let d = formula.rounded(unit(target));
    let leaves = dot(std::array::from_fn(|i| out[i].to_f64()), d);
    let meeting = Meeting::new(start, vector(d), relative(second.center), second.radius);
    let margin = 8.0 * formula.u() * 6.0;
    if leaves < 1e-3 || meeting.passes.abs() < margin {
        return None;
    }
    let ray = Start { origin: leave, direction: d, left };
    let next = rays.follow(ray).into_iter().next();
    Some(match (next, meeting.distance) {
        (None, None) => true,
        (Some(step), Some(exact)) => {
            let off = (step.distance - exact.to_f64()).abs();
            step.primitive == 1 && off < 1e-2 * second.radius
        }
        _ => false,
    })
}

/// Spheres that stand on a ground of radius 1e4: which pixels are lit.
fn shadows(findings: &mut Findings) {
    const GROUND: f64 = 10_003.7;
    let tested = "balls of radius 0.31, 0.83 and 1.67 tangent to a ground of radius 10003.7, 320x240 pixels, one lamp, ambient 0";
    let mut draft = Draft::default();
    draft.camera.position = [0.37, 2.13, 7.71];
    draft.camera.look_at = [0.11, 0.41, 0.23];
    draft.camera.fov = 43.0;
    draft.render.ambient = [0.0; 3];
    draft.lights.push(Light { position: [5.3, 9.1, 4.7], intensity: [1.0; 3] });
    // Spheres on a ground, all touching it, under one light.
    let ground = [0.0, -GROUND, 0.0];
    draft.spheres.push(Sphere {
        center: ground,
        radius: GROUND,
        material: draft.materials.add(glossy(0.0)),
    });
    for (x, z, radius) in [(-1.13, 0.57, 0.83), (0.41, 1.93, 0.31), (1.37, -0.79, 1.67)] {
        let up = unit([x, GROUND, z]);
        let center = along(ground, up, GROUND + radius);
        draft.spheres.push(Sphere { center, radius, material: draft.materials.add(glossy(0.0)) });
    }
    let draft = sized(placed(&draft), 320, 240, 0);
    // There is no ambient light, so a pixel in shadow is black.
    let scene = Formula::RobustF32.scene(&draft);
    let truth = Truth::new(&scene, Precision::DoubleDouble);
    let truth = truth.render(&View::whole(&scene)).expect("depth 0").pixels;
    let lit = |pixel: &[f64; 3]| pixel.iter().any(|&x| x > 0.0);
    let all = truth.iter().filter(|pixel| lit(pixel)).count();
    for formula in Formula::ALL {
        let found = formula.picture(&draft).expect("depth 0");
        let wrong = found.iter().zip(&truth).filter(|(a, b)| lit(a) != lit(b)).count();
        let share = wrong as f64 / truth.len() as f64;
        let sentence = format!("{wrong} of {} pixels; truth lights {all}.", truth.len());
        findings.push("contact shadows", formula, tested, share, sentence);
    }
}

/// Faults at a sphere that is alone in its scene: rays that leave it outwards and meet it again,
/// and lights that it hides from a point of it that faces them.
fn own_sphere(effort: Effort, findings: &mut Findings) {
    const CASE: &str = "own sphere met again";
    let rays_each = effort.rays / 10;
    let tested = format!(
        "a sphere of radius 1e-6, 1e-5 ... 1e6 seen from 2.7 and from 0.013 radii above it and, where it is smaller, from 3.1 units, {rays_each} eye rays each, half of them within 1e-7 to 1e-1 radii of the rim; from each hit the mirrored ray, a ray outwards at a cosine of 1e-9 to 1 and three lamps"
    );
    for formula in Formula::ALL {
        let (mut again, mut asked) = (Vec::new(), 0);
        for exponent in -6..=6 {
            let radius = 1.037 * 10_f64.powf(f64::from(exponent));
            let heights = [2.7, 0.013, if radius < 1.0 { 3.1 / radius } else { 2.7 }];
            let of_height =
                heights.map(|height| met_again(formula, &lone_sphere(radius, height), rays_each));
            again.push(of_height.iter().map(|(again, _)| again).sum::<u64>());
            asked += of_height.iter().map(|(_, asked)| asked).sum::<u64>();
        }
        let shot = rays_each * 3 * 13;
        let all = most_asked(asked, shot, again.iter().sum());
        let each = again.iter().map(u64::to_string).collect::<Vec<_>>().join(", ");
        let sentence = format!("By radius: {each}; {asked} of {shot} rays met the sphere.");
        findings.push(CASE, formula, &tested, all, sentence);
    }
}

/// A sphere in a generic direction, `height` radii below the eye, three lights about it.
fn lone_sphere(radius: f64, height: f64) -> Draft {
    let draws = &mut Draws::new(31);
    let down = direction(draws);
    let mut draft = Draft::default();
    draft.camera.position = PLACE;
    draft.camera.look_at = along(PLACE, down, radius);
    draft.camera.up = across(draws, down);
    let distance = radius * (1.0 + height);
    let half_angle = (0.7 / (1.0 + height)).asin();
    draft.camera.fov = half_angle.to_degrees();
    let center = along(PLACE, down, distance);
    draft.spheres.push(Sphere { center, radius, material: draft.materials.add(mirror(0.5)) });
    for _ in 0..3 {
        let position = along(center, direction(draws), 5.3 * radius);
        draft.lights.push(Light { position, intensity: [1.0; 3] });
    }
    sized(draft, 20, 10, 1)
}

/// How often, and of how many rays that met it at all.
fn met_again(formula: Formula, draft: &Draft, count: u64) -> (u64, u64) {
    let rays = Rays::new(formula, draft);
    let Sphere { center, radius, .. } = draft.spheres[0];
    let draws = &mut Draws::new(32);
    let (mut again, mut asked) = (0, 0);
    let to_center: [f64; 3] = std::array::from_fn(|i| center[i] - PLACE[i]);
    let (forward, distance) = (unit(to_center), norm(to_center));
    for index in 0..count {
        // Anywhere, and close to the rim, where the mirrored ray hardly leaves the sphere.
        let inside = if index % 2 == 0 { draws.unit() } else { draws.log_between(1e-7, 1e-1) };
        let miss = radius * (1.0 - inside);
        let slant = miss / ((distance - miss) * (distance + miss)).sqrt();
        let toward = unit(along(forward, across(draws, forward), slant));
        let toward = formula.rounded(toward);
        let steps = rays.follow(Start { origin: [0.0; 3], direction: toward, left: None });
        let Some(Met { point, start, left, lit, .. }) = steps.first() else { continue };
        asked += 1;
        again += u64::from(steps.len() > 1);
        // Outward for the sphere as stated, seen from the point that was found.
        let out = exact::minus(vector(*point), between(center, PLACE));
        let outward = unit(out.map(DoubleDouble::to_f64));
        let cosine = draws.log_between(1e-9, 1.0);
        let flat = across(draws, outward);
        let flat = flat.map(|x| x * (1.0 - cosine * cosine).sqrt());
        let way = formula.rounded(unit(along(flat, outward, cosine)));
        if exact::dot(out, vector(way)).to_f64() > 0.0 {
            let second = Start { origin: *start, direction: way, left: *left };
            again += u64::from(!rays.follow(second).is_empty());
        }
        for (lamp, lit) in draft.lights.iter().zip(lit) {
            let to_lamp = std::array::from_fn(|i| lamp.position[i] - PLACE[i] - point[i]);
            again += u64::from(dot(outward, unit(to_lamp)) > 0.5 && !lit);
        }
    }
    (again, asked)
}
