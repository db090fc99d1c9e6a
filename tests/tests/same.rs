//! What must change no bit: a thing that no ray meets, and where the scene lies in the world.

use catoptric_core::Isa;
use catoptric_scene::{Compiled, Grid, Scene, SceneFormat, View};
use catoptric_tests::identity::{Backend, Real, different_pixels, packets, recursive};
use catoptric_tests::{turned, unseen};
use proptest::prelude::*;

proptest! {
    #![proptest_config(config())]

    #[test]
    fn what_no_ray_meets_changes_nothing(pair in unseen::pair()) {
        same_pictures(&pair)?;
    }

    #[test]
    fn turned_and_moved_scenes_are_the_same_picture(pair in turned::pair()) {
        same_pictures(&pair)?;
    }
}

/// By both engines, in f32 and in f64.
fn same_pictures(pair: &[Scene; 2]) -> Result<(), TestCaseError> {
    same_in::<f32>(pair)?;
    same_in::<f64>(pair)
}

fn same_in<S: Real>(pair: &[Scene; 2]) -> Result<(), TestCaseError> {
    let backend = Backend { isa: Isa::detected(), threads: 1 };
    let [by_recursion, by_packets] = [
        pair.each_ref().map(|scene| recursive(&compiled::<S>(scene), &grid(scene))),
        pair.each_ref().map(|scene| packets(&compiled::<S>(scene), &grid(scene), backend)),
    ];
    for (engine, [once, again]) in [("recursion", by_recursion), ("packets", by_packets)] {
        let mut report = different_pixels(&once.0, &again.0).unwrap_or_default();
        if once.1 != again.1 {
            report += &format!("rays were {:?}, are {:?}\n", once.1, again.1);
        }
        if !report.is_empty() {
            let [once, again] = pair.each_ref().map(|scene| scene.to_text(SceneFormat::Toml));
            return Err(TestCaseError::fail(format!(
                "{engine} in {} differs\n{report}{once}\n# and\n{again}",
                std::any::type_name::<S>()
            )));
        }
    }
    Ok(())
}

fn compiled<S: Real>(scene: &Scene) -> Compiled<S> {
    Compiled::of(scene)
}

fn grid<S: Real>(scene: &Scene) -> Grid<S> {
    Grid::of(&View::whole(scene))
}

/// `PROPTEST_CASES` asks for more or fewer.
fn config() -> ProptestConfig {
    let default = ProptestConfig::default();
    let cases = if std::env::var_os("PROPTEST_CASES").is_some() { default.cases } else { 2_000 };
    ProptestConfig { cases, failure_persistence: None, ..default }
}
