//! The command line of `study`.

use std::path::PathBuf;

use catoptric_study::depth::DEPTHS;
use catoptric_study::timing::Repeat;
use clap::{Args, Subcommand};

use crate::render::Engine;
use crate::whole::whole;

/// Measure what accuracy and depth cost, where the numerics hold, and what makes it fast
///
/// Prints what it found as text or, with --json, as one JSON document; with -o it writes a
/// page for a browser, plots, and the rows as JSON, CSV and Markdown into a folder. The first
/// interruption ends the measuring and keeps the rows that are there.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Options {
    #[command(subcommand)]
    pub(super) study: Study,
}

#[derive(Subcommand, Debug)]
pub(super) enum Study {
    Depth(DepthOptions),
    Error(ErrorOptions),
    Ladder(LadderOptions),
    Stability(StabilityOptions),
}

/// What all studies have.
#[derive(Args, Debug)]
pub(super) struct Common {
    /// Scene files; `-` reads stdin
    #[arg(value_name = "SCENE")]
    pub(super) scenes: Vec<PathBuf>,

    /// Folder for index.html, JSON, CSV, Markdown, SVG and PNG; made if it is not there
    ///
    /// Files of an earlier report of the same study are replaced. Those that are not written
    /// again are removed if they are as they were written; nothing else is.
    #[arg(short, long, value_name = "DIR")]
    pub(super) output: Option<PathBuf>,

    /// Print one JSON document on stdout
    #[arg(long)]
    pub(super) json: bool,

    /// Threads that trace, 1 to 1024; `depth` times on one thread too [default: as many as the
    /// system can run at once; `depth`: 2; `ladder`: 1]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 1024>)]
    pub(super) threads: Option<u32>,

    /// Nothing on stderr but errors
    #[arg(short, long)]
    pub(super) quiet: bool,
}

/// How often a study that times does so.
#[derive(Args, Clone, Copy, Debug)]
pub(super) struct Timed {
    /// Time each that many times [default: 20 times, once where a run takes over 2 s, and no
    /// more than ten minutes a scene]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 1_000_000>)]
    repeat: Option<u32>,
}

impl Timed {
    pub(super) fn repeat(self) -> Repeat {
        self.repeat.map_or(Repeat::Enough, Repeat::Times)
    }
}

/// Time, rays and speed-up against the depth of reflections
///
/// Every picture is compared with the recursion's, bit for bit, and its ray counts too, before
/// it is timed; a difference ends the study with exit code 1.
#[derive(Args, Debug)]
pub(super) struct DepthOptions {
    #[command(flatten)]
    pub(super) common: Common,

    /// Depths, with commas between them
    #[arg(long, value_name = "LIST", value_delimiter = ',', default_values_t = DEPTHS,
          value_parser = whole::<0, { u32::MAX }>)]
    pub(super) depths: Vec<u32>,

    /// Engines, with commas between them
    #[arg(long, value_name = "LIST", value_enum, value_delimiter = ',',
          default_values_t = [Engine::Recursive, Engine::Packet])]
    pub(super) engines: Vec<Engine>,

    #[command(flatten)]
    pub(super) timed: Timed,
}

/// Error against time of tracing: depth, weight cut, samples, formulas, precision
///
/// Truth is in double-double, at a depth past which nothing changes; pictures are made small
/// enough for it. Names the cheapest setting for some aims, and those that nothing beats.
#[derive(Args, Debug)]
pub(super) struct ErrorOptions {
    #[command(flatten)]
    pub(super) common: Common,

    /// Find and name the cheapest setting with an RMSE of at most X, linear
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = target_error)]
    pub(super) target_error: Option<f64>,

    #[command(flatten)]
    pub(super) timed: Timed,
}

/// From the recursion to the engine, rung by rung: bits, speed, stack, lines
///
/// Every rung of crates/ladder is checked against the recursion, bit for bit, and timed on one
/// thread; a rung that breaks its promise ends the study with exit code 1.
#[derive(Args, Debug)]
pub(super) struct LadderOptions {
    #[command(flatten)]
    pub(super) common: Common,

    #[command(flatten)]
    pub(super) timed: Timed,
}

/// Stiff and extreme cases against truth: where the numerics hold, and where nothing can
///
/// Without scenes, the suite: every case with its bound for textbook f32, robust f32 and
/// robust f64, growth of errors, condition maps. With scenes, the same measures of these. A
/// case that fails and is not known to ends with exit code 1.
#[derive(Args, Debug)]
pub(super) struct StabilityOptions {
    #[command(flatten)]
    pub(super) common: Common,
}

fn target_error(text: &str) -> Result<f64, &'static str> {
    let number = text.parse().ok().filter(|x: &f64| x.is_finite() && *x > 0.0);
    number.ok_or("allowed is a finite number above 0")
}

impl Study {
    /// Names of all studies on the command line, and of their files.
    pub(super) const NAMES: [&str; 4] = ["depth", "error", "ladder", "stability"];

    pub(super) fn name(&self) -> &'static str {
        match self {
            Self::Depth(_) => "depth",
            Self::Error(_) => "error",
            Self::Ladder(_) => "ladder",
            Self::Stability(_) => "stability",
        }
    }

    pub(super) fn common(&self) -> &Common {
        match self {
            Self::Depth(options) => &options.common,
            Self::Error(options) => &options.common,
            Self::Ladder(options) => &options.common,
            Self::Stability(options) => &options.common,
        }
    }
}

const EXAMPLES: &str = "\
Examples:
  catoptric study depth scenes/workshop.toml -o depth
  catoptric study stability -o stability
  catoptric study error scenes/workshop.toml --target-error 1e-4
  catoptric study ladder scenes/workshop.toml
  catoptric study depth scenes/corridor.toml --depths 0,10,100 --engines packet --json";
