//! The command line of `compare`.

use std::path::PathBuf;

use clap::Args;

use super::verdict;
use crate::size::Size;

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
    pub(super) a: PathBuf,

    /// The other picture, of the same size; `-` reads stdin
    #[arg(value_name = "B")]
    pub(super) b: PathBuf,

    /// Report as one JSON document
    #[arg(long)]
    pub(super) json: bool,

    /// Write a PNG of the absolute differences, amplified so that the largest is white
    #[arg(long, value_name = "OUT.png")]
    pub(super) diff: Option<PathBuf>,

    #[command(flatten)]
    pub(super) verdict: verdict::Options,

    /// Memory for both pictures and the difference image
    ///
    /// Plain bytes, or with K, M, G (powers of 1000) or KiB, MiB, GiB (powers of 1024).
    /// Pictures whose headers say that they need more are refused before anything is taken.
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true, default_value = "2GiB")]
    pub(super) memory_limit: Size,
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
