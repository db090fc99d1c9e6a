//! The ray's path as points.

use catoptric_ladder::Event;
use catoptric_scene::Scene;

use crate::life::Life;

/// Hits that are drawn.
pub(super) const HITS: usize = 200;

/// A ray's path in the scene.
pub(super) struct Path {
    /// The eye, then every hit; then, if the last ray leaves, a point on its way.
    pub(super) points: Vec<[f64; 3]>,
    pub(super) leaves: bool,
    /// Places of the spheres that are hit among the scene's spheres; planes come after.
    pub(super) met: Vec<usize>,
    /// Hits that are not drawn.
    pub(super) hidden: usize,
}

impl Path {
    pub(super) fn of(life: &Life) -> Self {
        let mut points = vec![[0.0; 3]];
        let (mut met, mut hidden) = (Vec::new(), 0);
        let mut flight = ([0.0; 3], [0.0; 3]);
        let mut leaves = false;
        for event in &life.events {
            match *event {
                Event::Call { origin, direction, .. } => {
                    flight =
                        (origin.to_array().map(f64::from), direction.to_array().map(f64::from));
                    leaves = true;
                }
                Event::Hit { primitive, distance, .. } => {
                    leaves = false;
                    if points.len() > HITS {
                        hidden += 1;
                        continue;
                    }
                    points.push(along(flight, distance.into()));
                    met.push(life.compiled.primitives[primitive].stated as usize);
                }
                Event::Fold { .. } | Event::Return { .. } => {}
            }
        }
        leaves &= hidden == 0;
        if leaves {
            // Half as long as the longest of the mirrored rays; without any, as the eye's; and
            // if that is the one that leaves, as far as there are spheres.
            let lengths = points.windows(2).map(|leg| distance(leg[0], leg[1]));
            let longest = lengths.clone().skip(1).fold(0.0, f64::max);
            let length = match points.len() {
                1 => 2.0 * farthest(life.scene),
                2 => lengths.fold(0.0, f64::max),
                _ => longest,
            };
            let from = points[points.len() - 1];
            points.push(along((from, flight.1), length / 2.0));
        }
        Self { points, leaves, met, hidden }
    }
}

/// How far from the eye a sphere's surface is, of the farthest; 1 without any.
fn farthest(scene: &Scene) -> f64 {
    let eye = scene.camera.position;
    let surfaces = scene.spheres.iter().map(|s| (distance(s.center, eye) - s.radius).abs());
    let farthest = surfaces.fold(0.0, f64::max);
    if farthest > 0.0 { farthest } else { 1.0 }
}

fn along((origin, direction): ([f64; 3], [f64; 3]), length: f64) -> [f64; 3] {
    std::array::from_fn(|i| origin[i] + length * direction[i])
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    let squares = (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i]));
    squares.sum::<f64>().sqrt()
}
