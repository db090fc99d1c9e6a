//! The error split by cause.

use catoptric_reference::truth::Vertex;
use catoptric_scene::{Draft, Numerics, Sphere, View};
use catoptric_study::metrics::Metrics;
use catoptric_study::stability::causes::{Cause, causes, table};
use catoptric_study::stability::paths::{Arithmetic, Paths};

use super::scenes::{matt, pictures, scene, seen, workshop};

fn hit(primitive: usize, lit: bool, followed: bool) -> Vertex {
    Vertex { primitive, point: [0.0; 3], rest: [0.0; 3], lit: vec![lit], followed }
}

#[test]
fn the_first_difference_decides() {
    let path = [hit(1, true, true), hit(2, false, true), hit(3, true, false)];
    let shadow = [hit(1, true, true), hit(2, true, true), hit(0, true, false)];
    let another = [hit(1, true, true), hit(0, true, true), hit(3, true, false)];
    let lost = [hit(1, true, true), hit(2, false, true)];
    let cut = [hit(1, true, true), hit(2, false, false)];
    let cases = [
        (&path[..], Cause::Rounding),
        (&shadow, Cause::Shadow),
        (&another, Cause::Another),
        (&lost, Cause::Silhouette),
        (&[], Cause::Silhouette),
        (&cut, Cause::Cut),
    ];
    for (other, cause) in cases {
        assert_eq!(Cause::of(other, &path), cause);
        assert_eq!(Cause::of(&path, other), cause, "whichever is truth's");
    }
}

/// The causes of a scene's pixels against those of the scene after a change, both of truth.
fn planted(before: Draft, change: impl FnOnce(&mut Draft)) -> Vec<Cause> {
    let mut after = before.clone();
    change(&mut after);
    let (before, after) = (scene(before), scene(after));
    let view = View::whole(&before);
    let paths = [before, after].map(|scene| Paths::new(&scene, &view, Arithmetic::DoubleDouble));
    let pixel = |x, y| Cause::of(&paths[1].path(x, y), &paths[0].path(x, y));
    (0..48).flat_map(|y| (0..64).map(move |x| (x, y))).map(|(x, y)| pixel(x, y)).collect()
}

const FOV: f64 = 30.0;

/// Half a pixel at distance 1, and whether the ray of a pixel of 64 x 48 meets a sphere: by its
/// angle to the centre.
fn half_pixel() -> f64 {
    (FOV.to_radians() / 2.0).tan() / 48.0
}

fn meets(index: usize, sphere: &Sphere) -> bool {
    let at = |i: usize, size: usize| (2 * i + 1) as f64 - size as f64;
    let ray = [at(index % 64, 64) * half_pixel(), -at(index / 64, 48) * half_pixel(), -1.0];
    let dot = |a: [f64; 3], b: [f64; 3]| a[0] * b[0] + a[1] * b[1] + a[2] * b[2];
    let (c, along) = (sphere.center, dot(ray, sphere.center));
    dot(c, c) - along * along / dot(ray, ray) <= sphere.radius * sphere.radius
}

#[test]
fn a_sphere_half_a_pixel_aside_flips_its_silhouette_alone() {
    let ball = matt([0.113, -0.071, -10.0], 1.7);
    let mut moved = ball;
    moved.center[0] += 10.0 * half_pixel();
    // The lamp is at the eye: all that is seen is lit.
    let before = seen([64, 48], FOV, [0.0; 3], &[ball]);
    let causes = planted(before, |draft| draft.spheres[0] = moved);
    let flipped = causes.iter().filter(|cause| **cause == Cause::Silhouette).count();
    assert!(flipped > 10, "{flipped}");
    for (index, cause) in causes.iter().enumerate() {
        let expected = if meets(index, &ball) == meets(index, &moved) {
            Cause::Rounding
        } else {
            Cause::Silhouette
        };
        assert_eq!(*cause, expected, "pixel {index}");
    }
}

#[test]
fn before_a_wall_it_is_another_primitive_and_a_moved_lamp_is_a_shadow() {
    let ball = matt([0.113, -0.071, -10.0], 1.7);
    let mut moved = ball;
    moved.center[1] += 10.0 * half_pixel();
    // Fills the view: a sphere as good as flat.
    let wall = matt([0.0, 0.0, -1020.0], 1000.0);
    let before = seen([64, 48], FOV, [0.0; 3], &[ball, wall]);
    let causes = planted(before.clone(), |draft| draft.spheres[0] = moved);
    for (index, cause) in causes.iter().enumerate() {
        let same = meets(index, &ball) == meets(index, &moved);
        assert_eq!(*cause == Cause::Another, !same, "pixel {index}: {cause:?}");
        assert_ne!(*cause, Cause::Silhouette, "pixel {index}");
    }
    let causes = planted(before, |draft| draft.lights[0].position = [0.4, 0.2, 0.0]);
    let count = |cause| causes.iter().filter(|c| **c == cause).count();
    assert!(count(Cause::Shadow) > 20, "{}", count(Cause::Shadow));
    assert_eq!(count(Cause::Shadow) + count(Cause::Rounding), 64 * 48);
}

/// 0.7 · 0.7 is above a least weight of 0.49 - 1e-9, and below it in f32.
#[test]
fn a_path_that_one_precision_cuts_is_a_cut() {
    let [ball, behind] = [-3.0, 3.0].map(|z| matt([0.0, 0.0, z], 1.0));
    let mut draft = seen([1, 1], FOV, [0.0; 3], &[ball, behind]);
    draft.remake_materials(|material| material.reflect = Some(0.7));
    draft.camera.look_at = [0.001, 0.001, -1.0];
    draft.render.min_weight = 0.49 - 1e-9;
    draft.render.max_depth = 2;
    let scene = scene(draft);
    let (found, truth) = pictures(&scene);
    let causes = causes(&scene, &View::whole(&scene), &found, &truth);
    assert_eq!(causes.of_pixels, [Cause::Cut]);
}

#[test]
fn the_shares_are_the_whole() {
    for numerics in [Numerics::Robust, Numerics::Textbook] {
        let scene = workshop(80, 60, numerics);
        let (found, truth) = pictures(&scene);
        let causes = causes(&scene, &View::whole(&scene), &found, &truth);
        let whole = Metrics::of(&found, &truth);
        let pixels: u64 = causes.shares.iter().map(|share| share.pixels).sum();
        let off: u64 = causes.shares.iter().map(|share| share.metrics.off_by_more).sum();
        assert_eq!((pixels, off), (80 * 60, whole.off_by_more));
        let squares: f64 = causes.shares.iter().map(|share| share.rmse * share.rmse).sum();
        assert!((squares.sqrt() / whole.rmse - 1.0).abs() < 1e-12);
        let share = |cause| causes.shares.iter().find(|s| s.cause == cause).expect("all causes");
        match numerics {
            Numerics::Robust => {
                assert_eq!(share(Cause::Rounding).pixels, pixels, "no flip at this size");
                assert_eq!(off, 0);
            }
            // Contact breaks: shadows above all.
            Numerics::Textbook => assert!(share(Cause::Shadow).rmse > 0.9 * whole.rmse),
        }
        let rows = causes.shares.iter().filter(|share| share.pixels > 0).count();
        assert_eq!(table(&[("workshop".into(), causes)]).rows.len(), rows);
    }
}
