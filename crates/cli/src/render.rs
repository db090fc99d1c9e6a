//! `catoptric render`: scene to picture.

mod engine;
mod options;
mod progress;
mod scene;
mod stats;

use std::fmt::Display;
use std::path::{Path, PathBuf};
use std::time::Instant;

use catoptric_scene::{Numerics, Quantiser, Scene, View};

use crate::exit::{Exit, Failure, say};
use crate::format::Format;
use crate::input::is_stream;
use crate::interrupt;
use crate::json;
use crate::machine;
use crate::memory::Need;
use crate::output::{Target, commit};
pub(crate) use engine::Engine;
use engine::{Precision, Rendered, Tracing};
pub(crate) use options::Options;
use scene::Loaded;
use stats::{Rays, Stats, Times, ms};

/// Renders a scene and writes it.
///
/// The order is that of the exit codes: wrong use is found before anything is read, a bad
/// scene before anything is written, and what cannot be written before minutes of tracing.
pub(crate) fn run(options: &Options) -> Result<Exit, Failure> {
    let start = Instant::now();
    interrupt::catch();
    let isa = machine::instruction_set()?;
    let (path, format) = picture(options)?;
    check_combinations(options, &path)?;

    let Loaded { scene, bytes } = scene::load(options)?;
    let load = start.elapsed();
    let view = View::new(&scene, options.crop, options.samples).map_err(Failure::wrong_use)?;
    let (width, height) = (view.crop().width, view.crop().height);
    let threads =
        options.threads.map_or_else(machine::available_threads, |threads| threads as usize);
    // The packet engine goes straight to levels where no more is asked for.
    let film = options.engine == Engine::Recursive || !format.is_8_bit();
    let samples = options.samples;
    let need = Need { width, height, samples, format, film, scene: bytes };
    let (stack_limit, more_stack) = need.within(options.memory_limit)?;
    let (picture, report) = targets(options, &path)?;

    // Trace, with progress told on the way.
    let quantiser = Quantiser::new(scene.image.transfer);
    let tracing = Tracing {
        engine: options.engine,
        precision: options.precision,
        isa,
        threads,
        stack_limit,
        more_stack,
        levels: (!film).then_some(&quantiser),
    };
    let pool = tracing.pool()?;
    let bar = progress::bar(u64::from(width) * u64::from(height), options.progress, options.quiet);
    let rendered = pool.install(|| tracing.render(&scene, &view, &|pixels| bar.inc(pixels)));
    bar.finish_and_clear();
    let Rendered { picture: pixels, counts, plan, compile, trace } = rendered?;

    // Encode. A file is written beside its name, so nothing replaces an older one yet.
    let encoding = Instant::now();
    let staged = pool.install(|| picture.stage(|to| format.write(pixels, &quantiser, to)))?;
    let (encode, total) = (encoding.elapsed(), start.elapsed());

    // Account for the run: settings, times and counts of rays.
    let stats = Stats {
        schema: "catoptric-stats",
        version: 1,
        scene: &options.scene.to_string_lossy(),
        engine: options.engine.name(),
        numerics: numerics(options, &scene),
        precision: options.precision.name(),
        width,
        height,
        max_depth: scene.render.max_depth,
        threads,
        isa: (options.engine == Engine::Packet).then(|| isa.name()),
        time_ms: Times {
            load: ms(load),
            compile: ms(compile),
            trace: ms(trace),
            encode: ms(encode),
            total: ms(total),
        },
        rays: Rays::of(&counts),
        depths: stats::depths(&counts),
        plan,
    };
    // Put picture and statistics in place together.
    let reported = report.map(|report| report.stage(|to| json::write(to, &stats)));
    commit([staged].into_iter().chain(reported.transpose()?))?;
    if !options.quiet {
        summarise(&picture, &stats);
    }
    Ok(Exit::Done)
}

/// The path and the format of the picture.
fn picture(options: &Options) -> Result<(PathBuf, Format), Failure> {
    match (&options.output, options.format) {
        (Some(path), Some(format)) => Ok((path.clone(), format)),
        (Some(path), None) => {
            if is_stream(path) {
                return Err(Failure::wrong_use("-o - needs --format png, ppm or pfm"));
            }
            let format = Format::of_path(path).ok_or_else(|| {
                Failure::wrong_use(format_args!(
                    "-o {} does not say which format: allowed endings are .png, .ppm and .pfm, or name one with --format",
                    path.display()
                ))
            })?;
            Ok((path.clone(), format))
        }
        (None, format) => {
            let format = format.unwrap_or(Format::Png);
            let stem = match options.scene.file_stem() {
                Some(stem) if !is_stream(&options.scene) => stem,
                _ => "scene".as_ref(),
            };
            let mut name = stem.to_owned();
            name.push(".");
            name.push(format.name());
            Ok((PathBuf::from(name), format))
        }
    }
}

/// Options that are right alone and wrong together.
fn check_combinations(options: &Options, picture: &Path) -> Result<(), Failure> {
    if options.precision != Precision::F32 && options.engine != Engine::Recursive {
        let precision = options.precision.name();
        return Err(Failure::wrong_use(format_args!(
            "--precision {precision} needs --engine recursive: the packet engine computes in f32"
        )));
    }
    if options.stats.as_deref() == Some(picture) {
        return Err(one_place(picture.display()));
    }
    Ok(())
}

/// The places of the picture and of the statistics, checked as far as that can be done
/// without writing to them.
fn targets(options: &Options, picture: &Path) -> Result<(Target, Option<Target>), Failure> {
    let picture = Target::new(picture)?;
    let report = options.stats.as_deref().map(Target::new).transpose()?;
    for target in [Some(&picture), report.as_ref()].into_iter().flatten() {
        if target.replaces(&options.scene) {
            return Err(Failure::wrong_use(format_args!(
                "{} is the scene itself: name another file",
                target.name()
            )));
        }
    }
    if let Some(report) = &report {
        if report.is(&picture) {
            return Err(one_place(picture.name()));
        }
        report.probe()?;
    }
    picture.probe()?;
    Ok((picture, report))
}

fn one_place(name: impl Display) -> Failure {
    Failure::wrong_use(format_args!(
        "the picture and --stats cannot both go to {name}: name another file for one of them"
    ))
}

/// The formulas that were used.
fn numerics(options: &Options, scene: &Scene) -> &'static str {
    match (options.precision, scene.render.numerics) {
        (Precision::F32, Numerics::Textbook) => "textbook",
        _ => "robust",
    }
}

/// One line for people.
fn summarise(picture: &Target, stats: &Stats<'_>) {
    let Stats { width, height, engine, precision, threads, .. } = stats;
    let isa = stats.isa.map(|isa| format!(", {isa}")).unwrap_or_default();
    say(format_args!(
        "{}: {width}x{height}, {} rays, {} reflections deep, traced in {} ms, {} ms in all ({engine}, {precision}{isa}, {threads} threads)",
        picture.closing_name(),
        stats.rays.total(),
        stats.depths.len().saturating_sub(1),
        stats.time_ms.trace,
        stats.time_ms.total,
    ));
}
