//! Every parameter's range, at its ends and just past them.

use catoptric_scene::family::{
    Arrangement, Corridor, Kissing, Lattice, MOST_BALLS, OutOfRange, Random, Room, Sphereflake,
};
use catoptric_scene::{Draft, Scene};

/// Which parameter was refused, and the whole message; `None` for a valid scene.
fn refused(draft: Result<Draft, OutOfRange>) -> Option<(&'static str, String)> {
    match draft {
        Ok(draft) => {
            Scene::new(draft).expect("what is in range is valid");
            None
        }
        Err(error) => Some((error.parameter, error.to_string())),
    }
}

/// A real parameter: its ends are allowed, what comes next and what is no number is not.
fn real(
    parameter: &str,
    [least, most]: [f64; 2],
    draft: impl Fn(f64) -> Result<Draft, OutOfRange>,
) {
    for x in [least, most] {
        assert_eq!(refused(draft(x)), None, "{parameter} {x}");
    }
    let past = [least.next_down(), most.next_up(), f64::NAN, f64::INFINITY, f64::NEG_INFINITY];
    for x in past {
        let (named, message) = refused(draft(x)).unwrap_or_else(|| panic!("{parameter} {x}"));
        assert_eq!(named, parameter);
        assert!(message.contains("allowed: a number from "), "{message}");
    }
}

/// A count: the same.
fn count(parameter: &str, least: u32, most: u32, draft: impl Fn(u32) -> Result<Draft, OutOfRange>) {
    for n in [least, most] {
        assert_eq!(refused(draft(n)), None, "{parameter} {n}");
    }
    let past = [least.checked_sub(1), most.checked_add(1), Some(u32::MAX)];
    for n in past.into_iter().flatten() {
        let expected =
            format!("{parameter}: found {n}; allowed: an integer from {least} to {most}");
        let (named, message) = refused(draft(n)).unwrap_or_else(|| panic!("{parameter} {n}"));
        assert_eq!((named, message), (parameter, expected));
    }
}

const FACTOR: [f64; 2] = [0.0, 1.0];
const HUGE: [f64; 2] = [10.0, 1e12];

#[test]
fn corridor() {
    let family = Corridor::default();
    count("balls", 0, MOST_BALLS, |balls| Corridor { balls, ..family }.draft());
    real("reflect", FACTOR, |reflect| Corridor { reflect, ..family }.draft());
    real("mirror_radius", HUGE, |r| Corridor { mirror_radius: Some(r), ..family }.draft());
}

#[test]
fn room() {
    let family = Room::default();
    count("balls", 0, MOST_BALLS, |balls| Room { balls, ..family }.draft());
    real("radius", [1e-3, 1e9], |radius| Room { radius, balls: 1_000, ..family }.draft());
    real("reflect", FACTOR, |reflect| Room { reflect, ..family }.draft());
    // The smallest of balls.
    let crowd = Room { radius: 1e-3, balls: MOST_BALLS, ..family };
    assert_eq!(refused(crowd.draft()), None);
}

#[test]
fn kissing() {
    let groups = [
        (Arrangement::Cluster, 2, 4),
        (Arrangement::Ring, 3, MOST_BALLS),
        (Arrangement::Chain, 2, MOST_BALLS),
    ];
    for (arrangement, least, most) in groups {
        let family = Kissing { arrangement, ..Kissing::default() };
        count("spheres", least, most, |spheres| Kissing { spheres, ..family }.draft());
        real("radius", [1e-6, 1e6], |radius| Kissing { radius, spheres: 4, ..family }.draft());
        let largest = Kissing { spheres: most, radius: 1e6, ..family };
        assert_eq!(refused(largest.draft()), None);
        real("reflect", FACTOR, |reflect| Kissing { reflect, ..family }.draft());
    }
}

#[test]
fn random() {
    let family = Random::default();
    count("balls", 0, MOST_BALLS, |balls| Random { balls, ..family }.draft());
    let large = Random { balls: 1_000, max_radius: 1e9, ..family };
    let small = Random { balls: 1_000, min_radius: 1e-9, ..family };
    real("min_radius", [1e-9, 1e9], |min_radius| Random { min_radius, ..large }.draft());
    real("max_radius", [1e-9, 1e9], |max_radius| Random { max_radius, ..small }.draft());
    real("reflect", FACTOR, |reflect| Random { reflect, ..family }.draft());
    let turned = Random { min_radius: 2.0, max_radius: 1.5, ..family };
    let message = "min_radius: found 2; allowed: at most the largest radius, which is 1.5";
    assert_eq!(refused(turned.draft()), Some(("min_radius", message.to_owned())));
    let crowd = Random { balls: MOST_BALLS, ..large };
    assert_eq!(refused(crowd.draft()), None);
}

#[test]
fn lattice() {
    let family = Lattice::default();
    count("edge", 1, 100, |edge| Lattice { edge, ..family }.draft());
    real("radius", [1e-6, 0.5], |radius| Lattice { radius, ..family }.draft());
    real("reflect", FACTOR, |reflect| Lattice { reflect, ..family }.draft());
}

#[test]
fn sphereflake() {
    let family = Sphereflake::default();
    count("levels", 0, 6, |levels| Sphereflake { levels, ..family }.draft());
    real("reflect", FACTOR, |reflect| Sphereflake { reflect, ..family }.draft());
    real("ground_radius", HUGE, |r| Sphereflake { ground_radius: Some(r), ..family }.draft());
}
