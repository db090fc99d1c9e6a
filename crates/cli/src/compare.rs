//! `catoptric compare`: what differs between two pictures.

mod difference;
mod report;
mod verdict;

use std::path::{Path, PathBuf};

use clap::Args;

use crate::exit::{Exit, Failure};
use crate::format::{Opened, Picture, png};
use crate::input::is_stream;
use crate::interrupt;
use crate::json;
use crate::memory::{Size, granted};
use crate::output::{Target, commit};
use difference::Difference;
use report::Report;

/// Compare two pictures, value by value
///
/// Reads PNG, PPM (P6 and P3) and PGM (P5 and P2) with 8 bits a channel, and PFM (f32), told
/// apart by their first bytes. Two PFM are compared as bits, where any NaN equals any NaN; 8-bit
/// pictures are compared as levels, whatever the files say of their gamma or colours; grey is
/// RGB of equal channels. A PNG may have an alpha that is 255 everywhere. A PFM and an 8-bit
/// picture cannot be compared. The report goes to stdout.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Options {
    /// One picture; `-` reads stdin
    #[arg(value_name = "A")]
    a: PathBuf,

    /// The other picture, of the same size; `-` reads stdin
    #[arg(value_name = "B")]
    b: PathBuf,

    /// Report as one JSON document
    #[arg(long)]
    json: bool,

    /// Write a PNG of the absolute differences, amplified so that the largest is white
    #[arg(long, value_name = "OUT.png")]
    diff: Option<PathBuf>,

    #[command(flatten)]
    verdict: verdict::Options,

    /// Memory for both pictures and the difference image
    ///
    /// Plain bytes, or with K, M, G (powers of 1000) or KiB, MiB, GiB (powers of 1024).
    /// Pictures whose headers say that they need more are refused before anything is taken.
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true, default_value = "2GiB")]
    memory_limit: Size,
}

const EXAMPLES: &str = "\
Exit codes:
  0 equal, or no more different than --tolerance and --allow let pass; 1 different
  2 not to be compared (sizes, formats), 3 missing, bad or too large, 4 not written

Examples:
  catoptric compare packet.pfm recursive.pfm
  catoptric compare before.png after.ppm --diff difference.png
  catoptric compare expected.png student.ppm --tolerance 1 --allow 0.1%
  catoptric render scene.toml -o - --format pfm | catoptric compare - exact.pfm --json";

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
