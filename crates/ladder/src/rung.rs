//! The table of rungs.

use catoptric_core::StackFull;
use catoptric_reference::DEPTH_ALLOWED;
use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;

use crate::r2_frames::Owed;
use crate::{
    PendingBounce, Watch, aside_forward, r0_recursion, r1_continuations, r2_frames, r3_loop,
    r4_packets, r5_engine, render_by, watch_by,
};

/// The deepest path of rungs with a stack of their own.
pub const DEEPEST: u32 = 1_000_000;

/// A path went deeper than a rung allows.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
pub enum Error {
    /// More reflections than a rung's stack holds.
    #[error("a path has more than {deepest} reflections, which this rung's stack does not hold")]
    TooDeep {
        /// Reflections that are allowed.
        deepest: u32,
    },
    /// The engine's stacks would pass its limit.
    #[error(transparent)]
    StackFull(#[from] StackFull),
}

/// Renders a view into a film of its size, on rayon's current threads.
///
/// Their stacks must hold [`STACK_BYTES`](catoptric_reference::STACK_BYTES) where paths may go
/// deep and the rung grows the native stack. Fails if a path goes too deep; the film is then
/// void. Panics if the film's size is not the grid's.
pub type RenderView = fn(&Compiled, &Grid, &mut Film) -> Result<Counts, Error>;

/// Lets the life of one eye ray be seen, the one at an index of [`Grid::columns`] and one of
/// [`Grid::rows`]; its colour. Fails as [`RenderView`] does; panics if an index is out of range.
pub type WatchRay = fn(&Compiled, &Grid, (usize, usize), &mut dyn Watch) -> Result<Vec3, Error>;

/// One way to trace the same rays.
#[derive(Clone, Copy, Debug)]
pub struct Rung {
    /// `"r0"` to `"r5"`, `"forward"`.
    pub name: &'static str,
    /// In a few words.
    pub title: &'static str,
    /// Its file, from the workspace's root.
    pub file: &'static str,
    /// The file's text.
    pub source: &'static str,
    /// Whether it promises the recursion's bits.
    pub bit_identical: bool,
    /// Whether native stack use grows with depth.
    pub grows_native_stack: bool,
    /// Bytes a ray and level that it keeps outside the native stack.
    pub level_bytes: usize,
    /// Renders a picture.
    pub render: RenderView,
    /// Shows one eye ray's life.
    pub watch: WatchRay,
}

impl Rung {
    /// Lines of its file that are neither blank nor comments.
    #[must_use]
    pub fn lines_of_code(&self) -> usize {
        let lines = self.source.lines().map(str::trim);
        lines.filter(|line| !line.is_empty() && !line.starts_with("//")).count()
    }
}

/// From the recursion up to the engine.
pub const RUNGS: [Rung; 6] = [
    Rung {
        name: "r0",
        title: "recursion",
        file: "crates/ladder/src/r0_recursion.rs",
        source: include_str!("r0_recursion.rs"),
        bit_identical: true,
        grows_native_stack: true,
        level_bytes: 0,
        render: |scene, grid, film| {
            catoptric_reference::render(scene, grid, film, &|_| ())
                .map_err(|_| Error::TooDeep { deepest: DEPTH_ALLOWED })
        },
        watch: |scene, grid, at, watch| {
            watch_by(scene, position(grid, at), watch, DEPTH_ALLOWED, r0_recursion::trace)
        },
    },
    Rung {
        name: "r1",
        title: "continuation-passing style",
        file: "crates/ladder/src/r1_continuations.rs",
        source: include_str!("r1_continuations.rs"),
        bit_identical: true,
        grows_native_stack: true,
        level_bytes: 0,
        render: |scene, grid, film| {
            render_by(scene, grid, film, DEPTH_ALLOWED, r1_continuations::trace)
        },
        watch: |scene, grid, at, watch| {
            watch_by(scene, position(grid, at), watch, DEPTH_ALLOWED, r1_continuations::trace)
        },
    },
    Rung {
        name: "r2",
        title: "defunctionalised continuations",
        file: "crates/ladder/src/r2_frames.rs",
        source: include_str!("r2_frames.rs"),
        bit_identical: true,
        grows_native_stack: true,
        level_bytes: size_of::<Owed>(),
        render: |scene, grid, film| render_by(scene, grid, film, DEPTH_ALLOWED, r2_frames::trace),
        watch: |scene, grid, at, watch| {
            watch_by(scene, position(grid, at), watch, DEPTH_ALLOWED, r2_frames::trace)
        },
    },
    Rung {
        name: "r3",
        title: "a loop and a stack",
        file: "crates/ladder/src/r3_loop.rs",
        source: include_str!("r3_loop.rs"),
        bit_identical: true,
        grows_native_stack: false,
        level_bytes: size_of::<PendingBounce>(),
        render: |scene, grid, film| render_by(scene, grid, film, DEEPEST, r3_loop::trace),
        watch: |scene, grid, at, watch| {
            watch_by(scene, position(grid, at), watch, DEEPEST, r3_loop::trace)
        },
    },
    Rung {
        name: "r4",
        title: "packets of eight rays",
        file: "crates/ladder/src/r4_packets.rs",
        source: include_str!("r4_packets.rs"),
        bit_identical: true,
        grows_native_stack: false,
        level_bytes: size_of::<PendingBounce>(),
        render: r4_packets::render,
        watch: r4_packets::watch,
    },
    Rung {
        name: "r5",
        title: "the engine",
        file: "crates/core/src/packet.rs",
        source: include_str!("../../core/src/packet.rs"),
        bit_identical: true,
        grows_native_stack: false,
        level_bytes: catoptric_core::RAY_LEVEL_BYTES,
        render: r5_engine::render,
        watch: r5_engine::watch,
    },
];

/// The aside: the sum carried along. Its ray returns once, from the deepest level.
pub const FORWARD: Rung = Rung {
    name: "forward",
    title: "forward accumulation",
    file: "crates/ladder/src/aside_forward.rs",
    source: include_str!("aside_forward.rs"),
    bit_identical: false,
    grows_native_stack: false,
    level_bytes: 0,
    render: |scene, grid, film| render_by(scene, grid, film, DEEPEST, aside_forward::trace),
    watch: |scene, grid, at, watch| {
        watch_by(scene, position(grid, at), watch, DEEPEST, aside_forward::trace)
    },
};

/// Where an eye ray passes through the image plane.
fn position(grid: &Grid, (column, row): (usize, usize)) -> (f32, f32) {
    (grid.columns[column], grid.rows[row])
}
