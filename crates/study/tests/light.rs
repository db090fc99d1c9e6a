//! A-priori bounds: never below what is measured, and equal to it where all is uniform.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::family::{Corridor, Kissing, Random, Room};
use catoptric_scene::{Draft, Material, Scene, Sphere, View};
use catoptric_study::light::LightBounds;

fn scenes() -> Vec<Scene> {
    let mut drafts: Vec<Draft> = (0..12)
        .map(|seed| Random { seed, ..Random::default() }.draft().expect("in range"))
        .collect();
    drafts.push(Corridor::default().draft().expect("in range"));
    drafts.push(Kissing::default().draft().expect("in range"));
    drafts.push(Room { balls: 2, ..Room::default() }.draft().expect("in range"));
    let small = |mut draft: Draft| {
        (draft.image.width, draft.image.height) = (24, 18);
        draft.render.background = [0.3, 0.6, 0.2];
        draft.render.max_depth = FULL;
        draft.render.min_weight = 0.0;
        Scene::new(draft).expect("valid")
    };
    drafts.into_iter().map(small).collect()
}

const FULL: u32 = 24;

fn truth(scene: &Scene, change: impl Fn(&mut Draft)) -> Vec<f64> {
    let mut draft = scene.clone().into_draft();
    change(&mut draft);
    let scene = Scene::new(draft).expect("valid");
    let film = Truth::new(&scene, Precision::F64).render(&View::whole(&scene));
    film.expect("depth 24").pixels.into_flattened()
}

fn largest_change(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

#[test]
fn no_picture_passes_its_bounds() {
    let mut closest = 0.0_f64;
    for scene in scenes() {
        let bounds = LightBounds::new(&scene);
        let full = truth(&scene, |_| ());
        let brightest = full.iter().copied().fold(0.0, f64::max);
        assert!(brightest <= bounds.brightest(FULL) * (1.0 + 1e-12));
        for cap in [0, 1, 2, 3, 5, 8, 13, 23, 24, 25] {
            let capped = truth(&scene, |draft| draft.render.max_depth = cap.min(FULL));
            let (change, bound) =
                (largest_change(&full, &capped), bounds.left_out_by_cap(cap, FULL));
            assert!(change <= bound * (1.0 + 1e-12), "cap {cap}: {change} > {bound}");
            closest = if bound > 0.0 { closest.max(change / bound) } else { closest };
        }
        for weight in [2.0, 0.9, 0.5, 0.1, 0.01, 1e-4] {
            let cut = truth(&scene, |draft| draft.render.min_weight = weight);
            let change = largest_change(&full, &cut);
            let bound = bounds.left_out_by_weight(weight, FULL);
            assert!(change <= bound * (1.0 + 1e-12), "weight {weight}: {change} > {bound}");
        }
    }
    assert!(closest > 0.1, "bounds that are never near say nothing: {closest}");
}

/// From inside an empty uniform sphere every path is the same, and the bound is the sum itself.
#[test]
fn a_uniform_room_reaches_its_bounds() {
    for k in [1.0, 0.9] {
        let material = Material { reflect: Some(k), ..Material::matt([0.5, 0.25, 0.125]) };
        let mut draft = Draft::default();
        draft.render.ambient = [0.2; 3];
        draft.spheres.push(Sphere {
            center: [0.0; 3],
            radius: 3.0,
            material: draft.materials.add(material),
        });
        let scene = Scene::new(draft).expect("valid");
        let sum = |terms: std::ops::RangeInclusive<u32>| {
            terms.map(|n| 0.1 * f64::powf(k, f64::from(n))).sum::<f64>()
        };
        let bounds = LightBounds::new(&scene);
        let is = |a: f64, b: f64| assert!((a / b - 1.0).abs() < 1e-12, "{a}, {b}");
        is(bounds.brightest(10), sum(0..=10));
        is(bounds.left_out_by_cap(3, 10), sum(4..=10));
        is(LightBounds::of_channel(&scene, 1).brightest(10), sum(0..=10) / 2.0);
        assert_eq!(bounds.left_out_by_cap(10, 10), 0.0);
    }
}

/// Two convex mirrors alternate, one alone cannot show itself, and none shows nothing.
#[test]
fn who_shows_whom_is_known() {
    let mirror = |k| Material { reflect: Some(k), ..Material::matt([1.0; 3]) };
    let scene = |factors: &[f64]| {
        let mut draft = Draft::default();
        for (i, k) in factors.iter().enumerate() {
            let (center, material) = ([3.0 * i as f64, 0.0, -9.0], draft.materials.add(mirror(*k)));
            draft.spheres.push(Sphere { center, radius: 1.0, material });
        }
        Scene::new(draft).expect("valid")
    };
    let left_out =
        |factors: &[f64], cap| LightBounds::new(&scene(factors)).left_out_by_cap(cap, 99);
    assert_eq!(left_out(&[0.0, 0.0], 0), 0.0);
    assert!(left_out(&[0.9, 0.0], 0) > 0.0);
    assert_eq!(left_out(&[0.9, 0.0], 1), 0.0);
    assert_eq!(left_out(&[0.9], 0), 0.0, "black alone is shown");
    let mut bright = scene(&[0.9]).into_draft();
    bright.render.background = [0.2, 7.0, 0.1];
    let bright = LightBounds::new(&Scene::new(bright).expect("valid"));
    assert!((bright.left_out_by_cap(0, 99) / 6.3 - 1.0).abs() < 1e-12, "the background is shown");
    let ratio = left_out(&[0.9, 0.1], 21) / left_out(&[0.9, 0.1], 1);
    assert!((ratio / 0.09_f64.powf(10.0) - 1.0).abs() < 1e-9, "{ratio}");
}
