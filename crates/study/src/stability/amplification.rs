//! How errors grow from mirror to mirror, and when a path is lost.
//!
//! ```text
//! amplification.rs   growth per bounce, error against bounce, the bounce of decorrelation
//!   tangent.rs         growth to first order along a path; closed forms
//!   orbit.rs           periodic orbits, and eye rays that stay near them
//!   cases.rs           pairs, three spheres, and whole pictures
//!   growth.rs          what a case showed, and what theory foretells of it
//!   report.rs          table and plot
//! ```
//!
//! Method. Truth's paths are those of double-double. The error of a path at a bounce is the
//! distance of its hit from that of truth; it is infinite once the path has met another
//! primitive, or ended, where truth goes on. What counts at a bounce is the median over the
//! paths of truth that get there, while at least [`LEAST_PATHS`] do: in open scenes later
//! bounces are not judged. An arithmetic is decorrelated at the first bounce whose median is
//! above [`LOST`] units. Double-double is compared with itself, its eye rays nudged by
//! [`ULP`]: about what it rounds. So truth holds for f64 as far as that comparison does.

mod cases;
mod growth;
mod orbit;
mod report;
mod tangent;

pub use cases::{Case, orbits, picture};
pub use growth::{Growth, LOST};
pub use orbit::{Aimed, Orbit, RADIUS};
pub use report::{plot, table};
pub use tangent::{Spread, largest, periodic_lambda, spreads};

use catoptric_reference::truth::Vertex;
use glam::DVec3;
use rayon::prelude::*;

use super::paths::{Arithmetic, Paths, each_pixel, parting};
use crate::Watch;
use cases::Bundle;

/// A bounce is judged while so many paths of truth get there.
pub const LEAST_PATHS: usize = 8;

/// The nudge that stands for double-double's rounding: 2^-103, a few ulps of a direction.
pub const ULP: f64 = 9.860_761_315_262_648e-32;

/// The nudge whose growth is measured, and the size in units to which it is followed: small
/// against 1, so that growth is linear, and large against rounding.
const NUDGE: f64 = 1e-20;
const LINEAR: f64 = 1e-6;

/// What one path showed.
struct Followed {
    bounces: usize,
    transported: Option<f64>,
    nudged: Option<f64>,
    /// Errors by arithmetic; entry n is the error at bounce n.
    errors: Vec<Vec<f64>>,
}

/// Measures cases one after the other, until it is told to stop.
#[must_use]
pub fn measure_all(cases: &[Case], watch: &dyn Watch) -> Vec<Growth> {
    let mut growths = Vec::new();
    for case in cases {
        if watch.stopped() {
            break;
        }
        watch.say(&format!("growth of errors: {}", case.name));
        growths.push(measure(case));
    }
    growths
}

/// Follows all paths of a case, on rayon's current pool.
#[must_use]
pub fn measure(case: &Case) -> Growth {
    let arithmetics = [case.f32(), Arithmetic::F64];
    let bundles = case.bundles();
    // Follow each pixel in truth and in both arithmetics.
    let followed: Vec<_> = bundles
        .par_iter()
        .flat_map_iter(|bundle| {
            let view = &bundle.view;
            let truth = Paths::new(&bundle.scene, view, Arithmetic::DoubleDouble);
            let others = arithmetics.map(|a| (a, Paths::new(&bundle.scene, view, a)));
            let unit = case.unit;
            each_pixel(view, |x, y| follow(bundle, &truth, &others, [x, y], unit))
        })
        .collect();

    // Judge bounces as long as enough paths live to have a median.
    let longest = followed.iter().map(|f| f.bounces).max().unwrap_or(0);
    let living: Vec<_> =
        (0..longest).map(|n| followed.iter().filter(|f| f.bounces > n).count()).collect();
    let judged = living.iter().take_while(|paths| **paths >= LEAST_PATHS).count();
    let medians = |i: usize| {
        let at = |n| median(followed.iter().filter_map(|f: &Followed| f.errors[i].get(n)).copied());
        (0..judged).filter_map(at).collect()
    };
    let compared = arithmetics.into_iter().chain([Arithmetic::DoubleDouble]);
    Growth {
        name: case.name.clone(),
        closed: case.lambda,
        transported: median(followed.iter().filter_map(|f| f.transported)),
        nudged: median(followed.iter().filter_map(|f| f.nudged)),
        errors: compared.enumerate().map(|(i, arithmetic)| (arithmetic, medians(i))).collect(),
        living,
    }
}

fn follow(
    bundle: &Bundle,
    truth: &Paths,
    others: &[(Arithmetic, Paths)],
    [x, y]: [u32; 2],
    unit: f64,
) -> Followed {
    let nudge = bundle.nudge.to_array();
    let path = truth.nudged(x, y, nudge);
    let first = path.first().map_or(DVec3::ZERO, |hit| DVec3::from_array(hit.point));
    let flight = (first - DVec3::from_array(bundle.scene.camera.position)).normalize_or_zero();
    let across = bundle.across.reject_from_normalized(flight).normalize();
    let moved = |size: f64| truth.nudged(x, y, (bundle.nudge + size * across).to_array());
    let error = |other: &[Vertex]| distances(&path, other).map(|d| d / unit).collect::<Vec<_>>();

    let others = others.iter().map(|(_, paths)| error(&paths.nudged(x, y, nudge)));
    let errors = others.chain([error(&moved(ULP))]).collect();
    // Growth once what the start had of its own has died away: over the later half of the
    // bounces that stay linear.
    let grown = error(&moved(NUDGE));
    let linear = grown.iter().take_while(|d| **d < LINEAR).count();
    let window = (linear / 2, linear.saturating_sub(1));
    let spread = spreads(&bundle.scene, &path, [across, flight.cross(across)]);
    let spread: Vec<_> = spread.iter().map(|s| s[0].length()).collect();
    Followed {
        bounces: path.len(),
        transported: rate(&spread, window),
        nudged: rate(&grown, window),
        errors,
    }
}

/// How far the other path is from each hit of truth's; infinite from where they part.
fn distances<'a>(truth: &'a [Vertex], other: &'a [Vertex]) -> impl Iterator<Item = f64> + 'a {
    let parted = parting(truth, other).unwrap_or(usize::MAX);
    truth.iter().enumerate().map(move |(n, vertex)| match other.get(n) {
        Some(other) if n < parted => {
            let rest = DVec3::from_array(other.rest) - DVec3::from_array(vertex.rest);
            (DVec3::from_array(other.point) - DVec3::from_array(vertex.point) + rest).length()
        }
        _ => f64::INFINITY,
    })
}

/// Geometric mean of the growth per bounce between two bounces.
fn rate(sizes: &[f64], (from, to): (usize, usize)) -> Option<f64> {
    let grown = sizes.get(to)? / sizes.get(from)?;
    let bounces = to.checked_sub(from).filter(|bounces| *bounces > 0)?;
    Some((grown.ln() / bounces as f64).exp()).filter(|rate| rate.is_finite())
}

/// The upper median.
fn median(values: impl Iterator<Item = f64>) -> Option<f64> {
    let mut values: Vec<_> = values.collect();
    values.sort_by(f64::total_cmp);
    values.get(values.len() / 2).copied()
}
