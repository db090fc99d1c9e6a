//! Bytes as a scene in both formats: read, validated, compiled, written, read back and
//! rendered by both renderers, whose pictures must have the same bits.

#![no_main]

#[path = "../numbers.rs"]
mod numbers;

use std::sync::LazyLock;

use catoptric_core::{Engine, Isa, Settings};
use catoptric_scene::{
    Body, Compiled, Counts, Document, Draft, Film, Grid, MaterialId, Numerics, Scene, SceneError,
    SceneFormat, View,
};
use libfuzzer_sys::{fuzz_mutator, fuzz_target, fuzzer_mutate};
use rayon::{ThreadPool, ThreadPoolBuilder};

fuzz_target!(|bytes: &[u8]| {
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        match Document::parse("fuzz", bytes, format).and_then(Document::into_scene) {
            Ok(scene) => accepted(&scene, size(bytes)),
            Err(error) => refused(&error, bytes),
        }
    }
});

// Bytes changed at random seldom leave a scene; every second time a number is changed instead.
fuzz_mutator!(|data: &mut [u8], size: usize, max_size: usize, seed: u32| {
    let changed = if seed.is_multiple_of(2) { None } else { numbers::change(&data[..size], seed) };
    match changed {
        Some(text) if text.len() <= max_size => {
            data[..text.len()].copy_from_slice(text.as_bytes());
            text.len()
        }
        _ => fuzzer_mutate(data, size, max_size),
    }
});

/// Columns and rows to render: few; for one input in sixteen more than a tile of 64 x 8, since
/// the engine decides by tile which primitives its eye rays try.
fn size(bytes: &[u8]) -> (u32, u32) {
    if bytes.len().is_multiple_of(16) { (67, 9) } else { (3, 2) }
}

/// A message names the file, and a place is a place of the text.
fn refused(error: &SceneError, bytes: &[u8]) {
    let message = error.to_string();
    assert!(message.starts_with("fuzz: "), "{message}");
    if let Some((line, column)) = error.position() {
        let text = std::str::from_utf8(bytes).expect("a place in text");
        let shown = text.split('\n').nth(line - 1).expect("a line of the text");
        assert!((1..=shown.chars().count() + 1).contains(&column), "{message}");
    }
}

fn accepted(scene: &Scene, size: (u32, u32)) {
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        let text = scene.to_text(format);
        let again = Document::parse("written", text.as_bytes(), format)
            .and_then(Document::into_scene)
            .unwrap_or_else(|error| panic!("{error}\n{text}"));
        assert_eq!(stated(&again), stated(scene), "{text}");
    }
    // Compiles whatever the size of the picture is.
    let _ = Compiled::new(scene);
    for numerics in [Numerics::Robust, Numerics::Textbook] {
        if let Some(small) = small(scene, numerics, size) {
            agree(&small);
        }
    }
}

/// All that a scene states, whatever the numbers of its materials: Debug tells all bits of every
/// number, the sign of a zero included.
fn stated(scene: &Scene) -> String {
    let Draft { image, camera, render, lights, materials, .. } = &**scene;
    let made = |id: MaterialId| (materials.name(id), &materials[id]);
    let named: Vec<_> = materials.named().collect();
    let bodies: Vec<_> = scene.bodies().map(|body| (place(body), made(body.material()))).collect();
    format!("{:?}", (image, camera, render, lights, named, bodies))
}

fn place(body: Body<'_>) -> ([f64; 3], [f64; 3]) {
    match body {
        Body::Sphere(sphere) => (sphere.center, [sphere.radius; 3]),
        Body::Plane(plane) => (plane.point, plane.normal),
    }
}

/// The scene with few pixels and few mirrors; `None` where it has many bodies, or a field of
/// view that is too extreme for these proportions.
fn small(scene: &Scene, numerics: Numerics, size: (u32, u32)) -> Option<Scene> {
    let mut draft = scene.clone().into_draft();
    if draft.spheres.len() + draft.planes.len() + draft.lights.len() > 100 {
        return None;
    }
    (draft.image.width, draft.image.height) = size;
    draft.render.max_depth = draft.render.max_depth.min(8);
    draft.render.numerics = numerics;
    Scene::new(draft).ok()
}

/// This thread alone, so that the fuzzer sees what is covered and nothing waits.
static HERE: LazyLock<ThreadPool> = LazyLock::new(|| {
    ThreadPoolBuilder::new().num_threads(1).use_current_thread().build().expect("this thread")
});

/// Both renderers give the same bits and the same counts, on every instruction set.
fn agree(scene: &Scene) {
    let compiled = Compiled::new(scene);
    let grid = Grid::new(&View::whole(scene));
    let film = || Film::new(grid.width, grid.height);

    let mut expected = film();
    let counts = HERE
        .install(|| catoptric_reference::render(&compiled, &grid, &mut expected, &|_| ()))
        .expect("few mirrors");
    for isa in Isa::ALL.into_iter().filter(|&isa| isa <= Isa::detected()) {
        let settings = Settings { isa, stack_limit: 1 << 20 };
        let mut found = film();
        let counted = HERE
            .install(|| Engine::new(&compiled).with(settings).render(&grid, &mut found))
            .expect("few mirrors");
        same(&expected, &found, isa, scene);
        same_counts(&counts, &counted, isa, scene);
    }
}

fn same(expected: &Film, found: &Film, isa: Isa, scene: &Scene) {
    let values = |film: &Film| film.pixels().as_flattened().to_vec();
    for (at, (a, b)) in values(expected).into_iter().zip(values(found)).enumerate() {
        assert!(
            a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan()),
            "value {at}: recursion {a:e} ({:08x}), {isa} {b:e} ({:08x})\n{}",
            a.to_bits(),
            b.to_bits(),
            scene.to_text(SceneFormat::Toml)
        );
    }
}

fn same_counts(expected: &Counts, found: &Counts, isa: Isa, scene: &Scene) {
    assert_eq!(expected, found, "{isa}\n{}", scene.to_text(SceneFormat::Toml));
}
