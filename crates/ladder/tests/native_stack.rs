//! Who uses the native stack, and how much of it.

use catoptric_core::Isa;
use catoptric_ladder::{DEEPEST, Error, FORWARD, RUNGS, Rung, native_stack};
use catoptric_reference::DEPTH_ALLOWED;
use catoptric_scene::{Film, Scene};
use catoptric_tests::identity::pool;
use catoptric_tests::scenes;
use rayon::ThreadPoolBuilder;

use crate::comparison::{settings, view};

/// The closed room as a perfect mirror, so that no path ends before `max_depth`.
fn closed_room(width: u32, max_depth: u32) -> Scene {
    let mut draft = scenes::named("closed-room");
    for material in draft.materials.iter_mut() {
        material.reflect = Some(1.0);
    }
    scenes::sized(&draft, width, 1, max_depth)
}

/// Native stack that one eye ray's path takes.
fn bytes(rung: &Rung, depth: u32) -> usize {
    let (scene, grid) = view(&closed_room(1, depth), 1);
    let settings = settings(Isa::detected());
    let (watched, bytes) = pool(1)
        .install(|| native_stack(|watch| (rung.watch)(&scene, &grid, (0, 0), settings, watch)));
    watched.unwrap_or_else(|error| panic!("{}: {error}", rung.name));
    bytes
}

/// Bytes of native stack that a path takes for every mirror. A frame is a frame: that is a
/// whole number, at any depth.
pub(crate) fn bytes_a_mirror(rung: &Rung) -> usize {
    let [short, middle, long] = [1_000, 2_000, 3_000].map(|depth| bytes(rung, depth));
    assert_eq!(middle - short, long - middle, "{}", rung.name);
    assert_eq!((long - middle) % 1_000, 0, "{}", rung.name);
    (long - middle) / 1_000
}

/// `--nocapture` shows it; `readme.rs` compares it with the table.
#[test]
fn growth_is_as_the_table_says() {
    for rung in RUNGS.iter().chain([&FORWARD]) {
        let (growth, short) = (bytes_a_mirror(rung), bytes(rung, 1_000));
        println!("{:8} {growth} bytes a mirror, and {}", rung.name, short - 1_000 * growth);
        assert_eq!(growth > 0, rung.grows_native_stack, "{}", rung.name);
        assert!(rung.grows_native_stack || short < 32 << 10, "{}: {short} bytes", rung.name);
    }
}

/// Also where the constant part of a path's stack is most of it.
#[test]
fn continuations_take_more_than_calls() {
    for depth in [1, 5, 1_000] {
        let [calls, continuations] = [&RUNGS[0], &RUNGS[1]].map(|rung| bytes(rung, depth));
        assert!(continuations > calls, "at depth {depth}: {continuations} and {calls} bytes");
    }
}

#[test]
fn a_small_stack_holds_any_depth_without_calls() {
    let small = ThreadPoolBuilder::new().num_threads(1).stack_size(64 << 10).build();
    let small = small.expect("a thread can be started");
    for rung in RUNGS.iter().filter(|rung| !rung.grows_native_stack) {
        let (scene, grid) = view(&closed_room(2, DEEPEST), 1);
        let mut film = Film::new(grid.width, grid.height);
        let counts =
            small.install(|| (rung.render)(&scene, &grid, &mut film, settings(Isa::detected())));
        let counts = counts.unwrap_or_else(|error| panic!("{}: {error}", rung.name));
        assert_eq!(counts.depths.len(), DEEPEST as usize + 1, "{}", rung.name);
    }
}

/// What the rungs refuse, they refuse; what they allow, they render.
#[test]
fn too_deep_is_an_error() {
    for rung in RUNGS.iter().chain([&FORWARD]).filter(|rung| rung.name != "r5") {
        let deepest = if rung.grows_native_stack { DEPTH_ALLOWED } else { DEEPEST };
        let render = |depth| {
            let (scene, grid) = view(&closed_room(3, depth), 1);
            let mut film = Film::new(grid.width, grid.height);
            pool(1)
                .install(|| (rung.render)(&scene, &grid, &mut film, settings(Isa::detected())))
                .map(|_| ())
        };
        assert_eq!(render(deepest), Ok(()), "{}", rung.name);
        assert_eq!(render(u32::MAX), Err(Error::TooDeep { deepest }), "{}", rung.name);
        let (scene, grid) = view(&closed_room(1, deepest + 1), 1);
        let watched = pool(1).install(|| {
            (rung.watch)(&scene, &grid, (0, 0), settings(Isa::detected()), &mut Vec::new())
        });
        assert_eq!(watched, Err(Error::TooDeep { deepest }), "{}", rung.name);
    }
}
