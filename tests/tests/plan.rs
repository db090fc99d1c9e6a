//! What a plan leaves out changes no bit.

use catoptric_core::{
    Engine, Features, Isa, Levels, Omission, Omissions, Plan, Settings, TileCandidates, occluders,
    tile_candidates,
};
use catoptric_scene::{
    Compiled, Counts, Draft, Film, Grid, Numerics, Plane, Quantiser, Scene, Sphere, Transfer, View,
};
use catoptric_tests::identity::Real;
use catoptric_tests::{generate, scenes};
use proptest::prelude::*;

/// Bits of a picture, and its ray counts.
fn render<S: Real>(
    scene: &Compiled<S>,
    grid: &Grid<S>,
    plan: &Plan<S>,
    isa: Isa,
) -> (Vec<[u64; 3]>, Counts) {
    let settings = Settings { isa, stack_limit: 1 << 30 };
    let mut film = Film::black(grid.width, grid.height);
    let counts = Engine::new(scene).with(settings).render_planned(plan, &mut film);
    let bits = |p: &[S; 3]| p.map(|x| if x.to_f64().is_nan() { u64::MAX } else { x.bits() });
    (film.pixels().iter().map(bits).collect(), counts.expect("the limit allows it"))
}

fn levels(scene: &Compiled, grid: &Grid, plan: &Plan) -> Vec<[u8; 3]> {
    let settings = Settings { isa: Isa::detected(), stack_limit: 1 << 30 };
    let mut levels = vec![[7; 3]; grid.width as usize * grid.height as usize];
    let quantiser = Quantiser::new(Transfer::Srgb);
    let target = Levels { quantiser: &quantiser, pixels: &mut levels };
    let rendered = Engine::new(scene).with(settings).render_planned(plan, target);
    rendered.expect("the limit allows it");
    levels
}

/// The scene's plan, and all but one omission at a time, against a plan that omits nothing.
fn check(name: &str, scene: &Scene, samples: u32) -> Result<(), String> {
    check_in::<f32>(name, scene, samples, |compiled, grid, everything, plan| {
        levels(compiled, grid, plan) == levels(compiled, grid, everything)
    })?;
    check_in::<f64>(name, scene, samples, |_, _, _, _| true)
}

fn check_in<S: Real>(
    name: &str,
    scene: &Scene,
    samples: u32,
    same_levels: impl Fn(&Compiled<S>, &Grid<S>, &Plan<S>, &Plan<S>) -> bool,
) -> Result<(), String> {
    let view = View::new(scene, None, samples).expect("whole");
    let (compiled, grid) = (Compiled::<S>::of(scene), Grid::of(&view));
    let everything = Plan::new(&compiled, &grid).everything();
    assert!(everything.omissions() == Omissions::NONE && everything.depth() == compiled.max_depth);
    let plan = Plan::new(&compiled, &grid);
    let mut plans = vec![plan.clone()];
    plans.extend(plan.omissions().iter().map(|omission| plan.clone().without(omission)));
    for isa in Isa::ALL.into_iter().filter(|&isa| isa <= Isa::detected()) {
        let expected = render(&compiled, &grid, &everything, isa);
        for plan in &plans {
            let found = render(&compiled, &grid, plan, isa);
            if found != expected || !same_levels(&compiled, &grid, &everything, plan) {
                let text = scene.to_text(catoptric_scene::SceneFormat::Toml);
                let scalar = std::any::type_name::<S>();
                return Err(format!(
                    "{name}, {scalar}, {isa}: {plan:?} changes the picture or its counts\n{text}"
                ));
            }
        }
    }
    Ok(())
}

#[test]
fn every_plan_of_every_scene() {
    for (name, draft) in scenes::all() {
        for numerics in [Numerics::Robust, Numerics::Textbook] {
            let mut draft = draft.clone();
            draft.render.numerics = numerics;
            let scene = scenes::sized(&draft, 181, 97, draft.render.max_depth);
            check(&name, &scene, 1).unwrap_or_else(|report| panic!("{report}"));
        }
    }
    let scene = scenes::sized(&scenes::named("workshop"), 70, 50, 5);
    check("samples", &scene, 3).unwrap_or_else(|report| panic!("{report}"));
}

proptest! {
    #![proptest_config(config())]

    #[test]
    fn every_plan_of_generated_scenes(scene in generate::scene(12, (1u32..=70, 1u32..=40))) {
        check("generated", &scene, 1).map_err(TestCaseError::fail)?;
    }

    /// Rims and horizons across tiles' borders.
    #[test]
    fn every_plan_of_rims(scene in generate::rim((1u32..=130, 1u32..=40))) {
        check("rim", &scene, 1).map_err(TestCaseError::fail)?;
    }

    /// A single place, where bounds are tightest.
    #[test]
    fn every_plan_of_grazes(scene in generate::graze()) {
        check("graze", &scene, 1).map_err(TestCaseError::fail)?;
    }

    /// A place far from its lamp.
    #[test]
    fn every_plan_of_far_grazes(scene in generate::far_graze()) {
        check("far graze", &scene, 1).map_err(TestCaseError::fail)?;
    }

    /// Balls just inside another one, and just out of it.
    #[test]
    fn every_plan_of_nests(scene in generate::nested((1u32..=40, 1u32..=24))) {
        check("nested", &scene, 1).map_err(TestCaseError::fail)?;
    }

    /// Shadows that a ball's rim grazes.
    #[test]
    fn every_plan_of_eclipses(scene in generate::eclipse((1u32..=70, 1u32..=40))) {
        check("eclipse", &scene, 1).map_err(TestCaseError::fail)?;
    }
}

/// `PROPTEST_CASES` asks for more or fewer.
fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { default.cases } else { 500 };
    ProptestConfig { cases, failure_persistence: None, ..default }
}

/// A plan of the workshop says what it is known to need.
#[test]
fn the_workshop_is_known() {
    let scene = scenes::sized(&scenes::named("workshop"), 1920, 1080, 5);
    let (compiled, grid) = (Compiled::new(&scene), Grid::new(&View::whole(&scene)));
    let plan = Plan::new(&compiled, &grid);
    let features = Features {
        spheres: 4,
        large_spheres: 1,
        mirrors: 4,
        lights: 1,
        highlight: true,
        samples: 1,
        ..Features::default()
    };
    assert_eq!(*plan.features(), features);
    assert_eq!(plan.depth(), 5);
    let omitted: Vec<_> = plan.omissions().iter().collect();
    assert_eq!(omitted, [Omission::Tiles, Omission::Occluders, Omission::Directions]);
    // The yellow and the gray ball (2 and 4) stand free; nothing is in the ground's shadow.
    let hide = |receiver| occluders(&compiled, 0, receiver);
    assert_eq!((hide(2), hide(4)), (vec![], vec![]));
    assert_eq!(hide(0), [1, 2, 3, 4]);
    assert!((0..5).all(|receiver| !hide(receiver).contains(&0)));
    let TileCandidates { tiles, empty, tried } = tile_candidates(&compiled, &grid);
    assert!(empty * 8 > tiles, "{empty} of {tiles} tiles show nothing");
    assert!(tried < 2 * tiles, "{tried} of {tiles} tiles' 5 primitives are tried");
}

/// Reflections that can occur: none without a mirror, one with a single convex one.
#[test]
fn depths_end() {
    let depth = |change: &dyn Fn(&mut Draft)| {
        let mut draft = scenes::named("workshop");
        change(&mut draft);
        let scene = scenes::sized(&draft, 16, 9, 9);
        Plan::new(&Compiled::new(&scene), &Grid::new(&View::whole(&scene))).depth()
    };
    let mirrors = |draft: &mut Draft, count: usize| {
        for (index, sphere) in draft.spheres.iter().enumerate() {
            draft.materials[sphere.material].reflect = Some(if index < count { 0.5 } else { 0.0 });
        }
    };
    assert_eq!(depth(&|draft| mirrors(draft, 0)), 0);
    assert_eq!(depth(&|draft| mirrors(draft, 1)), 1);
    assert_eq!(depth(&|draft| mirrors(draft, 2)), 9);
    // From inside, a sphere mirrors itself.
    assert_eq!(
        depth(&|draft| {
            draft.spheres.truncate(1);
            draft.spheres[0] = Sphere { center: [0.0; 3], radius: 9.0, ..draft.spheres[0] };
            mirrors(draft, 1);
        }),
        9
    );
    // A plane does not.
    assert_eq!(
        depth(&|draft| {
            let material = draft.materials[draft.spheres[1].material];
            mirrors(draft, 0);
            let (point, normal) = ([0.0, -4.0, 0.0], [0.0, 1.0, 0.0]);
            draft.planes.push(Plane { point, normal, material: draft.materials.add(material) });
        }),
        1
    );
    // 0.5 and 0.25 are not below the cut, 0.125 is; a cut above 1 leaves no mirror.
    for (min_weight, reflections) in [(0.25, 2), (0.251, 1), (0.51, 0), (2.0, 0), (1e-9, 9)] {
        assert_eq!(
            depth(&|draft| {
                draft.render.min_weight = min_weight;
                mirrors(draft, 2);
            }),
            reflections,
            "cut at {min_weight}"
        );
    }
    // The workshop's offset may put a ray inside.
    assert_eq!(
        depth(&|draft| {
            draft.render.numerics = Numerics::Textbook;
            mirrors(draft, 1);
        }),
        9
    );
}
