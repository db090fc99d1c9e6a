//! `catoptric study`: what accuracy and depth cost, as tables, plots and one page.

mod destination;
mod options;
mod subjects;

use catoptric_study::occasion::Occasion;
use catoptric_study::report::Report;
use catoptric_study::subject::Subject;
use catoptric_study::timing::Repeat;
use catoptric_study::tracer::{Threads, Tracer};
use catoptric_study::{Watch, depth, error, ladder, stability};

use crate::exit::{Exit, Failure, say};
use crate::render::Engine;
use crate::{interrupt, machine};
use destination::Destination;
pub(crate) use options::Options;
use options::{DepthOptions, ErrorOptions, LadderOptions, Study};

/// Runs a study and writes what it found.
pub(crate) fn run(options: &Options) -> Result<Exit, Failure> {
    interrupt::catch_the_second();
    let isa = machine::instruction_set()?;
    let common = options.study.common();
    let destination = Destination::new(common)?;
    let subjects = subjects::load(&common.scenes)?;
    let threads = match (&options.study, common.threads) {
        (Study::Ladder(_), None) => 1,
        (Study::Ladder(_), Some(2..)) => {
            return Err(Failure::wrong_use(
                "study ladder times on one thread: leave --threads out",
            ));
        }
        (_, threads) => threads.map_or_else(machine::available_threads, |n| n as usize),
    };
    let command = std::env::args().collect::<Vec<_>>().join(" ");
    let made = Occasion::now(isa, threads, command);
    let pools = pools([1, threads])?;

    let watch = Signals { quiet: common.quiet };
    let report = match &options.study {
        Study::Depth(options) => study_depth(options, &subjects, &pools, isa, &watch)?,
        Study::Error(options) => study_error(options, &subjects, threads, isa, &watch)?,
        Study::Ladder(options) => study_ladder(options, &subjects, &pools, isa, &watch)?,
        Study::Stability(_) => {
            let effort = stability::suite::Effort::default();
            pools.most().install(|| stability::run(&subjects, &watch, effort))
        }
    };
    destination.write(&report, &made)?;
    Ok(match (report.complete, report.failed) {
        (false, _) => Exit::Interrupted,
        (true, true) => Exit::Failed,
        (true, false) => Exit::Done,
    })
}

fn pools<const N: usize>(threads: [usize; N]) -> Result<Threads, Failure> {
    Threads::new(threads).map_err(|error| {
        Failure::failed(format_args!("{threads:?} threads cannot be had: {error}; lower --threads"))
    })
}

fn study_depth(
    options: &DepthOptions,
    subjects: &[Subject],
    threads: &Threads,
    isa: catoptric_core::Isa,
    watch: &dyn Watch,
) -> Result<Report, Failure> {
    some("depth", subjects)?;
    let tracers: Vec<Tracer> = options
        .engines
        .iter()
        .map(|engine| match engine {
            Engine::Recursive => Tracer::Recursive,
            Engine::Packet => Tracer::Packet(isa),
        })
        .collect();
    let repeat = options.repeat.map_or(Repeat::Enough, Repeat::Times);
    let depths = &options.depths;
    let request = depth::Request { subjects, depths, tracers: &tracers, threads, repeat, isa };
    depth::run(&request, watch).map_err(Failure::failed)
}

fn study_error(
    options: &ErrorOptions,
    subjects: &[Subject],
    timed_on: usize,
    isa: catoptric_core::Isa,
    watch: &dyn Watch,
) -> Result<Report, Failure> {
    some("error", subjects)?;
    let repeat = options.repeat.map_or(Repeat::Enough, Repeat::Times);
    let (tracer, target) = (Tracer::Packet(isa), options.target_error);
    // Truth takes minutes, and nobody times it.
    let threads = &pools([timed_on, machine::available_threads()])?;
    let request = error::Request { subjects, tracer, threads, timed_on, repeat, target };
    Ok(error::run(&request, watch))
}

fn study_ladder(
    options: &LadderOptions,
    subjects: &[Subject],
    threads: &Threads,
    isa: catoptric_core::Isa,
    watch: &dyn Watch,
) -> Result<Report, Failure> {
    some("ladder", subjects)?;
    let repeat = options.repeat.map_or(Repeat::Enough, Repeat::Times);
    Ok(ladder::run(&ladder::Request { subjects, threads, repeat, isa }, watch))
}

fn some(study: &str, subjects: &[Subject]) -> Result<(), Failure> {
    if subjects.is_empty() {
        return Err(Failure::wrong_use(format_args!(
            "study {study} needs a scene: name one or more"
        )));
    }
    Ok(())
}

/// What a study is told of signals, and what it says meanwhile.
struct Signals {
    quiet: bool,
}

impl Watch for Signals {
    fn stopped(&self) -> bool {
        interrupt::asked()
    }

    fn say(&self, line: &str) {
        if !self.quiet {
            say(format_args!("{line}"));
        }
    }
}
