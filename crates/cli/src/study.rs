//! `catoptric study`: what accuracy and depth cost, as tables, plots and one page.

mod destination;
mod options;
mod subjects;

use std::ffi::OsString;

use catoptric_report::{Occasion, Report};
use catoptric_scene::is_visible;
use catoptric_study::subject::Subject;
use catoptric_study::tracer::{Threads, Tracer};
use catoptric_study::way::Way;
use catoptric_study::{Watch, depth, error, ladder, stability};

use crate::exit::{Exit, Failure, say};
use crate::render::Engine;
use crate::{interrupt, machine};
use destination::Destination;
pub(crate) use options::Options;
use options::{DepthOptions, ErrorOptions, LadderOptions, Study};

/// Runs a study and writes what it found.
pub(crate) fn run(options: &Options) -> Result<Exit, Failure> {
    interrupt::catch();
    let isa = machine::instruction_set()?;
    let common = options.study.common();
    let threads = match (&options.study, common.threads) {
        (Study::Ladder(_), None) => 1,
        (Study::Ladder(_), Some(2..)) => {
            return Err(Failure::wrong_use(
                "study ladder times on one thread: leave --threads out",
            ));
        }
        (Study::Depth(_), None) => 2,
        (_, threads) => threads.map_or_else(machine::available_threads, |n| n as usize),
    };
    // Only the stability study brings scenes of its own.
    if common.scenes.is_empty() && !matches!(options.study, Study::Stability(_)) {
        let study = options.study.name();
        return Err(Failure::wrong_use(format_args!(
            "study {study} needs a scene: name one or more"
        )));
    }
    let subjects = subjects::load(&common.scenes)?;
    // Find out that a report can be written before anything is measured.
    let destination = Destination::new(common, options.study.name())?;
    let command = command_line(std::env::args_os());
    let made = Occasion::now(isa.name(), threads, command);
    let pools = pools([1, threads])?;

    // Measure until done or interrupted; what is there by then is written.
    let watch = Signals { quiet: common.quiet };
    let report = interrupt::measuring(|| match &options.study {
        Study::Depth(options) => study_depth(options, &subjects, &pools, isa, &watch),
        Study::Error(options) => study_error(options, &subjects, threads, isa, &watch),
        Study::Ladder(options) => study_ladder(options, &subjects, &pools, isa, &watch),
        Study::Stability(_) => {
            let effort = stability::finding::Effort::default();
            Ok(pools.most().install(|| stability::run(&subjects, &watch, effort)))
        }
    })?;
    destination.write(&report, &made)?;
    Ok(match (report.complete, report.failed) {
        (false, _) => Exit::Interrupted,
        (true, true) => Exit::Failed,
        (true, false) => Exit::Done,
    })
}

fn pools<const N: usize>(threads: [usize; N]) -> Result<Threads, Failure> {
    Threads::new(threads).map_err(|error| {
        // The pools are kept side by side.
        let (threads, stack) = (threads.iter().sum(), catoptric_reference::STACK_BYTES);
        let fewer = |threads| {
            let each = usize::max(threads / 2, 1);
            format!("lower --threads to {each}, on so many processors (taskset -c 0-{})", each - 1)
        };
        machine::Wanted { threads, stack, fewer, instead: None }.refused(&error)
    })
}

fn study_depth(
    options: &DepthOptions,
    subjects: &[Subject],
    threads: &Threads,
    isa: catoptric_core::Isa,
    watch: &dyn Watch,
) -> Result<Report, Failure> {
    let way = |engine: &Engine| {
        Way::Tracer(match engine {
            Engine::Recursive => Tracer::Recursive,
            Engine::Packet => Tracer::Packet(isa),
        })
    };
    let ways: Vec<Way> = without_repeats(&options.engines).iter().map(way).collect();
    let depths = &without_repeats(&options.depths);
    let repeat = options.timed.repeat();
    let request = depth::Request { subjects, depths, ways: &ways, threads, repeat, isa };
    depth::run(&request, watch).map_err(Failure::failed)
}

fn study_error(
    options: &ErrorOptions,
    subjects: &[Subject],
    timed_on: usize,
    isa: catoptric_core::Isa,
    watch: &dyn Watch,
) -> Result<Report, Failure> {
    let repeat = options.timed.repeat();
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
    let repeat = options.timed.repeat();
    Ok(ladder::run(&ladder::Request { subjects, threads, repeat, isa }, watch))
}

/// The first of equals, in the order in which they were asked for.
fn without_repeats<T: Copy + PartialEq>(asked: &[T]) -> Vec<T> {
    let mut once = Vec::new();
    for &one in asked {
        if !once.contains(&one) {
            once.push(one);
        }
    }
    once
}

/// The command line as a shell takes it. What is no text, or would not be seen, is shown with
/// U+FFFD in its place.
fn command_line(arguments: impl Iterator<Item = OsString>) -> String {
    let quoted = |argument: OsString| {
        let text = argument.to_string_lossy();
        let text: String = text
            .chars()
            .map(|c| if is_visible(c) { c } else { char::REPLACEMENT_CHARACTER })
            .collect();
        let plain = |c: char| c.is_alphanumeric() || "-_./,:=+@%\u{fffd}".contains(c);
        if !text.is_empty() && text.chars().all(plain) {
            return text;
        }
        format!("'{}'", text.replace('\'', "'\\''"))
    };
    arguments.map(quoted).collect::<Vec<_>>().join(" ")
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
