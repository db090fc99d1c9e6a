//! One way to render, and how long it takes.

use std::fmt;
use std::hint::black_box;
use std::time::{Duration, Instant};

use catoptric_core::{Engine, Isa, Settings};
use catoptric_scene::Film;
use catoptric_tests::identity::pool;

use crate::subject::Subject;

/// Who traces.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Tracer {
    /// `catoptric-reference`.
    Recursion,
    /// `catoptric-core` with that instruction set.
    Engine(Isa),
}

/// A tracer on 1 or 2 threads.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Runner {
    /// Who traces.
    pub tracer: Tracer,
    /// 1 or 2.
    pub threads: usize,
}

/// More than any bench needs.
const STACK_LIMIT: usize = 1 << 30;

impl Runner {
    /// The recursion on so many threads.
    #[must_use]
    pub fn recursion(threads: usize) -> Self {
        Self { tracer: Tracer::Recursion, threads }
    }

    /// The engine on so many threads.
    #[must_use]
    pub fn engine(isa: Isa, threads: usize) -> Self {
        Self { tracer: Tracer::Engine(isa), threads }
    }

    /// How long it takes to render the subject `times` times in a row onto the film.
    ///
    /// The clock is read on a thread of the pool, so waking the first one is not timed;
    /// waking the second one is, in every rendering. Nothing is compiled or encoded. What the
    /// film held before does not matter; it holds the picture afterwards.
    ///
    /// # Panics
    /// If the film is of another size, or a path is too deep for the tracer.
    #[must_use]
    pub fn time(self, subject: &Subject, film: &mut Film, times: u64) -> Duration {
        pool(self.threads).install(|| {
            let start = Instant::now();
            for _ in 0..times {
                self.render(subject, black_box(&mut *film));
            }
            start.elapsed()
        })
    }

    /// Renders once on the current pool.
    fn render(self, subject: &Subject, film: &mut Film) {
        let (scene, grid) = (black_box(&subject.compiled), &subject.grid);
        let counts = match self.tracer {
            Tracer::Recursion => catoptric_reference::render(scene, grid, film, &|_| ())
                .expect("the recursion's stack holds the path"),
            Tracer::Engine(isa) => {
                let settings = Settings { isa, stack_limit: STACK_LIMIT };
                Engine::new(scene)
                    .with(settings)
                    .render(grid, film)
                    .expect("the engine's stack holds the path")
            }
        };
        black_box(counts);
    }
}

/// `recursion-1t`, `engine-avx2-2t`: names that a filter can hold.
impl fmt::Display for Runner {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self.tracer {
            Tracer::Recursion => write!(f, "recursion-{}t", self.threads),
            Tracer::Engine(isa) => write!(f, "engine-{isa}-{}t", self.threads),
        }
    }
}
