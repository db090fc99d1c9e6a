//! The recursion and the engine give the same bits, in f32 and in f64.

use catoptric_scene::{
    Compiled, Counts, Crop, Film, Grid, Material, Numerics, Quantiser, Scene, Sphere, Transfer,
    View,
};
use catoptric_tests::identity::{
    Real, assert_identical, backends, check, packet_levels, recursive,
};
use catoptric_tests::{crowds, generate, scenes};
use proptest::prelude::*;

#[test]
fn every_scene_in_both_numerics() {
    for (name, draft) in scenes::all() {
        for numerics in [Numerics::Robust, Numerics::Textbook] {
            let mut draft = draft.clone();
            draft.render.numerics = numerics;
            let depth = draft.render.max_depth;
            let scene = scenes::sized(&draft, 333, 187, depth);
            assert_identical(&format!("{name} {numerics:?}"), &scene);
        }
    }
}

#[test]
fn the_workshop_at_full_size() {
    assert_identical("workshop", &scenes::sized(&scenes::named("workshop"), 1920, 1080, 5));
}

#[test]
fn every_depth_to_64() {
    for name in ["workshop", "workshop-near", "corridor"] {
        for depth in 0..=64 {
            let scene = scenes::sized(&scenes::named(name), 61, 43, depth);
            assert_identical(&format!("{name} at depth {depth}"), &scene);
        }
    }
}

#[test]
fn every_small_size() {
    let draft = scenes::named("workshop-near");
    for width in 1..=17 {
        for height in 1..=17 {
            let scene = scenes::sized(&draft, width, height, 9);
            assert_identical(&format!("{width}x{height}"), &scene);
        }
    }
    for (width, height) in [(1, 301), (301, 1), (63, 65), (127, 3), (7, 129)] {
        assert_identical(&format!("{width}x{height}"), &scenes::sized(&draft, width, height, 9));
    }
}

#[test]
fn crops_and_samples() {
    let scene = scenes::sized(&scenes::named("planes"), 90, 70, 6);
    for samples in [1, 2, 3, 5] {
        for crop in [(0, 0, 90, 70), (13, 9, 21, 17), (89, 69, 1, 1), (3, 60, 80, 10)] {
            let (x, y, width, height) = crop;
            let crop = Crop { x, y, width, height };
            let view = View::new(&scene, Some(crop), samples).expect("inside");
            check("crop", &scene, &view).unwrap_or_else(|report| panic!("{report}"));
        }
    }
}

#[test]
fn a_cut_by_weight() {
    for min_weight in [1e-6, 1.0 / 255.0, 0.1, 0.5, 0.9, 1.0] {
        for name in ["kissing", "corridor", "closed-room"] {
            let mut draft = scenes::named(name);
            draft.render.min_weight = min_weight;
            let scene = scenes::sized(&draft, 40, 30, 200);
            assert_identical(&format!("{name} cut at {min_weight}"), &scene);
        }
    }
}

/// The engine's way straight to 8-bit levels gives those of the recursion's film.
#[test]
fn levels_are_those_of_the_film() {
    for (name, draft) in scenes::all() {
        let scene = scenes::sized(&draft, 131, 45, 7);
        for samples in [1, 2] {
            let view = View::new(&scene, None, samples).expect("whole");
            let (compiled, grid) = (Compiled::new(&scene), Grid::new(&view));
            let film = recursive(&compiled, &grid).0;
            for quantiser in [Transfer::Linear, Transfer::Srgb].map(Quantiser::new) {
                let mut expected = vec![[0; 3]; film.pixels().len()];
                quantiser.levels(film.pixels(), &mut expected);
                for backend in backends() {
                    let found = packet_levels(&compiled, &grid, &quantiser, backend);
                    assert!(found == expected, "{name}, {samples} samples, differs, {backend:?}");
                }
            }
        }
    }
}

/// On each side of where a level begins, in packets of eight and in a part of one.
#[test]
fn levels_begin_where_they_do_one_by_one() {
    let mut draft = scenes::named("workshop");
    draft.render.ambient = [1.0; 3];
    draft.camera.fov = 1.0;
    draft.lights.clear();
    draft.planes.clear();
    draft.spheres.truncate(1);
    // Fills the picture.
    draft.spheres[0].center = draft.camera.look_at;
    draft.spheres[0].radius = 1.0;
    let first = |level: f32| {
        let reached = |x: &f32| Quantiser::scaled(*x) >= level;
        let mut x = (level - 0.5) / 255.0;
        while reached(&x) {
            x = x.next_down();
        }
        while !reached(&x) {
            x = x.next_up();
        }
        x
    };
    let [linear, srgb] = [Transfer::Linear, Transfer::Srgb].map(Quantiser::new);
    for level in 1..=255_u8 {
        let begins = first(f32::from(level));
        let colour = [begins.next_down(), begins, begins.next_up()];
        draft.spheres[0].material = draft.materials.add(Material::matt(colour.map(f64::from)));
        let scene = scenes::sized(&draft, 9, 1, 0);
        let (compiled, grid) = (Compiled::new(&scene), Grid::new(&View::whole(&scene)));
        for backend in backends() {
            let expected = vec![[level - 1, level, level]; 9];
            let found = packet_levels(&compiled, &grid, &linear, backend);
            assert_eq!(found, expected, "level {level} differs, {backend:?}");
            let expected = vec![colour.map(|x| srgb.level(x)); 9];
            let found = packet_levels(&compiled, &grid, &srgb, backend);
            assert_eq!(found, expected, "level {level} differs, {backend:?}");
        }
    }
}

/// From so far that distances are rounded by more than the radius of a ball, whose points were no
/// number once: what can stand between each of them and a lamp is found all the same.
#[test]
fn points_nearer_than_distances_are_rounded() {
    let mut draft = scenes::named("workshop");
    draft.camera.position = [0.0; 3];
    draft.camera.look_at = [3316140.1446752865, -4710683.201650074, 3952815.179845415];
    draft.camera.up = [0.46236251992256994, -0.35596379631673325, -0.8121026264473169];
    draft.camera.fov = 1.6401705793649454e-5;
    draft.planes.clear();
    draft.lights.truncate(1);
    draft.lights[0].position = [3316146.4443958555, -4710689.48676905, 3952810.617959817];
    let mut ball = |center, radius, blue| {
        let material = Material { reflect: Some(0.9), ..Material::matt([0.0, 0.0, blue]) };
        Sphere { center, radius, material: draft.materials.add(material) }
    };
    draft.spheres = vec![
        ball([3316140.028683408, -4710683.261857549, 3952815.179845415], 0.4346565691602133, 0.7),
        ball([3316140.1446752865, -4710683.201650074, 3952816.079845415], 0.05, 0.0),
        ball([3316140.1446752865, -4710683.301830922, 3952814.7990874797], 0.3031416704052487, 0.0),
    ];
    assert_identical("points nearer than distances are rounded", &scenes::sized(&draft, 7, 20, 4));
}

/// The same surface again changes nothing, whatever it is made of: the first is seen, from
/// outside, from inside and after any number of reflections.
#[test]
fn coincident_surfaces_show_the_first() {
    for name in ["closed-room", "kissing", "planes"] {
        let draft = scenes::named(name);
        let mut doubled = draft.clone();
        doubled.spheres.extend(draft.spheres.iter().rev().copied());
        doubled.planes.extend(draft.planes.iter().rev().copied());
        let magenta = doubled.materials.add(Material::matt([9.0, 0.0, 9.0]));
        for sphere in &mut doubled.spheres[draft.spheres.len()..] {
            sphere.material = magenta;
        }
        for plane in &mut doubled.planes[draft.planes.len()..] {
            plane.material = magenta;
        }
        let once = scenes::sized(&draft, 60, 40, 40);
        let twice = scenes::sized(&doubled, 60, 40, 40);
        assert_identical(&format!("{name} twice"), &twice);
        assert_eq!(picture::<f32>(&once), picture::<f32>(&twice), "{name}");
        assert_eq!(picture::<f64>(&once), picture::<f64>(&twice), "{name}");
    }
}

fn picture<S: Real>(scene: &Scene) -> (Film<S>, Counts) {
    recursive(&Compiled::of(scene), &Grid::of(&View::whole(scene)))
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn generated_scenes(
        scene in generate::scene(12, (1u32..=17, 1u32..=17)),
        samples in prop_oneof![4 => Just(1u32), 1 => 2u32..=3],
    ) {
        same(&scene, samples)?;
    }

    #[test]
    fn generated_crowds(scene in generate::scene(40, (18u32..=50, 5u32..=40))) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_rims(scene in generate::rim((1u32..=260, 1u32..=24))) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_corners(scene in generate::corner()) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_eclipses(scene in generate::eclipse((1u32..=70, 1u32..=40))) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_grazes(scene in generate::graze()) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_far_grazes(scene in generate::far_graze()) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_specks(scene in generate::specks((1u32..=40, 1u32..=24))) {
        same(&scene, 1)?;
    }

    #[test]
    fn generated_nests(scene in generate::nested((1u32..=40, 1u32..=24))) {
        same(&scene, 1)?;
    }

    /// Several tiles wide, so that bounds on what a tile sees have edges to get wrong.
    #[test]
    fn generated_panoramas(scene in generate::scene(12, (120u32..=260, 1u32..=24))) {
        same(&scene, 1)?;
    }
}

proptest! {
    // Each of these has hundreds of primitives, so fewer cases take as long.
    #![proptest_config(ProptestConfig { cases: config().cases.div_ceil(10), ..config() })]

    /// A tile, or a part of one, in which every ray may meet a primitive of its own.
    #[test]
    fn generated_spheres_one_a_pixel(
        scene in crowds::a_sphere_a_pixel((1u32..=32, 1u32..=16), prop_oneof![0u32..4, 4u32..40]),
        samples in prop_oneof![4 => Just(1u32), 1 => Just(2u32)],
    ) {
        same(&scene, samples)?;
    }

    /// The same in whole tiles, and in several of them.
    #[test]
    fn generated_tiles_of_spheres(
        scene in crowds::a_sphere_a_pixel((32u32..=40, 16u32..=20), 0u32..3)
    ) {
        same(&scene, 1)?;
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: config().cases.div_ceil(50), ..config() })]

    #[test]
    fn generated_thousands(scene in crowds::thousands((1u32..=48, 1u32..=32))) {
        same(&scene, 1)?;
    }
}

fn same(scene: &Scene, samples: u32) -> Result<(), TestCaseError> {
    let view = View::new(scene, None, samples).expect("whole");
    check("generated", scene, &view).map_err(TestCaseError::fail)
}

/// `PROPTEST_CASES` asks for more or fewer.
fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { default.cases } else { 2_000 };
    ProptestConfig { cases, failure_persistence: None, ..default }
}
