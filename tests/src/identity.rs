//! The test that equates the recursion and the engine.
//!
//! A picture is rendered by the recursion, then by every backend of the engine, and compared
//! as bits, with the ray counts of every depth. There is no tolerance. A NaN equals a NaN,
//! whatever its payload, which no processor promises.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::LazyLock;

use catoptric_core::{Isa, Settings, render_levels};
use catoptric_scene::{Compiled, Counts, Film, Grid, Quantiser, Scene, SceneFormat, View};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// One way to run the engine.
#[derive(Clone, Copy, Debug)]
pub struct Backend {
    /// The instruction set.
    pub isa: Isa,
    /// How many threads.
    pub threads: usize,
}

/// Every backend that this processor can run.
#[must_use]
pub fn backends() -> Vec<Backend> {
    let isas = Isa::ALL.into_iter().filter(|&isa| isa <= Isa::detected());
    isas.flat_map(|isa| [1, 2].map(|threads| Backend { isa, threads })).collect()
}

/// One or two threads, started once, with stacks that hold the recursion's deepest path.
///
/// # Panics
/// For another number, or if they cannot be started.
#[must_use]
pub fn pool(threads: usize) -> &'static ThreadPool {
    static POOLS: LazyLock<[ThreadPool; 2]> = LazyLock::new(|| {
        [1, 2].map(|threads| {
            ThreadPoolBuilder::new()
                .num_threads(threads)
                .stack_size(catoptric_reference::STACK_BYTES)
                .build()
                .expect("threads can be started")
        })
    });
    &POOLS[threads - 1]
}

/// A rendering by the recursion.
///
/// # Panics
/// If a path is too deep for it.
#[must_use]
pub fn recursive(scene: &Compiled, grid: &Grid) -> (Film, Counts) {
    let mut film = Film::new(grid.width, grid.height);
    let counts = pool(2).install(|| catoptric_reference::render(scene, grid, &mut film, &|_| ()));
    (film, counts.expect("the recursion's stack holds the path"))
}

/// A rendering by the engine.
///
/// # Panics
/// If its stack passes 8 GiB.
#[must_use]
pub fn packets(scene: &Compiled, grid: &Grid, backend: Backend) -> (Film, Counts) {
    let mut film = Film::new(grid.width, grid.height);
    let settings = Settings { isa: backend.isa, stack_limit: 8 << 30 };
    let pool = pool(backend.threads);
    let counts = pool.install(|| catoptric_core::render(scene, grid, &mut film, settings, &|_| ()));
    (film, counts.expect("the engine's stack holds the path"))
}

/// A rendering by the engine straight to 8-bit levels.
///
/// # Panics
/// If its stack passes 8 GiB.
#[must_use]
pub fn packet_levels(
    scene: &Compiled,
    grid: &Grid,
    quantiser: &Quantiser,
    backend: Backend,
) -> Vec<[u8; 3]> {
    let mut levels = vec![[0; 3]; grid.width as usize * grid.height as usize];
    let settings = Settings { isa: backend.isa, stack_limit: 8 << 30 };
    let pool = pool(backend.threads);
    let rendered = pool.install(|| {
        render_levels(scene, grid, quantiser, &mut levels, settings, &|_| ()).map(|_| ())
    });
    rendered.expect("the engine's stack holds the path");
    levels
}

/// Renders a view both ways on every backend.
///
/// # Errors
/// What differs: scene, view, backend, the first pixel with both values as bits and their
/// distance in ulps, how many pixels, the counts, and where a picture of the differences lies.
pub fn check(name: &str, scene: &Scene, view: &View) -> Result<(), String> {
    let compiled = Compiled::new(scene);
    let grid = Grid::new(view);
    let expected = recursive(&compiled, &grid);
    for backend in backends() {
        let found = packets(&compiled, &grid, backend);
        let mut report = String::new();
        describe_pixels(&mut report, &expected.0, &found.0);
        if expected.1 != found.1 {
            let _ = writeln!(report, "recursion counted {:?}", expected.1);
            let _ = writeln!(report, "engine counted    {:?}", found.1);
        }
        if !report.is_empty() {
            let picture = difference_picture(name, &expected.0, &found.0);
            let text = scene.to_text(SceneFormat::Toml);
            return Err(format!(
                "{name} differs, {backend:?}, {view:?}\n{report}differences: {}\n{text}",
                picture.display()
            ));
        }
    }
    Ok(())
}

/// [`check`] on the whole picture, one sample a pixel.
///
/// # Panics
/// With the description of what differs.
pub fn assert_identical(name: &str, scene: &Scene) {
    if let Err(report) = check(name, scene, &View::whole(scene)) {
        panic!("{report}");
    }
}

/// Whether two values are the same picture: equal bits, or both NaN.
fn same(a: f32, b: f32) -> bool {
    a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan())
}

fn differs(a: [f32; 3], b: [f32; 3]) -> bool {
    !a.into_iter().zip(b).all(|(a, b)| same(a, b))
}

fn describe_pixels(report: &mut String, expected: &Film, found: &Film) {
    let pairs = expected.pixels().iter().zip(found.pixels()).enumerate();
    let mut different = pairs.filter(|(_, (a, b))| differs(**a, **b)).peekable();
    let Some(&(first, (a, b))) = different.peek() else {
        return;
    };
    let width = expected.width() as usize;
    let _ = writeln!(report, "first at pixel ({}, {})", first % width, first / width);
    for (channel, (a, b)) in ["red", "green", "blue"].iter().zip(a.iter().zip(b)) {
        let (x, y) = (a.to_bits(), b.to_bits());
        let ulps = ordered(*a).abs_diff(ordered(*b));
        let _ = writeln!(report, "{channel:5} {a:e} ({x:08x}), {b:e} ({y:08x}): {ulps} ulps");
    }
    let _ = writeln!(report, "{} pixels of {}", different.count(), expected.pixels().len());
}

/// A number that grows by 1 from each f32 to the next.
fn ordered(x: f32) -> i64 {
    let magnitude = i64::from(x.to_bits() & 0x7fff_ffff);
    if x.is_sign_negative() { -magnitude } else { magnitude }
}

/// Writes a picture with every differing pixel in white. The name is made safe for a file.
fn difference_picture(name: &str, expected: &Film, found: &Film) -> PathBuf {
    let safe = name.replace(|c: char| !c.is_ascii_alphanumeric(), "-");
    let path = std::env::temp_dir().join(format!("catoptric-difference-{safe}.png"));
    let pairs = expected.pixels().iter().zip(found.pixels());
    let bytes: Vec<u8> = pairs.map(|(a, b)| if differs(*a, *b) { 255 } else { 0 }).collect();
    let (width, height) = (expected.width(), expected.height());
    let written = image::save_buffer(&path, &bytes, width, height, image::ColorType::L8);
    match written {
        Ok(()) => path,
        Err(error) => PathBuf::from(format!("(no picture: {error})")),
    }
}
