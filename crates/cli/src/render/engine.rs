//! The two engines and truth, behind one call.

use std::time::{Duration, Instant};

use catoptric_core::{Engine as PacketEngine, Isa, Levels as LevelsTarget, Plan, Settings};
use catoptric_reference::truth::{self, Truth};
use catoptric_scene::{Compiled, Counts, Crop, Film, Grid, Quantiser, Scene, View};
use rayon::{ThreadPool, ThreadPoolBuilder};

use super::stats::Planned;
use crate::exit::Failure;
use crate::format::{Levels, Picture};
use crate::machine;

/// What traces the rays.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Engine {
    /// Eight rays at a time, without recursion.
    Packet,
    /// One ray at a time, as it is written in a textbook.
    Recursive,
}

impl Engine {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Packet => "packet",
            Self::Recursive => "recursive",
        }
    }
}

/// The arithmetic of a rendering. Above f32 it is truth, whatever the scene's numerics.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Precision {
    F32,
    F64,
    DoubleDouble,
}

impl Precision {
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::F32 => "f32",
            Self::F64 => "f64",
            Self::DoubleDouble => "dd",
        }
    }
}

/// How to render: all that is not the scene's.
#[derive(Clone, Copy, Debug)]
pub(super) struct Tracing<'a> {
    pub(super) engine: Engine,
    pub(super) precision: Precision,
    pub(super) isa: Isa,
    pub(super) threads: usize,
    /// Bytes for the packet engine's stacks.
    pub(super) stack_limit: u64,
    /// How to have more of them.
    pub(super) more_stack: &'static str,
    /// If the packet engine is to give no more than levels: how it makes them.
    pub(super) levels: Option<&'a Quantiser>,
}

/// A picture and what it took.
pub(super) struct Rendered {
    pub(super) picture: Picture,
    pub(super) counts: Counts,
    /// The packet engine's plan.
    pub(super) plan: Option<Planned>,
    pub(super) compile: Duration,
    pub(super) trace: Duration,
}

impl Tracing<'_> {
    /// The threads that trace. A recursion's have stacks for its deepest path; those take
    /// memory only where they are used.
    ///
    /// # Errors
    /// Exit code 1 if the system does not grant the threads.
    pub(super) fn pool(&self) -> Result<ThreadPool, Failure> {
        let builder = ThreadPoolBuilder::new().num_threads(self.threads);
        let builder = match self.engine {
            // This thread traces too instead of waiting.
            Engine::Packet => builder.use_current_thread(),
            Engine::Recursive => builder,
        };
        let stack = self.stack_bytes();
        builder.stack_size(stack).build().map_err(|error| {
            let instead = match (self.engine, self.precision) {
                (Engine::Recursive, Precision::F32) => {
                    Some("use --engine packet --threads 1, which needs none")
                }
                _ => None,
            };
            let fewer = |threads| format!("lower --threads to {threads}");
            machine::Wanted { threads: self.threads, stack, fewer, instead }.refused(&error)
        })
    }

    /// Bytes of each thread's stack.
    fn stack_bytes(&self) -> usize {
        match (self.engine, self.precision) {
            (Engine::Packet, _) => machine::STACK,
            (Engine::Recursive, Precision::F32) => catoptric_reference::STACK_BYTES,
            (Engine::Recursive, _) => truth::STACK_BYTES,
        }
    }

    /// Renders on rayon's current threads. `done` is told how many pixels were added.
    ///
    /// # Errors
    /// Exit code 1 where a path is too deep for the engine.
    pub(super) fn render(
        &self,
        scene: &Scene,
        view: &View,
        done: &(dyn Fn(u64) + Sync),
    ) -> Result<Rendered, Failure> {
        let start = Instant::now();
        let precision = match self.precision {
            Precision::F32 => return self.render_f32(scene, view, done, start),
            Precision::F64 => truth::Precision::F64,
            Precision::DoubleDouble => truth::Precision::DoubleDouble,
        };
        let truth = Truth::new(scene, precision);
        let compile = start.elapsed();
        let (film, counts) = self.bands(&truth, scene, view, done)?;
        let picture = Picture::Linear(film);
        Ok(Rendered { picture, counts, plan: None, compile, trace: start.elapsed() - compile })
    }

    fn render_f32(
        &self,
        scene: &Scene,
        view: &View,
        done: &(dyn Fn(u64) + Sync),
        start: Instant,
    ) -> Result<Rendered, Failure> {
        let compiled = Compiled::new(scene);
        let grid = Grid::new(view);
        let compile = start.elapsed();
        let mut plan = None;
        let (width, height) = (view.crop().width, view.crop().height);
        let (picture, counts) = match self.engine {
            // The packet engine traces by a plan, straight to levels or to a film.
            Engine::Packet => {
                let stack_limit = usize::try_from(self.stack_limit).unwrap_or(usize::MAX);
                let settings = Settings { isa: self.isa, stack_limit };
                let whole = Plan::new(&compiled, &grid);
                plan = Some(Planned::of(&whole, self.levels.is_none()));
                let engine = PacketEngine::new(&compiled).with(settings).reporting(done);
                let traced = match self.levels {
                    Some(quantiser) => {
                        let mut levels = Levels::new(width, height);
                        let pixels = &mut levels.pixels;
                        engine
                            .render_planned(&whole, LevelsTarget { quantiser, pixels })
                            .map(|counts| (Picture::Levels(levels), counts))
                    }
                    None => {
                        let mut film = Film::new(width, height);
                        engine
                            .render_planned(&whole, &mut film)
                            .map(|counts| (Picture::Linear(film), counts))
                    }
                };
                // A full stack is the only way to fail: say how to need less of it.
                traced.map_err(|full| {
                    let more = self.more_stack;
                    Failure::failed(format_args!(
                        "{full}: {more}, lower --max-depth or raise --min-weight"
                    ))
                })?
            }
            // The recursion always fills a film.
            Engine::Recursive => {
                let mut film = Film::new(width, height);
                let traced = catoptric_reference::render(&compiled, &grid, &mut film, done);
                let counts = traced.map_err(|deep| {
                    Failure::failed(format_args!(
                        "{deep}: lower --max-depth, raise --min-weight, or use --engine packet"
                    ))
                })?;
                (Picture::Linear(film), counts)
            }
        };
        Ok(Rendered { picture, counts, plan, compile, trace: start.elapsed() - compile })
    }

    /// Truth, some rows at a time: its f64 picture is never there as a whole, and progress
    /// can be told.
    fn bands(
        &self,
        truth: &Truth,
        scene: &Scene,
        view: &View,
        done: &(dyn Fn(u64) + Sync),
    ) -> Result<(Film, Counts), Failure> {
        /// Rows for each thread, so that one slow row does not hold up the others for long.
        const ROWS: u32 = 16;
        let whole = view.crop();
        let mut film = Film::new(whole.width, whole.height);
        let mut counts = Counts::default();
        let rows = ROWS * u32::try_from(self.threads).expect("at most 1024 threads");
        let pixels = rows as usize * whole.width as usize;
        for (band, to) in (0..).zip(film.pixels_mut().chunks_mut(pixels)) {
            let height = (to.len() / whole.width as usize) as u32;
            let crop = Crop { y: whole.y + band * rows, height, ..whole };
            let view = View::new(scene, Some(crop), view.samples())
                .expect("a part of a view is inside the image");
            let part = truth.render(&view).map_err(Failure::failed)?;
            to.copy_from_slice(part.to_film().pixels());
            counts.add(&part.counts);
            done(to.len() as u64);
        }
        Ok((film, counts))
    }
}
