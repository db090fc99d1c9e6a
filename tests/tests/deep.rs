//! Deep paths: equal bits as far as the recursion goes, and no recursion in the engine.

use std::sync::atomic::{AtomicU64, Ordering};

use catoptric_core::{Engine, Isa, Settings, StackFull};
use catoptric_reference::DEPTH_ALLOWED;
use catoptric_scene::{Compiled, Counts, Film, Grid, Numerics, Scene, View};
use catoptric_tests::identity::{assert_identical, backends};
use catoptric_tests::{crowds, scenes};
use proptest::prelude::*;

/// The closed room as a perfect mirror, so that no path ends before `max_depth`.
fn closed_room(width: u32, height: u32, max_depth: u32) -> Scene {
    let mut draft = scenes::named("closed-room");
    for material in draft.materials.iter_mut() {
        material.reflect = Some(1.0);
    }
    scenes::sized(&draft, width, height, max_depth)
}

fn render(scene: &Scene, settings: Settings) -> Result<(Film, Counts), StackFull> {
    render_telling(scene, settings, &|_| ())
}

/// [`render`], telling `progress` how many pixels were added.
fn render_telling(
    scene: &Scene,
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<(Film, Counts), StackFull> {
    let (compiled, grid) = (Compiled::new(scene), Grid::new(&View::whole(scene)));
    let mut film = Film::new(grid.width, grid.height);
    let counts = Engine::new(&compiled).with(settings).reporting(progress).render(&grid, &mut film);
    counts.map(|counts| (film, counts))
}

#[test]
fn closed_rooms_to_10_000() {
    for depth in [100, 1_000, 10_000] {
        let mut draft = scenes::named("closed-room");
        assert_identical("closed-room", &scenes::sized(&draft, 11, 7, depth));
        assert_identical("perfect room", &closed_room(11, 7, depth));
        draft.render.numerics = Numerics::Textbook;
        assert_identical("textbook room", &scenes::sized(&draft, 11, 7, depth));
    }
}

#[test]
fn as_deep_as_the_recursion_goes() {
    assert_identical("perfect room", &closed_room(3, 1, DEPTH_ALLOWED));
}

/// A recursion of any kind, one frame a reflection, would need 16 bytes a frame or less to
/// survive the first 4 096 reflections.
#[test]
fn a_million_reflections_on_a_small_stack() {
    const DEPTH: u32 = 1_000_000;
    let scene = closed_room(5, 2, DEPTH);
    for backend in backends() {
        let small = rayon::ThreadPoolBuilder::new()
            .num_threads(backend.threads)
            .stack_size(64 << 10)
            .build()
            .expect("threads can be started");
        let settings = Settings { isa: backend.isa, stack_limit: 2 << 30 };
        let (film, counts) =
            small.install(|| render(&scene, settings)).expect("the limit allows it");
        assert_eq!(counts.depths.len(), DEPTH as usize + 1, "every path goes on to the end");
        assert!(counts.depths.iter().all(|d| d.rays == 10 && d.hits == 10), "no ray escapes");
        assert!(film.pixels().iter().flatten().all(|x| x.is_finite() && *x > 0.0));
    }
}

#[test]
fn a_limit_on_the_stack_is_kept() {
    let settings = |stack_limit| Settings { isa: Isa::detected(), stack_limit };
    let deep = closed_room(4, 4, u32::MAX);
    assert_eq!(
        render(&deep, settings(1 << 20)).map(|_| ()),
        Err(StackFull { limit: 1 << 20 }),
        "a closed room at the largest depth needs 550 GB"
    );
    // Shallow paths take nothing from it, also where some rays of a packet end by their weight.
    let mut cut = scenes::named("closed-room");
    cut.render.min_weight = 0.2;
    for depth in 0..16 {
        assert!(render(&closed_room(70, 40, depth), settings(0)).is_ok(), "{depth}");
        assert!(render(&scenes::sized(&cut, 70, 40, depth), settings(0)).is_ok(), "{depth}");
    }
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 100, failure_persistence: None, ..ProptestConfig::default() })]

    /// Whatever a tile's rays meet, shallow paths take nothing from the limit: not where each ray
    /// meets a primitive of its own, in any mixture of those that end and those that go on.
    #[test]
    fn a_stack_begins_with_all_that_shallow_paths_take(
        scene in crowds::a_sphere_a_pixel((32u32..=64, 16u32..=32), 0u32..=24)
    ) {
        let settings = Settings { isa: Isa::detected(), stack_limit: 0 };
        prop_assert!(render(&scene, settings).is_ok());
    }
}

/// The eye at the centre of a perfect mirror: its rays come back and go on for ever, but for those
/// that a dull ball stops, in all bands of rows but the first.
#[test]
fn once_a_stack_is_full_no_further_band_is_traced() {
    let mut draft = scenes::named("closed-room");
    draft.camera.position = [0.0; 3];
    draft.camera.look_at = [0.0, 0.0, -1.0];
    draft.spheres.truncate(2);
    let [room, dull] = &mut draft.spheres[..] else { panic!("two spheres") };
    room.center = [0.0; 3];
    (dull.center, dull.radius) = ([0.0, -0.77, -4.94], 2.7);
    draft.materials[room.material].reflect = Some(1.0);
    draft.materials[dull.material].reflect = Some(0.0);
    let traced = |max_depth, stack_limit| {
        let scene = scenes::sized(&draft, 32, 64, max_depth);
        let settings = Settings { isa: Isa::detected(), stack_limit };
        let pixels = AtomicU64::new(0);
        // One thread takes the bands from the top down.
        let pool = rayon::ThreadPoolBuilder::new().num_threads(1).build().expect("a thread");
        let done = pool.install(|| {
            render_telling(&scene, settings, &|more| {
                pixels.fetch_add(more, Ordering::Relaxed);
            })
        });
        let done = done.map(|(_, counts)| counts);
        (done, pixels.into_inner())
    };
    let (counts, pixels) = traced(2, 0);
    let counts = counts.expect("shallow paths take nothing from the limit");
    let reflected = counts.depths[2].rays;
    assert!(0 < reflected && reflected < 32 * 16, "rays of the first band alone go on");
    assert_eq!(pixels, 32 * 64);
    let (counts, pixels) = traced(u32::MAX, 1 << 20);
    assert_eq!(counts, Err(StackFull { limit: 1 << 20 }));
    assert_eq!(pixels, 0, "pixels traced though the picture was lost");
}
