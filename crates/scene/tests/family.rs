//! Families: what is in range is a valid scene, what is not is named, and each family is
//! what it says.

mod any;
mod bodies;
mod flake;
mod kissing;
mod ranges;
mod same;

use catoptric_scene::Sphere;

/// Distance of two points.
fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    [0, 1, 2].map(|i| (a[i] - b[i]) * (a[i] - b[i])).iter().sum::<f64>().sqrt()
}

/// Distance between two spheres' surfaces, each seen from outside; negative if they meet.
fn gap(a: &Sphere, b: &Sphere) -> f64 {
    distance(a.center, b.center) - a.radius - b.radius
}
