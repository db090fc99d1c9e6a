//! `catoptric compare`: what differs between two pictures.

mod difference;
mod report;

use std::path::{Path, PathBuf};

use clap::Args;

use crate::exit::{Exit, Failure};
use crate::format::{Picture, png};
use crate::input::{self, is_stream};
use crate::interrupt;
use crate::json;
use crate::output::{Target, commit};
use difference::Difference;
use report::Report;

/// Compare two pictures, value by value
///
/// Reads PNG and PPM (8 bits a channel) and PFM (f32), told apart by their first bytes. Two
/// PFM are compared as bits, where any NaN equals any NaN; 8-bit pictures are compared as
/// levels. A PFM and an 8-bit picture cannot be compared. The report goes to stdout.
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
}

const EXAMPLES: &str = "\
Exit codes:
  0 equal, 1 different, 2 not to be compared (sizes, formats), 3 missing or bad, 4 not written

Examples:
  catoptric compare packet.pfm recursive.pfm
  catoptric compare before.png after.ppm --diff difference.png
  catoptric render scene.toml -o - --format pfm | catoptric compare - exact.pfm --json";

/// The longest picture file that is read: 65535 x 65535 pixels of PFM, and a header.
const FILE_BYTES: u64 = 65_535 * 65_535 * 12 + 4096;

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
    let (a, b) = (read(&options.a)?, read(&options.b)?);
    let difference = Difference::between(&a, &b).map_err(|why| {
        let (a, b) = (input::name(&options.a), input::name(&options.b));
        Failure::wrong_use(format_args!("{a} and {b} cannot be compared: {why}"))
    })?;

    let image = options.diff.as_deref().map(|path| stage_image(options, path, &a, &b, &difference));
    let image = image.transpose()?;
    let report = Report::new(options, &difference);
    stdout
        .stage(|to| if options.json { json::write(to, &report) } else { write!(to, "{report}") })?;
    commit(image)?;
    Ok(if difference.pixels == 0 { Exit::Done } else { Exit::Failed })
}

fn read(path: &Path) -> Result<Picture, Failure> {
    Picture::parse(&input::name(path), &input::read(path, FILE_BYTES, "no picture is longer")?)
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
    target.stage(|to| png::encode(&levels, difference.width, difference.height, to))
}
