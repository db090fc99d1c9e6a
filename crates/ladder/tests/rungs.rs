//! Every rung gives the recursion's bits, counts and events.

use catoptric_core::Isa;
use catoptric_ladder::{Event, RUNGS};
use catoptric_scene::{Compiled, Counts, Grid, Material, Numerics, Scene, Sphere};
use catoptric_tests::identity::recursive;
use catoptric_tests::{generate, scenes};
use proptest::prelude::*;

use crate::comparison::{Difference, eye_rays, rungs, view, watched};

fn check(name: &str, scene: &Scene, samples: u32) -> Result<(), String> {
    let (compiled, grid) = view(scene, samples);
    the_log_tells_the_picture(&compiled, &grid)?;
    for (rung, isa) in rungs() {
        let difference = Difference::new(&rung, isa, &compiled, &grid);
        if !difference.is_none() {
            return Err(format!("{name}, {} on {isa}: {difference:?}", rung.name));
        }
    }
    Ok(())
}

/// Rung 0's picture is the reference's own, its log is not: the events must add up to the
/// picture's counts and end in its colours.
fn the_log_tells_the_picture(scene: &Compiled, grid: &Grid) -> Result<(), String> {
    let (film, counts) = recursive(scene, grid);
    let mut sum = Counts::default();
    for (column, row) in eye_rays(grid) {
        let log = watched(&RUNGS[0], Isa::Portable, scene, grid, (column, row));
        for event in &log {
            match event {
                Event::Call { depth, .. } => sum.at(*depth).rays += 1,
                Event::Hit { depth, .. } => sum.at(*depth).hits += 1,
                Event::Fold { .. } | Event::Return { .. } => {}
            }
        }
        if grid.samples == 1 {
            let [r, g, b] = film.pixels()[row * grid.width as usize + column];
            let shown = Event::Return { depth: 0, colour: [r, g, b].into() };
            if log.last() != Some(&shown) {
                return Err(format!("({column}, {row}): {shown:?}, but {:?}", log.last()));
            }
        }
    }
    for (depth, sum) in sum.depths.iter_mut().enumerate() {
        // Shadow rays are no events.
        sum.shadow = counts.depths[depth].shadow;
    }
    (sum == counts).then_some(()).ok_or(format!("{counts:?}\nevents: {sum:?}"))
}

#[test]
fn every_scene_in_both_numerics() {
    for (name, draft) in scenes::all() {
        for numerics in [Numerics::Robust, Numerics::Textbook] {
            let mut draft = draft.clone();
            draft.render.numerics = numerics;
            for (width, height, depth) in [(37, 21, draft.render.max_depth), (8, 6, 0), (9, 5, 1)] {
                let scene = scenes::sized(&draft, width, height, depth);
                let name = format!("{name} {numerics:?} at depth {depth}");
                check(&name, &scene, 1).unwrap_or_else(|report| panic!("{report}"));
            }
        }
    }
}

#[test]
fn samples_and_partial_packets() {
    for width in 1..=17 {
        for samples in [1, 2, 3] {
            let scene = scenes::sized(&scenes::named("kissing"), width, 3, 20);
            check("kissing", &scene, samples).unwrap_or_else(|report| panic!("{report}"));
        }
    }
}

#[test]
fn deep_paths() {
    let mut draft = scenes::named("closed-room");
    for material in draft.materials.iter_mut() {
        material.reflect = Some(1.0);
    }
    let scene = scenes::sized(&draft, 9, 1, 5_000);
    check("perfect room", &scene, 1).unwrap_or_else(|report| panic!("{report}"));
}

/// Weights are compared wherever a rung forms them: the scalar ones always, the engine for a
/// cut. The cut makes no difference to the picture here, so that all paths are the same.
#[test]
fn the_engine_forms_weights_for_a_cut_alone() {
    for min_weight in [0.0, 1e-6] {
        let mut draft = scenes::named("workshop");
        draft.render.min_weight = min_weight;
        let scene = scenes::sized(&draft, 64, 48, 5);
        let (compiled, grid) = view(&scene, 1);
        let mut mirrored = 0;
        for (rung, isa) in rungs() {
            for at in eye_rays(&grid) {
                for event in watched(&rung, isa, &compiled, &grid, at) {
                    if let Event::Call { depth, weight, .. } = event {
                        let formed = rung.name != "r5" || min_weight > 0.0;
                        assert_eq!(weight.is_some(), formed, "{}", rung.name);
                        mirrored += usize::from(weight.is_some_and(|weight| weight < 1.0));
                        assert!(depth > 0 || weight.is_none_or(|weight| weight == 1.0));
                    }
                }
            }
        }
        assert!(mirrored > 100, "{mirrored}");
        check("cut", &scene, 1).unwrap_or_else(|report| panic!("{report}"));
    }
}

/// Packets fold 0 into colours that are complete: that would turn a -0 into 0.
#[test]
fn no_colour_is_minus_zero() {
    let mut draft = scenes::named("workshop");
    draft.lights.clear();
    draft.render.ambient = [0.0, -0.0, 0.0];
    draft.render.background = [-0.0; 3];
    let black = Material { color: [-0.0; 3], reflect: Some(1.0), ..Material::matt([0.0; 3]) };
    draft.spheres.push(Sphere {
        center: [0.0, 8.0, -20.0],
        radius: 3.0,
        material: draft.materials.add(black),
    });
    let scene = scenes::sized(&draft, 23, 17, 5);
    check("zeros", &scene, 1).unwrap_or_else(|report| panic!("{report}"));
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn generated_scenes(
        scene in generate::scene(10, (1u32..=17, 1u32..=4)),
        samples in prop_oneof![4 => Just(1u32), 1 => 2u32..=3],
    ) {
        check("generated", &scene, samples).map_err(TestCaseError::fail)?;
    }
}

/// `PROPTEST_CASES` asks for more or fewer.
fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { default.cases } else { 300 };
    ProptestConfig { cases, failure_persistence: None, ..default }
}
