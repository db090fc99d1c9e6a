//! The test that equates the recursion and the engine.
//!
//! A picture is rendered by the recursion, then by every backend of the engine, and compared
//! as bits, with the ray counts of every depth; once in f32 and once in f64. There is no
//! tolerance. A NaN equals a NaN, whatever its payload, which no processor promises.

use std::fmt::Write;
use std::path::PathBuf;
use std::sync::LazyLock;

use catoptric_core::{Engine, Isa, Levels, PacketScalar, Settings};
use catoptric_reference::TooDeep;
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

/// A scalar in which the two are compared.
pub trait Real: PacketScalar {
    /// Renders by the recursion in this scalar.
    ///
    /// # Errors
    /// As [`catoptric_reference::render`].
    fn recursion(
        scene: &Compiled<Self>,
        grid: &Grid<Self>,
        film: &mut Film<Self>,
    ) -> Result<Counts, TooDeep>;

    /// Its bit pattern.
    fn bits(self) -> u64;

    /// The bit pattern without its sign: grows by 1 from each positive number to the next.
    fn magnitude(self) -> u64;
}

macro_rules! real {
    ($scalar:ty, $render:path) => {
        impl Real for $scalar {
            fn recursion(
                scene: &Compiled<Self>,
                grid: &Grid<Self>,
                film: &mut Film<Self>,
            ) -> Result<Counts, TooDeep> {
                $render(scene, grid, film, &|_| ())
            }

            fn bits(self) -> u64 {
                self.to_bits().into()
            }

            fn magnitude(self) -> u64 {
                self.abs().to_bits().into()
            }
        }
    };
}

real!(f32, catoptric_reference::render);
real!(f64, catoptric_reference::double::render);

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
pub fn recursive<S: Real>(scene: &Compiled<S>, grid: &Grid<S>) -> (Film<S>, Counts) {
    let mut film = Film::black(grid.width, grid.height);
    let counts = pool(2).install(|| S::recursion(scene, grid, &mut film));
    (film, counts.expect("the recursion's stack holds the path"))
}

/// A rendering by the engine.
///
/// # Panics
/// If its stack passes 8 GiB.
#[must_use]
pub fn packets<S: Real>(
    scene: &Compiled<S>,
    grid: &Grid<S>,
    backend: Backend,
) -> (Film<S>, Counts) {
    let mut film = Film::black(grid.width, grid.height);
    let settings = Settings { isa: backend.isa, stack_limit: 8 << 30 };
    let pool = pool(backend.threads);
    let counts = pool.install(|| Engine::new(scene).with(settings).render(grid, &mut film));
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
        let target = Levels { quantiser, pixels: &mut levels };
        Engine::new(scene).with(settings).render(grid, target).map(|_| ())
    });
    rendered.expect("the engine's stack holds the path");
    levels
}

/// Renders a view both ways on every backend, in f32 and in f64.
///
/// # Errors
/// What differs: scene, scalar, view, backend, the first pixel with both values as bits and their
/// distance in ulps, how many pixels, the counts, and where a picture of the differences lies.
pub fn check(name: &str, scene: &Scene, view: &View) -> Result<(), String> {
    check_in::<f32>(name, scene, view)?;
    check_in::<f64>(name, scene, view)
}

fn check_in<S: Real>(name: &str, scene: &Scene, view: &View) -> Result<(), String> {
    let compiled = Compiled::<S>::of(scene);
    let grid = Grid::of(view);
    let expected = recursive(&compiled, &grid);
    for backend in backends() {
        let found = packets(&compiled, &grid, backend);
        let mut report = different_pixels(&expected.0, &found.0).unwrap_or_default();
        if expected.1 != found.1 {
            let _ = writeln!(report, "recursion counted {:?}", expected.1);
            let _ = writeln!(report, "engine counted    {:?}", found.1);
        }
        if !report.is_empty() {
            let picture = difference_picture(name, &expected.0, &found.0);
            let text = scene.to_text(SceneFormat::Toml);
            return Err(format!(
                "{name} in {} differs, {backend:?}, {view:?}\n{report}differences: {}\n{text}",
                std::any::type_name::<S>(),
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
fn same<S: Real>(a: S, b: S) -> bool {
    a.bits() == b.bits() || (a.to_f64().is_nan() && b.to_f64().is_nan())
}

fn differs<S: Real>(a: [S; 3], b: [S; 3]) -> bool {
    !a.into_iter().zip(b).all(|(a, b)| same(a, b))
}

/// What differs between two pictures of one size: the first pixel with both values as bits
/// and their distance in ulps, and how many pixels.
#[must_use]
pub fn different_pixels<S: Real>(expected: &Film<S>, found: &Film<S>) -> Option<String> {
    let pairs = expected.pixels().iter().zip(found.pixels()).enumerate();
    let mut different = pairs.filter(|(_, (a, b))| differs(**a, **b)).peekable();
    let &(first, (a, b)) = different.peek()?;
    let width = expected.width() as usize;
    let mut report = format!("first at pixel ({}, {})\n", first % width, first / width);
    for (channel, (a, b)) in ["red", "green", "blue"].iter().zip(a.iter().zip(b)) {
        let (x, y, digits) = (a.bits(), b.bits(), 2 * size_of::<S>());
        let ulps = ordered(*a).abs_diff(ordered(*b));
        let _ = write!(report, "{channel:5} {a:?} ({x:0digits$x}), ");
        let _ = writeln!(report, "{b:?} ({y:0digits$x}): {ulps} ulps");
    }
    let _ = writeln!(report, "{} pixels of {}", different.count(), expected.pixels().len());
    Some(report)
}

/// A number that grows by 1 from each scalar to the next.
fn ordered<S: Real>(x: S) -> i64 {
    let (bits, magnitude) = (x.bits(), x.magnitude());
    let from_zero = magnitude.cast_signed();
    if bits == magnitude { from_zero } else { -from_zero }
}

/// Writes a picture with every differing pixel in white. The name is made safe for a file.
fn difference_picture<S: Real>(name: &str, expected: &Film<S>, found: &Film<S>) -> PathBuf {
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
