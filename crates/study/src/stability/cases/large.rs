//! Large spheres, seen from near their surface.

use catoptric_scene::family::Draws;
use catoptric_scene::{Draft, Sphere};

use super::super::exact::{Meeting, Vector, between, length, minus, vector};
use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{PLACE, across, along, direction, norm, unit};
use super::super::rays::Rays;
use super::scenes::mirror;
use crate::formula::Formula;
use crate::metrics::larger;

/// The eye's height over the ground.
const HEIGHT: f64 = 4.123_4;

/// The eye's heights over other large spheres.
const HEIGHTS: [f64; 3] = [0.372_9, 4.123_4, 41.71];

pub(crate) fn run(effort: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    ground(effort, &mut findings, "ground, generic origins", [0.1, 30.0]);
    ground(effort, &mut findings, "ground, near-surface origins", [1e-5, 0.1]);
    residuals(effort, &mut findings);
    findings.done()
}

/// A sphere below the eye, which is at [`PLACE`]; `down` is where its centre is.
fn sphere_below(radius: f64, height: f64, down: [f64; 3]) -> Draft {
    let mut draft = Draft::default();
    let center = along(PLACE, down, radius + height);
    draft.camera.position = PLACE;
    draft.camera.look_at = along(PLACE, down, 1.0);
    draft.camera.up = across(&mut Draws::new(3), down);
    draft.render.max_depth = 0;
    draft.spheres.push(Sphere { center, radius, material: draft.materials.add(mirror(0.0)) });
    draft
}

/// A ray relative to the eye, in the formula's arithmetic, that starts outside of the sphere at
/// a height between `heights`, within 50 units of the eye's foot, and goes down; and how that
/// very ray meets. `None` where rounding made it start inside, or pass.
fn ray_down(
    formula: Formula,
    draws: &mut Draws,
    draft: &Draft,
    heights: [f64; 2],
) -> Option<([f64; 3], [f64; 3], Meeting)> {
    let Sphere { center, radius, .. } = draft.spheres[0];
    let to_center: [f64; 3] = std::array::from_fn(|i| center[i] - PLACE[i]);
    let up = unit(to_center.map(|x| -x));
    let aside = across(draws, up);
    let way = 50.0 * draws.unit();
    // The sphere's point below, to second order; then up along its normal.
    let normal = unit(along(up, aside, way / radius));
    let drop = norm(to_center) - radius + way * way / (2.0 * radius);
    let height = draws.log_between(heights[0], heights[1]);
    let foot = along(along([0.0; 3], aside, way), up, -drop);
    let origin = formula.rounded(along(foot, normal, height));
    let cosine = draws.log_between(0.02, 1.0);
    let flat = across(draws, normal);
    let sine = (1.0 - cosine * cosine).sqrt();
    let d = formula.rounded(unit(along(normal.map(|x| -cosine * x), flat, sine)));
    let center = between(center, PLACE);
    let start: Vector = vector(origin);
    let meeting = Meeting::new(start, vector(d), center, radius);
    let outside = length(minus(start, center)).to_f64() > radius;
    (outside && meeting.distance.is_some()).then_some((origin, d, meeting))
}

/// |t - exact t| on a ground of radius 1e4.
fn ground(effort: Effort, findings: &mut Findings, case: &'static str, heights: [f64; 2]) {
    const RADIUS: f64 = 10_003.7;
    let tested = format!(
        "radius {RADIUS}, {} rays from heights of {:e} to {} within 50 units, down with a cosine of 0.02 to 1",
        effort.rays * 5,
        heights[0],
        heights[1]
    );
    let draft = sphere_below(RADIUS, HEIGHT, direction(&mut Draws::new(41)));
    for formula in Formula::ALL {
        let rays = Rays::new(formula, &draft);
        let draws = &mut Draws::new(42);
        let (mut worst, mut absolute, mut relative, mut lost) = (0.0_f64, 0.0_f64, 0.0_f64, 0_u64);
        for _ in 0..effort.rays * 5 {
            let ray = ray_down(formula, draws, &draft, heights);
            // A ray whose exact answer is a hit must hit.
            let Some((origin, d, meeting)) = ray else { continue };
            let exact = meeting.distance.expect("only rays that meet").to_f64();
            let Some(first) = rays.first(origin, d) else {
                lost += 1;
                continue;
            };
            // Scale the error by the ray's coordinates, whose rounding is unavoidable.
            let error = (first.distance - exact).abs();
            let coordinates = norm(origin) + exact;
            worst = larger(worst, error * meeting.cosine / (formula.u() * coordinates));
            absolute = larger(absolute, error);
            relative = larger(relative, error / coordinates);
        }
        let measured = if lost == 0 { worst } else { f64::INFINITY };
        let sentence = format!(
            "Largest error of t {absolute:.1e}, {relative:.1e} of the ray's coordinates; {lost} hits lost."
        );
        findings.push(case, formula, &tested, measured, sentence);
    }
}

/// How far from the sphere the point is that was found, radii of 1e5 to 1e12.
fn residuals(effort: Effort, findings: &mut Findings) {
    const DIRECTIONS: u64 = 10;
    let rays = effort.rays / 20;
    let tested = format!(
        "radii 0.8317e5, 0.8317e6 ... 0.8317e12, the eye at heights of {}, {} and {} over each, {DIRECTIONS} generic directions, {rays} rays each",
        HEIGHTS[0], HEIGHTS[1], HEIGHTS[2]
    );
    for formula in Formula::ALL {
        let worst_of = (5..=12).map(|exponent| {
            let radius = 0.831_7 * 10_f64.powf(f64::from(exponent));
            let eyes = HEIGHTS.iter().flat_map(|height| (0..DIRECTIONS).map(move |d| (*height, d)));
            eyes.map(|(height, seed)| {
                let draft = sphere_below(radius, height, direction(&mut Draws::new(100 + seed)));
                residual(formula, &draft, &mut Draws::new(200 + seed), rays)
            })
            .fold(0.0, larger)
        });
        let worst_of: Vec<f64> = worst_of.collect();
        let worst = worst_of.iter().copied().fold(0.0, larger);
        let each = worst_of.iter().map(|x| format!("{x:.0e}")).collect::<Vec<_>>().join(", ");
        let sentence = format!("By radius: {each}; infinite: a hit lost.");
        findings.push("radii to 1e12", formula, &tested, worst, sentence);
    }
}

/// The largest distance of a point found from the sphere, over how far the ray's start and its
/// hit are from the eye.
fn residual(formula: Formula, draft: &Draft, draws: &mut Draws, rays: u64) -> f64 {
    let compiled = Rays::new(formula, draft);
    let Sphere { center, radius, .. } = draft.spheres[0];
    let center = between(center, PLACE);
    let mut worst = 0.0;
    for _ in 0..rays {
        let ray = ray_down(formula, draws, draft, [0.1, 30.0]);
        let Some((origin, d, meeting)) = ray else { continue };
        let exact = meeting.distance.expect("only rays that meet").to_f64();
        let Some(first) = compiled.first(origin, d) else { return f64::INFINITY };
        let off = length(minus(vector(first.point), center));
        let off = (off - radius.into()).to_f64().abs();
        worst = larger(worst, off / (norm(origin) + exact));
    }
    worst
}
