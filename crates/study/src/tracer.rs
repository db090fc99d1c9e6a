//! Who traces a picture, and on how many threads.

use std::collections::BTreeMap;
use std::time::{Duration, Instant};

use catoptric_core::{Engine, Isa, PacketScalar, Settings};
use catoptric_scene::{Compiled, Counts, Film, Grid};
use rayon::{ThreadPool, ThreadPoolBuilder};

/// One of the two renderers.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub enum Tracer {
    /// The recursion of `catoptric-reference`.
    Recursive,
    /// The packet engine on an instruction set.
    Packet(Isa),
}

impl Tracer {
    /// `recursive` or `packet`: its name on the command line.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Recursive => "recursive",
            Self::Packet(_) => "packet",
        }
    }

    /// Renders on rayon's current threads.
    ///
    /// # Errors
    /// A path too deep for the recursion's stack, or for the engine's.
    pub fn render<S: Renders>(
        self,
        scene: &Compiled<S>,
        grid: &Grid<S>,
        film: &mut Film<S>,
    ) -> Result<Counts, TooDeep> {
        let rendered = match self {
            Self::Recursive => S::recursion(scene, grid, film),
            Self::Packet(isa) => {
                let settings = Settings { isa, stack_limit: STACK_LIMIT };
                Engine::new(scene).with(settings).render(grid, film).ok()
            }
        };
        rendered.ok_or(TooDeep)
    }
}

/// A scalar that both renderers compute in.
pub trait Renders: PacketScalar {
    /// The recursion in it; `None` where a path is too deep.
    fn recursion(
        scene: &Compiled<Self>,
        grid: &Grid<Self>,
        film: &mut Film<Self>,
    ) -> Option<Counts>;
}

impl Renders for f32 {
    fn recursion(scene: &Compiled, grid: &Grid, film: &mut Film) -> Option<Counts> {
        catoptric_reference::render(scene, grid, film, &|_| {}).ok()
    }
}

impl Renders for f64 {
    fn recursion(
        scene: &Compiled<Self>,
        grid: &Grid<Self>,
        film: &mut Film<Self>,
    ) -> Option<Counts> {
        catoptric_reference::double::render(scene, grid, film, &|_| {}).ok()
    }
}

/// A path went deeper than the renderer's stack.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("a path is deeper than the stack")]
pub struct TooDeep;

/// Bytes for the engine's stacks: what `render` allows unless it is told otherwise.
pub const STACK_LIMIT: usize = 2 << 30;

/// Pools of threads with stacks for the recursion's deepest path, by their number.
pub struct Threads {
    pools: BTreeMap<usize, ThreadPool>,
}

impl Threads {
    /// A pool for each of these numbers of threads.
    ///
    /// # Errors
    /// The system does not grant them.
    pub fn new(
        counts: impl IntoIterator<Item = usize>,
    ) -> Result<Self, rayon::ThreadPoolBuildError> {
        let pool = |count| {
            let builder = ThreadPoolBuilder::new().num_threads(count);
            let pool = builder.stack_size(catoptric_reference::STACK_BYTES).build()?;
            Ok((count, pool))
        };
        Ok(Self { pools: counts.into_iter().map(pool).collect::<Result<_, _>>()? })
    }

    /// The numbers, ascending.
    pub fn counts(&self) -> impl Iterator<Item = usize> {
        self.pools.keys().copied()
    }

    /// The most threads.
    ///
    /// # Panics
    /// If there is no pool.
    #[must_use]
    pub fn most(&self) -> &ThreadPool {
        self.pools.values().next_back().expect("at least one pool")
    }

    /// Runs on that many threads, and says how long it took.
    ///
    /// # Panics
    /// If there is no pool of that number.
    pub fn time<R: Send>(&self, threads: usize, run: impl FnOnce() -> R + Send) -> (R, Duration) {
        self.pools[&threads].install(|| {
            let start = Instant::now();
            let result = run();
            (result, start.elapsed())
        })
    }
}
