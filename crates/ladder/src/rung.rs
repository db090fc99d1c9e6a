//! The table of rungs.

use catoptric_core::Settings;
use catoptric_reference::DEPTH_ALLOWED;
use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;

use crate::r2_frames::Owed;
use crate::{
    DEEPEST, Error, PendingBounce, Watch, aside_forward, r0_recursion, r1_continuations, r2_frames,
    r3_loop, r4_packets, r5_engine, render_by, watch_by,
};

/// Renders a view into a film of its size, on rayon's current threads.
///
/// The threads' stacks must hold [`STACK_BYTES`](catoptric_reference::STACK_BYTES) where paths may
/// go deep and the rung grows the native stack. The settings are the engine's; no other rung has
/// any. Fails if a path goes too deep; the film is then void. Panics if the film's size is not the
/// grid's.
pub type RenderView = fn(&Compiled, &Grid, &mut Film, Settings) -> Result<Counts, Error>;

/// Shows the life of one eye ray, given by an index of [`Grid::columns`] and one of [`Grid::rows`];
/// gives the ray's colour. Settings and errors as for [`RenderView`]; panics if an index is out of
/// range.
pub type WatchRay =
    fn(&Compiled, &Grid, (usize, usize), Settings, &mut dyn Watch) -> Result<Vec3, Error>;

/// One way to trace the same rays.
#[derive(Clone, Copy, Debug)]
pub struct Rung {
    /// Short name: `"r0"` to `"r5"`, `"forward"`.
    pub name: &'static str,
    /// Title of a few words.
    pub title: &'static str,
    /// Path of the rung's file, from the workspace's root.
    pub file: &'static str,
    /// Text of the file.
    pub source: &'static str,
    /// Whether the rung promises the recursion's bits.
    pub bit_identical: bool,
    /// Whether native stack use grows with depth.
    pub grows_native_stack: bool,
    /// Bytes kept outside the native stack, for each ray and mirror on its way.
    pub level_bytes: usize,
    /// Renders a picture.
    pub render: RenderView,
    /// Shows one eye ray's life.
    pub watch: WatchRay,
}

impl Rung {
    /// Lines of the file that are neither blank nor comments.
    #[must_use]
    pub fn lines_of_code(&self) -> usize {
        let lines = self.source.lines().map(str::trim);
        lines.filter(|line| !line.is_empty() && !line.starts_with("//")).count()
    }

    /// A rung that promises the recursion's bits and keeps nothing.
    const fn new(
        name: &'static str,
        title: &'static str,
        (file, source): (&'static str, &'static str),
        render: RenderView,
        watch: WatchRay,
    ) -> Self {
        let (bit_identical, grows_native_stack, level_bytes) = (true, false, 0);
        Self {
            name,
            title,
            file,
            source,
            bit_identical,
            grows_native_stack,
            level_bytes,
            render,
            watch,
        }
    }

    const fn growing_the_native_stack(self) -> Self {
        Self { grows_native_stack: true, ..self }
    }

    const fn keeping(self, level_bytes: usize) -> Self {
        Self { level_bytes, ..self }
    }
}

/// A file's name and text.
macro_rules! file {
    ($path:literal) => {
        ($path, include_str!(concat!("../../../", $path)))
    };
}

/// The rungs, from the recursion up to the engine.
pub const RUNGS: [Rung; 6] = [
    Rung::new(
        "r0",
        "recursion",
        file!("crates/ladder/src/r0_recursion.rs"),
        |scene, grid, film, _| {
            catoptric_reference::render(scene, grid, film, &|_| ())
                .map_err(|_| Error::TooDeep { deepest: DEPTH_ALLOWED })
        },
        |scene, grid, at, _, watch| {
            watch_by(scene, position(grid, at), watch, DEPTH_ALLOWED, r0_recursion::trace)
        },
    )
    .growing_the_native_stack(),
    Rung::new(
        "r1",
        "continuation-passing style",
        file!("crates/ladder/src/r1_continuations.rs"),
        |scene, grid, film, _| render_by(scene, grid, film, DEPTH_ALLOWED, r1_continuations::trace),
        |scene, grid, at, _, watch| {
            watch_by(scene, position(grid, at), watch, DEPTH_ALLOWED, r1_continuations::trace)
        },
    )
    .growing_the_native_stack(),
    Rung::new(
        "r2",
        "defunctionalised continuations",
        file!("crates/ladder/src/r2_frames.rs"),
        |scene, grid, film, _| render_by(scene, grid, film, DEPTH_ALLOWED, r2_frames::trace),
        |scene, grid, at, _, watch| {
            watch_by(scene, position(grid, at), watch, DEPTH_ALLOWED, r2_frames::trace)
        },
    )
    .growing_the_native_stack()
    .keeping(size_of::<Owed>()),
    Rung::new(
        "r3",
        "a loop and a stack",
        file!("crates/ladder/src/r3_loop.rs"),
        |scene, grid, film, _| render_by(scene, grid, film, DEEPEST, r3_loop::trace),
        |scene, grid, at, _, watch| {
            watch_by(scene, position(grid, at), watch, DEEPEST, r3_loop::trace)
        },
    )
    .keeping(size_of::<PendingBounce>()),
    Rung::new(
        "r4",
        "packets of eight rays",
        file!("crates/ladder/src/r4_packets.rs"),
        |scene, grid, film, _| r4_packets::render(scene, grid, film),
        |scene, grid, at, _, watch| r4_packets::watch(scene, grid, at, watch),
    )
    .keeping(size_of::<PendingBounce>()),
    Rung::new(
        "r5",
        "the engine",
        file!("crates/core/src/trace/wavefront.rs"),
        r5_engine::render,
        r5_engine::watch,
    )
    .keeping(catoptric_core::RAY_BOUNCE_BYTES),
];

/// The aside: the sum is carried along, and a ray returns once, from the deepest level.
pub const FORWARD: Rung = Rung {
    bit_identical: false,
    ..Rung::new(
        "forward",
        "forward accumulation",
        file!("crates/ladder/src/aside_forward.rs"),
        |scene, grid, film, _| render_by(scene, grid, film, DEEPEST, aside_forward::trace),
        |scene, grid, at, _, watch| {
            watch_by(scene, position(grid, at), watch, DEEPEST, aside_forward::trace)
        },
    )
};

/// Position on the image plane of an eye ray.
fn position(grid: &Grid, (column, row): (usize, usize)) -> (f32, f32) {
    (grid.columns[column], grid.rows[row])
}
