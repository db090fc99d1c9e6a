//! Growth of errors against closed forms.

use std::sync::atomic::{AtomicBool, Ordering};

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::family::Room;
use catoptric_scene::{Material, Numerics, Plane, Scene, View};
use catoptric_study::stability::amplification::{
    Case, Growth, Orbit, largest, measure, measure_all, orbits, periodic_lambda, picture, plot,
    spreads, table,
};
use catoptric_study::stability::paths::Arithmetic;
use catoptric_study::{Unwatched, Watch};
use glam::DVec3;

use super::scenes::workshop;

#[test]
fn the_closed_forms_are_those_of_the_pair_and_the_triangle() {
    for sigma in [2.001_f64, 2.01, 2.5, 6.0, 10.0, 1000.0] {
        let pair = (sigma - 1.0) + (sigma * (sigma - 2.0)).sqrt();
        let x = 2.0 * sigma / 3.0_f64.sqrt();
        let triangle = (x - 1.0) + (x * (x - 2.0)).sqrt();
        let near = |found: f64, expected: f64| (found / expected - 1.0).abs() < 1e-12;
        assert!(near(Orbit::pair(sigma).lambda, pair), "{sigma}");
        assert!(near(Orbit::triangle(sigma).lambda, triangle), "{sigma}");
    }
    assert_eq!(periodic_lambda(3.0, 0.0), 1.0);
}

/// Both the nudged paths of double-double and the transport along them, without any closed
/// form in either.
#[test]
fn measured_growth_is_the_closed_form() {
    let across = Case::of("across".to_owned(), Orbit::triangle_nudged_across(6.0));
    for case in orbits().iter().chain([&across]) {
        let growth = measure(case);
        let lambda = growth.closed.expect("a periodic orbit");
        assert_eq!(growth.holds(), Some(true), "{}", case.name);
        let other = Growth { closed: Some(lambda * (1.0 + 3e-6)), ..growth.clone() };
        assert_eq!(other.holds(), Some(false), "{}", case.name);
        for found in [growth.transported, growth.nudged] {
            let found = found.expect("bounces enough");
            assert!((found / lambda - 1.0).abs() < 1e-6, "{}: {found}, not {lambda}", case.name);
        }
    }
}

/// The bounce of decorrelation against (p ln 2 + ln tol)/ln Lambda: one bounce off, or as many
/// as the error takes to grow 32-fold, since the formula starts with one rounding and knows
/// neither of more nor of the flight from the eye. The robust recursion's first rounding is relative
/// to how far things are from the eye, which is between the spheres: where they are closer together
/// than their radius, it is so much smaller and paths last as much longer.
#[test]
fn paths_are_lost_where_theory_says() {
    for growth in measure_all(&orbits(), &Unwatched) {
        let lambda = growth.lambda().expect("closed");
        let slack = 1.0 + 32.0_f64.ln() / lambda.ln();
        // In radii: of a pair, lambda + 1/lambda is 2 (sigma - 1).
        let flight = (lambda + 1.0 / lambda) / 2.0 - 1.0;
        let longer = if flight < 1.0 { -flight.ln() / lambda.ln() } else { 0.0 };
        for arithmetic in [Arithmetic::Robust, Arithmetic::F64, Arithmetic::DoubleDouble] {
            let lost = growth.lost(arithmetic).expect("aimed for longer") as f64;
            let foretold = growth.foretold(arithmetic).expect("it grows");
            let longer = if arithmetic == Arithmetic::Robust { longer } else { 0.0 };
            let (least, most) = (foretold - slack, foretold + slack + longer);
            assert!((least..=most).contains(&lost), "{} {arithmetic:?}: {lost}", growth.name);
        }
        assert_eq!(plot(&growth).series.len(), 6);
    }
}

#[test]
fn a_closed_room_loses_every_precision_and_the_workshop_none_but_the_textbooks() {
    let room = measure(&Case::room());
    let lost = |arithmetic| room.lost(arithmetic).expect("no path ends");
    let (f32, f64) = (lost(Arithmetic::Robust), lost(Arithmetic::F64));
    let dd = lost(Arithmetic::DoubleDouble);
    assert!(10 < f32 && 2 * f32 < f64 && 2 * f64 < dd, "{f32} {f64} {dd}");

    let growths = [Numerics::Robust, Numerics::Textbook].map(|numerics| {
        measure(&picture(format!("workshop {numerics:?}"), workshop(60, 45, numerics), 4.0))
    });
    assert_eq!(growths[0].lost(Arithmetic::Robust), None);
    assert!(growths[1].lost(Arithmetic::Textbook).is_some_and(|bounce| bounce <= 3));
    for growth in &growths {
        assert_eq!(growth.lost(Arithmetic::F64), None);
        assert!(growth.errors[0].1.len() >= 5, "{:?}", growth.living);
    }
    assert_eq!(table(&growths).rows.len(), 2);
}

/// Hollow walls, balls, planes, any angle: every hit's spread against the distance of two
/// paths of double-double, 1e-20 apart at the eye.
#[test]
fn the_spread_is_the_derivative_of_every_hit() {
    let mut draft = Room { balls: 6, ..Room::default() }.draft().expect("in range");
    (draft.image.width, draft.image.height) = (5, 4);
    draft.render.max_depth = 20;
    let mirror = Material { reflect: Some(0.9), ..Material::matt([0.5; 3]) };
    draft.remake_materials(|material| *material = mirror);
    let normal = [0.3, 1.0, -0.2];
    draft.planes.push(Plane {
        point: [0.1, -7.3, 0.2],
        normal,
        material: draft.materials.add(mirror),
    });
    let scene = Scene::new(draft).expect("valid");
    let (view, truth) = (View::whole(&scene), Truth::new(&scene, Precision::DoubleDouble));
    let eye = DVec3::from_array(scene.camera.position);
    let mut met = [0; 3];
    for (x, y) in (0..4).flat_map(|y| (0..5).map(move |x| (x, y))) {
        let path = truth.path(&view, x, y);
        assert_eq!(path.len(), 21, "closed");
        let d = (DVec3::from_array(path[0].point) - eye).normalize();
        let (a, b) = d.any_orthonormal_pair();
        let spreads = spreads(&scene, &path, [a, b]);
        for (i, nudge) in [a, b].into_iter().enumerate() {
            let nudged = truth.path_nudged(&view, x, y, (1e-20 * nudge).to_array());
            for ((vertex, other), spread) in path.iter().zip(&nudged).zip(&spreads) {
                assert_eq!(vertex.primitive, other.primitive);
                let point = DVec3::from_array(other.point) - DVec3::from_array(vertex.point);
                let rest = DVec3::from_array(other.rest) - DVec3::from_array(vertex.rest);
                let (found, size) = ((point + rest) / 1e-20, largest(*spread));
                assert!((found - spread[i]).length() < 1e-7 * size, "{found} {spread:?}");
                met[vertex.primitive.min(1) + usize::from(vertex.primitive == 7)] += 1;
            }
        }
    }
    assert!(met.iter().all(|hits| *hits > 20), "wall, balls, plane: {met:?}");
}

#[test]
fn the_largest_spread_is_the_larger_singular_value() {
    let (u, v) = DVec3::new(0.48, -0.6, 0.64).normalize().any_orthonormal_pair();
    let (cos, sin) = (0.8, 0.6);
    // Singular values 7 and 2, the nudges turned against the axes.
    let spread = [7.0 * cos * u + 2.0 * sin * v, -7.0 * sin * u + 2.0 * cos * v];
    assert!((largest(spread) - 7.0).abs() < 1e-12);
    assert_eq!(largest([DVec3::ZERO; 2]), 0.0);
}

/// Stops after the first case.
struct Impatient(AtomicBool);

impl Watch for Impatient {
    fn stopped(&self) -> bool {
        self.0.swap(true, Ordering::Relaxed)
    }

    fn say(&self, line: &str) {
        assert!(line.contains("pair 2.01"), "{line}");
    }
}

#[test]
fn what_was_measured_before_a_stop_is_kept() {
    let growths = measure_all(&orbits(), &Impatient(AtomicBool::new(false)));
    assert_eq!(growths.len(), 1);
    assert!(growths[0].living.len() > 400);
}
