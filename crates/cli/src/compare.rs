//! `catoptric compare`: what differs between two pictures.

mod difference;
mod options;
mod report;
mod verdict;

use std::path::Path;

use crate::exit::{Exit, Failure};
use crate::format::{Opened, Picture, png};
use crate::input::is_stream;
use crate::interrupt;
use crate::json;
use crate::memory::granted;
use crate::output::{Target, commit};
use crate::size::Size;
use difference::Difference;
pub(crate) use options::Options;
use report::Report;

/// Compares two pictures and reports on stdout.
pub(crate) fn run(options: &Options) -> Result<Exit, Failure> {
    interrupt::catch();
    if is_stream(&options.a) && is_stream(&options.b) {
        return Err(Failure::wrong_use(
            "A and B cannot both be stdin: name a file for one of them",
        ));
    }
    if options.diff.as_deref().is_some_and(is_stream) {
        return Err(Failure::wrong_use(
            "--diff - is not possible, stdout takes the report: name a file",
        ));
    }
    let stdout = Target::stdout()?;
    let (a, b) = (Opened::open(&options.a)?, Opened::open(&options.b)?);
    check_pair(&a, &b)?;
    check_memory(options, &a, &b)?;
    let (a, b) = (a.read()?, b.read()?);
    let difference = Difference::between(&a, &b);
    let verdict = options.verdict.verdict(&difference);

    let image = options.diff.as_deref().map(|path| stage_image(options, path, &a, &b, &difference));
    let image = image.transpose()?;
    let report = Report::new(options, &difference, &verdict);
    stdout
        .stage(|to| if options.json { json::write(to, &report) } else { write!(to, "{report}") })?;
    commit(image)?;
    Ok(if verdict.passed { Exit::Done } else { Exit::Failed })
}

/// Whether their headers say that they can be compared.
fn check_pair(a: &Opened, b: &Opened) -> Result<(), Failure> {
    let ((width, height), (bw, bh)) = (a.size(), b.size());
    let why = if (width, height) != (bw, bh) {
        format!("one has {width}x{height} pixels, the other {bw}x{bh}")
    } else if a.kind() != b.kind() {
        let (a, b) = (a.kind(), b.kind());
        format!("one holds {a}, the other {b}; render both as pfm, or neither")
    } else {
        return Ok(());
    };
    let (a, b) = (a.name(), b.name());
    Err(Failure::wrong_use(format_args!("{a} and {b} cannot be compared: {why}")))
}

/// Counts what both pictures and the difference image take, before any of it is taken.
fn check_memory(options: &Options, a: &Opened, b: &Opened) -> Result<(), Failure> {
    let (width, height) = a.size();
    let image = match options.diff {
        // Its levels, and the compressed file, which may be a little larger.
        Some(_) => (u64::from(width) * u64::from(height)).saturating_mul(3 + 4),
        None => 0,
    };
    let need = a.bytes().saturating_add(b.bytes()).saturating_add(image);
    let limit = options.memory_limit;
    let why = if need > limit.0 {
        format!(
            "the limit is {limit}: raise --memory-limit, or compare parts, rendered with --crop"
        )
    } else if !granted(need) {
        "which the system does not grant: compare parts, rendered with --crop".to_owned()
    } else {
        return Ok(());
    };
    let (a, b, size) = (a.name(), b.name(), Size(need));
    Err(Failure::bad_input(format_args!(
        "{a} and {b}, of {width}x{height} pixels, need {size} of memory ({need} bytes), {why}"
    )))
}

/// Writes the difference image, which must not replace what is compared.
fn stage_image(
    options: &Options,
    path: &Path,
    a: &Picture,
    b: &Picture,
    difference: &Difference,
) -> Result<crate::output::Staged, Failure> {
    let target = Target::new(path)?;
    if let Some(file) = [&options.a, &options.b].into_iter().find(|file| target.replaces(file)) {
        let file = file.display();
        return Err(Failure::wrong_use(format_args!(
            "--diff would replace {file}, which is compared: name another file"
        )));
    }
    let levels = difference.image(a, b);
    target.stage(|to| png::encode(&levels, difference.width, difference.height, None, to))
}
