//! Hit distances over fifteen orders of magnitude of radius, in generic directions.
//!
//! Analytic: along the line of the centre the surface is at |o - c| - r, and it is at
//! distance s of an eye outside, seen at the impact parameter m, where
//! t = sqrt((r + s)² - m²) - sqrt(r² - m²). Both are formed in 300-bit arithmetic from the
//! scene's f64 numbers and the direction that the camera gives to its middle pixel.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::{Camera, Draft, Image, Material, Materials, Scene, Sphere, View};
use dashu_float::{FBig, round::mode::HalfEven};

type Number = FBig<HalfEven, 2>;

fn number(x: f64) -> Number {
    Number::try_from(x).expect("finite").with_precision(300).value()
}

fn dot(a: &[Number; 3], b: &[Number; 3]) -> Number {
    &a[0] * &b[0] + &a[1] * &b[1] + &a[2] * &b[2]
}

fn minus(a: [f64; 3], b: [f64; 3]) -> [Number; 3] {
    [0, 1, 2].map(|c| number(a[c]) - number(b[c]))
}

/// Where the line from the eye to `look_at` first meets the sphere (its only forward root
/// if the eye is inside): o + d t.
fn exact_hit(camera: &Camera, sphere: &Sphere) -> Option<[f64; 3]> {
    let d = minus(camera.look_at, camera.position);
    let f = minus(camera.position, sphere.center);
    // The perpendicular from the centre, then half the chord: Pythagoras twice.
    let dd = dot(&d, &d);
    let foot = -dot(&f, &d) / &dd;
    let perpendicular = [0, 1, 2].map(|c| &f[c] + &foot * &d[c]);
    let radius = number(sphere.radius);
    let half_chord = &radius * &radius - dot(&perpendicular, &perpendicular);
    let inside = dot(&f, &f) < &radius * &radius;
    // Past the limb, or away from it.
    if half_chord < number(0.0) || (!inside && foot < number(0.0)) {
        return None;
    }
    let half_chord = (half_chord / dd).sqrt();
    let t = if inside { foot + half_chord } else { foot - half_chord };
    let position = camera.position.map(number);
    Some([0, 1, 2].map(|c| (&position[c] + &t * &d[c]).to_f64().value()))
}

/// A repeatable sequence in [-1, 1) (Knuth's 64-bit linear congruential generator).
struct Sequence(u64);

impl Sequence {
    fn next(&mut self) -> f64 {
        self.0 =
            self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1_442_695_040_888_963_407);
        (self.0 >> 11) as f64 / (1u64 << 52) as f64 - 1.0
    }

    fn unit(&mut self) -> [f64; 3] {
        let v = [self.next(), self.next(), self.next()];
        let length = v.iter().map(|x| x * x).sum::<f64>().sqrt();
        v.map(|x| x / length)
    }
}

/// The worst error of a hit, in world units per largest coordinate of the hit, over
/// generic lines to spheres of that radius from an eye at that height over the surface
/// (negative: inside). Also how many lines met their sphere.
fn worst(precision: Precision, radius: f64, height: f64) -> (f64, usize) {
    let mut sequence = Sequence(7);
    let (mut worst, mut hits) = (0.0_f64, 0);
    for _ in 0..40 {
        let (out, aside) = (sequence.unit(), sequence.unit());
        let position = [sequence.next(), sequence.next(), sequence.next()];
        let center = [0, 1, 2].map(|c| position[c] - out[c] * (radius + height));
        // From straight at the centre to beyond the limb.
        let slant = sequence.next().abs() * radius.min(3.0 * height.abs());
        let look_at = [0, 1, 2].map(|c| position[c] - out[c] * height.abs() + aside[c] * slant);
        let camera = Camera { position, look_at, up: sequence.unit(), fov: 30.0 };
        let mut materials = Materials::default();
        let material = materials.add(Material::matt([1.0; 3]));
        let sphere = Sphere { center, radius, material };
        let draft = Draft {
            image: Image { width: 1, height: 1, ..Image::default() },
            camera,
            materials,
            spheres: vec![sphere],
            ..Draft::default()
        };
        let scene = Scene::new(draft).expect("valid");
        let found = Truth::new(&scene, precision).path(&View::whole(&scene), 0, 0);
        let exact = exact_hit(&camera, &sphere);
        // In f64 a hit near the limb may be lost or won; double-double never differs here.
        if precision == Precision::DoubleDouble {
            assert_eq!(found.len(), usize::from(exact.is_some()), "{sphere:?} from {camera:?}");
        }
        let (Some(found), Some(exact)) = (found.first(), exact) else {
            continue;
        };
        hits += 1;
        let size = exact.iter().fold(0.0_f64, |size, x| size.max(x.abs()));
        for (found, exact) in found.point.iter().zip(exact) {
            worst = worst.max((found - exact).abs() / size);
        }
    }
    (worst, hits)
}

#[test]
fn double_double_hits_are_right_to_the_last_bit_of_f64_at_every_radius() {
    for exponent in -3..=12 {
        let radius = 10.0_f64.powf(f64::from(exponent));
        for height in [0.5 * radius, 4.0, 1e3 * radius.min(1e9), -0.3 * radius] {
            let (error, hits) = worst(Precision::DoubleDouble, radius, height);
            assert!(hits >= 10, "only {hits} of 40 lines meet r = {radius:e} at {height:e}");
            assert!(error <= 1.2e-16, "r = {radius:e}, {height:e} away: {error:e}");
        }
    }
}

/// The plain formula in f64 on the workshop's ground, seen from 4 units away: the error of
/// |o - c|² is 1e8 · 1e-16, over the root of the discriminant.
#[test]
fn f64_hits_on_the_ground_are_good_to_nine_digits() {
    let (error, hits) = worst(Precision::F64, 1e4, 4.0);
    assert!(hits >= 10 && error < 1e-9, "{hits} hits, {error:e}");
    assert!(error > 1e-14, "f64 is not that good: {error:e}");
}
