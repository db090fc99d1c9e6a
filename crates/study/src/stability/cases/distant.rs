//! Spheres hardly larger than the rounding of their places, and rays along rims.

use catoptric_scene::family::Draws;
use catoptric_scene::{Draft, Sphere};

use super::super::exact::{Meeting, between, vector};
use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{PLACE, across, along, direction, norm, unit};
use super::super::rays::Rays;
use super::scenes::mirror;
use crate::formula::Formula;

pub(crate) fn run(effort: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    silhouettes(effort, &mut findings, "tiny far, r 1e-3", 1.037e-3, [1e2, 1e3, 1e4, 1e5]);
    silhouettes(effort, &mut findings, "tiny far, r 1", 1.037, [1e3, 1e4, 1e5, 1e6]);
    grazing(effort, &mut findings);
    findings.done()
}

/// A sphere that far from the eye, which is at [`PLACE`].
fn ball(radius: f64, distance: f64, seed: u64) -> Draft {
    let draws = &mut Draws::new(seed);
    let way = direction(draws);
    let mut draft = Draft::default();
    draft.camera.position = PLACE;
    draft.camera.look_at = along(PLACE, way, 1.0);
    draft.camera.up = across(draws, way);
    draft.render.max_depth = 0;
    let center = along(PLACE, way, distance);
    draft.spheres.push(Sphere { center, radius, material: draft.materials.add(mirror(0.0)) });
    draft
}

/// A ray in the formula's arithmetic that passes the sphere's centre at about `miss`, and how it
/// meets exactly. From the eye, or from somewhere within `spread` of it.
fn aimed(
    formula: Formula,
    draws: &mut Draws,
    draft: &Draft,
    [miss, spread]: [f64; 2],
) -> ([f64; 3], [f64; 3], Meeting) {
    let Sphere { center, radius, .. } = draft.spheres[0];
    let away = spread * draws.unit();
    let origin = formula.rounded(direction(draws).map(|x| x * away));
    let to_center = std::array::from_fn(|i| center[i] - PLACE[i] - origin[i]);
    let distance = norm(to_center);
    let forward = unit(to_center);
    let aside = across(draws, forward);
    // Through the point of the plane across the centre whose ray passes at `miss`.
    let slant = miss / (distance * distance - miss * miss).sqrt();
    let d = formula.rounded(unit(along(forward, aside, slant)));
    let center = between(center, PLACE);
    let meeting = Meeting::new(vector(origin), vector(d), center, radius);
    (origin, d, meeting)
}

/// Wrong decisions at the rim, and how far they were from it.
fn silhouettes(
    effort: Effort,
    findings: &mut Findings,
    case: &'static str,
    radius: f64,
    distances: [f64; 4],
) {
    let tested = format!(
        "radius {radius} at {:e}, {:e}, {:e} and {:e}, {} rays each about the rim, half of them from elsewhere than the eye",
        distances[0], distances[1], distances[2], distances[3], effort.rays
    );
    for formula in Formula::ALL {
        let (mut worst, mut false_hits, mut false_misses) = (0.0_f64, Vec::new(), 0_u64);
        for distance in distances {
            let draft = ball(radius, 1.234 * distance, 7);
            let rays = Rays::new(formula, &draft);
            let draws = &mut Draws::new(8);
            let unit = formula.u() * 1.234 * distance;
            let mut wrong = 0_u64;
            for index in 0..effort.rays {
                // Half about the rim as rounding sees it, half anywhere up to three radii.
                let miss = if index % 2 == 0 {
                    (radius + draws.between(-20.0, 20.0) * unit).abs()
                } else {
                    draws.between(0.0, 3.0 * radius)
                };
                let spread = if index % 4 < 2 { 0.0 } else { 0.1 * distance };
                // A wrong decision is measured by how far the exact ray passes from the rim.
                let (origin, d, meeting) = aimed(formula, draws, &draft, [miss, spread]);
                let hit = rays.first(origin, d).is_some();
                if hit != meeting.distance.is_some() {
                    worst = worst.max(meeting.passes.abs() / unit);
                    wrong += u64::from(hit);
                    false_misses += u64::from(!hit);
                }
            }
            false_hits.push(wrong.to_string());
        }
        let sentence = format!(
            "False hits by distance: {}; false misses in all: {false_misses}.",
            false_hits.join(", ")
        );
        findings.push(case, formula, &tested, worst, sentence);
    }
}

/// Rays that pass a sphere inside and outside its rim by 1e-2, 1e-4 and 1e-6 of its radius.
fn grazing(effort: Effort, findings: &mut Findings) {
    const RADIUS: f64 = 0.973;
    const DISTANCE: f64 = 17.31;
    const SHARES: [f64; 3] = [1e-2, 1e-4, 1e-6];
    let tested = format!(
        "radius {RADIUS} at {DISTANCE}, {} rays each that pass 1e-2, 1e-4 and 1e-6 radii inside and outside the rim",
        effort.rays
    );
    for formula in Formula::ALL {
        let draft = ball(RADIUS, DISTANCE, 9);
        let rays = Rays::new(formula, &draft);
        let (mut rim, mut distance_error) = (0.0_f64, 0.0_f64);
        let (mut wrong, mut absolute) = ([0_u64; 3], [0.0_f64; 3]);
        // Rays inside and outside the rim in turn, half of them from the eye.
        for (of_share, share) in SHARES.into_iter().enumerate() {
            let draws = &mut Draws::new(10);
            for index in 0..effort.rays {
                let side = if index % 2 == 0 { 1.0 + share } else { 1.0 - share };
                let spread = if index % 4 < 2 { 0.0 } else { 3.0 };
                let (origin, d, meeting) = aimed(formula, draws, &draft, [RADIUS * side, spread]);
                let unit = formula.u() * DISTANCE;
                // Distances are compared where both hit; one that hits alone is a wrong decision.
                match (rays.first(origin, d), meeting.distance) {
                    (Some(first), Some(exact)) => {
                        let error = (first.distance - exact.to_f64()).abs();
                        distance_error = distance_error.max(error * meeting.cosine / unit);
                        absolute[of_share] = absolute[of_share].max(error);
                    }
                    (None, None) => {}
                    _ => {
                        rim = rim.max(meeting.passes.abs() / unit);
                        wrong[of_share] += 1;
                    }
                }
            }
        }
        // Two findings: decisions at the rim, and distances.
        let [a, b, c] = wrong;
        let sentence = format!("Wrong decisions at 1e-2, 1e-4, 1e-6: {a}, {b}, {c}.");
        findings.push("grazing, rim", formula, &tested, rim, sentence);
        let [a, b, c] = absolute;
        let sentence =
            format!("Largest error of t at 1e-2, 1e-4, 1e-6: {a:.0e}, {b:.0e}, {c:.0e}.");
        findings.push("grazing, distance", formula, &tested, distance_error, sentence);
    }
}
