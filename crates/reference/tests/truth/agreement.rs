//! The two arithmetics, and one scene in two places.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::{Camera, Draft, Image, Materials, Scene, Sphere, View};

use super::scenes::{closed_room, largest_difference, mirror, render, workshop};

/// Measured at 320 x 240 to depth 32: 1.4e-12 with the matt ground, and 3.7e-11, in one
/// grazing pixel (99.9 % of the channels are within 7e-13), with one that mirrors.
#[test]
fn f64_agrees_with_double_double_on_the_workshop_scene() {
    for (ground, bound) in [(0.0, 1.5e-12), (0.3, 4e-11)] {
        let draft = workshop(320, 240, 32, ground);
        let [double, truth] = [Precision::F64, Precision::DoubleDouble].map(|p| render(&draft, p));
        let difference = largest_difference(&double, &truth);
        assert!(difference < bound, "ground {ground}: f64 is {difference:e} off");
        assert!(difference > 1e-14, "ground {ground}: f64 is only {difference:e} off");
        assert_eq!(double.counts, truth.counts);
    }
}

/// Moved by a whole number, every coordinate of the scene stays exact in f64, so the two
/// pictures are the same in the reals; what differs is double-double rounding at
/// coordinates of 1e6 instead of 10, amplified by a few mirrors: about 1e-32 · 1e6 · 1e4
/// before the result is rounded to f64, 1e-15 after.
#[test]
fn a_translated_scene_is_the_same_picture() {
    let draft = workshop(48, 36, 8, 0.3);
    let mut moved = draft.clone();
    let by = [1e6, -2e6, 3e6];
    let shift = |p: &mut [f64; 3]| *p = [0, 1, 2].map(|c| p[c] + by[c]);
    shift(&mut moved.camera.position);
    shift(&mut moved.camera.look_at);
    moved.lights.iter_mut().for_each(|light| shift(&mut light.position));
    moved.spheres.iter_mut().for_each(|sphere| shift(&mut sphere.center));

    let [here, there] = [draft, moved].map(|d| render(&d, Precision::DoubleDouble));
    let difference = largest_difference(&here, &there);
    assert!(difference < 1e-15, "moving the scene changes it by {difference:e}");
}

/// Doubling is exact: the same bits.
#[test]
fn a_scene_scaled_by_a_power_of_two_is_the_same_picture() {
    let draft = workshop(32, 24, 8, 0.3);
    for factor in [1_048_576.0, 1.0 / 1_048_576.0] {
        let mut scaled = draft.clone();
        let scale = |p: &mut [f64; 3]| *p = p.map(|x| x * factor);
        scale(&mut scaled.camera.look_at);
        scaled.lights.iter_mut().for_each(|light| scale(&mut light.position));
        for sphere in &mut scaled.spheres {
            scale(&mut sphere.center);
            sphere.radius *= factor;
        }
        for precision in [Precision::F64, Precision::DoubleDouble] {
            assert_eq!(render(&draft, precision), render(&scaled, precision));
        }
    }
}

#[test]
fn threads_do_not_change_the_picture() {
    let draft = closed_room(17, 9, 6);
    let on = |threads| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads).build();
        pool.expect("a pool").install(|| render(&draft, Precision::F64))
    };
    assert_eq!(on(1), on(3));
}

/// Four sub-samples are four pixels of the picture of twice the size.
#[test]
fn samples_and_crop_keep_the_grid() {
    let mut draft = workshop(12, 8, 2, 0.3);
    let scene = Scene::new(draft.clone()).expect("valid");
    let crop = catoptric_scene::Crop { x: 3, y: 2, width: 5, height: 4 };
    let coarse = View::new(&scene, Some(crop), 2).expect("inside");
    let film = Truth::new(&scene, Precision::DoubleDouble).render(&coarse).expect("shallow");

    draft.image = Image { width: 24, height: 16, ..draft.image };
    let fine = render(&draft, Precision::DoubleDouble);
    for (x, y) in (0..4).flat_map(|y| (0..5).map(move |x| (x, y))) {
        let at = |i: usize, j: usize| fine.pixels[(2 * (y + 2) + j) * 24 + 2 * (x + 3) + i];
        let four = [at(0, 0), at(1, 0), at(0, 1), at(1, 1)];
        for c in 0..3 {
            let mean = four.iter().map(|pixel| pixel[c]).sum::<f64>() / 4.0;
            assert!((film.pixels[y * 5 + x][c] - mean).abs() < 1e-15, "pixel {x},{y}");
        }
    }
    assert_eq!(film.counts.primary(), 5 * 4 * 4);
    let pixel = Truth::new(&scene, Precision::DoubleDouble).radiance(&coarse, 4, 3);
    assert_eq!(pixel, Ok(film.pixels[3 * 5 + 4]));
}

#[test]
fn a_nudge_turns_the_eye_ray() {
    let mut materials = Materials::default();
    let material = materials.add(mirror(0.0));
    let sphere = Sphere { center: [0.0, 0.0, -5.0], radius: 1.0, material };
    let draft = Draft {
        materials,
        image: Image { width: 1, height: 1, ..Image::default() },
        camera: Camera::default(),
        spheres: vec![sphere],
        ..Draft::default()
    };
    let scene = Scene::new(draft).expect("valid");
    let view = View::whole(&scene);
    // The limb is at tan = 1/sqrt(24) off the axis: 0.204124...
    for precision in [Precision::F64, Precision::DoubleDouble] {
        let truth = Truth::new(&scene, precision);
        let red = |nudge| truth.radiance_nudged(&view, 0, 0, nudge).expect("shallow")[0];
        assert_eq!(red([0.0; 3]), 0.1);
        assert_eq!(red([0.2041, 0.0, 0.0]), 0.1);
        assert_eq!(red([0.2042, 0.0, 0.0]), 0.0);
        assert_eq!(red([0.0, -0.2041, 0.0]), 0.1);
        assert_eq!(red([0.0, -0.2042, 0.0]), 0.0);
    }
}
