//! The command line of `render`.

use std::path::PathBuf;

use catoptric_scene::allowed::AMOUNT;
use catoptric_scene::{Crop, Draft, Numerics, Transfer};
use clap::{Args, ValueEnum};

use super::engine::{Engine, Precision};
use super::progress::When;
use crate::format::Format;
use crate::size::Size;
use crate::whole::whole;

/// Render a scene to a picture
///
/// Options that name something of the scene stand above what its file says, and are held
/// to the same ranges.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Options {
    /// Scene file, TOML or (ending in .json) JSON; `-` reads stdin, where JSON begins with `{`
    #[arg(value_name = "SCENE|-")]
    pub(super) scene: PathBuf,

    /// Picture to write; `-` is stdout and needs --format
    ///
    /// A regular file is written beside its name and renamed when it is complete. One that is
    /// replaced keeps its permission bits and, as far as the system lets, its owner and group,
    /// but neither ACLs nor extended attributes. A symbolic link is followed and kept; other
    /// hard links keep the old file. Where no rename is possible (a file that is mounted by
    /// itself, another user's in a sticky folder), the complete file is copied into the one
    /// that is there, which the closing line says, or it is refused before tracing.
    ///
    /// A device or pipe is written directly, and so is a file that the caller opened
    /// (/dev/stdout, /dev/fd/3, or a link to one), from where the caller is in it. What a killed
    /// run leaves (.catoptric-*.unfinished) is removed by the next run to the same name.
    /// [default: the scene's name with the format's ending, in
    /// the current folder; for stdin `scene.png`]
    #[arg(short, long, value_name = "FILE|-")]
    pub(super) output: Option<PathBuf>,

    /// Format of the picture [default: by the ending of -o, else png]
    #[arg(long, value_enum)]
    pub(super) format: Option<Format>,

    /// What traces the rays; both give the same bits
    #[arg(long, value_enum, default_value_t = Engine::Packet)]
    pub(super) engine: Engine,

    /// Arithmetic; f64 and dd need --engine recursive, and are rounded to f32 at the end
    #[arg(long, value_enum, default_value_t = Precision::F32)]
    pub(super) precision: Precision,

    /// Formulas: `robust`, or the workshop's [default: the scene's, else robust]
    #[arg(long, value_parser = numerics)]
    pub(super) numerics: Option<Numerics>,

    /// How light becomes the levels of png and ppm: `linear`, or the `srgb` curve
    /// [default: the scene's, else linear]
    #[arg(long, value_parser = transfer)]
    pub(super) transfer: Option<Transfer>,

    /// Columns of the image, 1 to 65535 [default: the scene's, else 640]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 65_535>)]
    pub(super) width: Option<u32>,

    /// Rows of the image, 1 to 65535 [default: the scene's, else 480]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 65_535>)]
    pub(super) height: Option<u32>,

    /// Reflections that are followed, 0 to 4294967295 [default: the scene's, else 5]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<0, { u32::MAX }>)]
    pub(super) max_depth: Option<u32>,

    /// A reflected ray of less weight than X (0 or more) adds black [default: the scene's, else 0]
    #[arg(long, value_name = "X", allow_negative_numbers = true, value_parser = min_weight)]
    pub(super) min_weight: Option<f64>,

    /// N x N rays a pixel, N from 1 to 256
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 1,
          value_parser = whole::<1, 256>)]
    pub(super) samples: u32,

    /// Only these pixels of the image: left column, top row, columns, rows
    #[arg(long, value_name = "X,Y,W,H", allow_hyphen_values = true, value_parser = crop)]
    pub(super) crop: Option<Crop>,

    /// Threads that trace, 1 to 1024 [default: as many as the system can run at once]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 1024>)]
    pub(super) threads: Option<u32>,

    /// Memory for the picture, the scene and the stacks of deep paths
    ///
    /// Plain bytes, or with K, M, G (powers of 1000) or KiB, MiB, GiB (powers of 1024). A
    /// picture that needs more is refused before anything is taken. The recursive engine's
    /// stacks are not part of it.
    #[arg(long, value_name = "SIZE", allow_hyphen_values = true, default_value = "2GiB")]
    pub(super) memory_limit: Size,

    /// Write what was done as one JSON object: times in ms, rays by kind and depth
    #[arg(long, value_name = "FILE|-")]
    pub(super) stats: Option<PathBuf>,

    /// Progress bar on stderr; auto: where stderr is a terminal
    #[arg(long, value_enum, default_value_t = When::Auto, value_name = "WHEN")]
    pub(super) progress: When,

    /// Nothing on stderr but errors: no progress bar, no closing line
    #[arg(short, long)]
    pub(super) quiet: bool,
}

impl Options {
    /// Sets what stands above the file.
    pub(super) fn override_scene(&self, draft: &mut Draft) {
        fn set<T>(value: &mut T, above: Option<T>) {
            if let Some(above) = above {
                *value = above;
            }
        }
        set(&mut draft.image.transfer, self.transfer);
        set(&mut draft.image.width, self.width);
        set(&mut draft.image.height, self.height);
        set(&mut draft.render.max_depth, self.max_depth);
        set(&mut draft.render.min_weight, self.min_weight);
        set(&mut draft.render.numerics, self.numerics);
    }
}

fn numerics(text: &str) -> Result<Numerics, &'static str> {
    match text {
        "robust" => Ok(Numerics::Robust),
        "textbook" => Ok(Numerics::Textbook),
        _ => Err("allowed are robust and textbook"),
    }
}

fn transfer(text: &str) -> Result<Transfer, &'static str> {
    match text {
        "linear" => Ok(Transfer::Linear),
        "srgb" => Ok(Transfer::Srgb),
        _ => Err("allowed are linear and srgb"),
    }
}

fn min_weight(text: &str) -> Result<f64, String> {
    let number = text.parse().ok().filter(|&x| AMOUNT.holds(x));
    number.ok_or_else(|| format!("allowed is {}", AMOUNT.text))
}

fn crop(text: &str) -> Result<Crop, &'static str> {
    let numbers: Option<Vec<u32>> = text.split(',').map(|part| part.trim().parse().ok()).collect();
    match numbers.as_deref() {
        Some(&[x, y, width, height]) => Ok(Crop { x, y, width, height }),
        _ => Err("allowed are four whole numbers X,Y,W,H, such as 0,0,64,48"),
    }
}

impl ValueEnum for Engine {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::Packet, Self::Recursive]
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(clap::builder::PossibleValue::new(self.name()))
    }
}

impl ValueEnum for Precision {
    fn value_variants<'a>() -> &'a [Self] {
        &[Self::F32, Self::F64, Self::DoubleDouble]
    }

    fn to_possible_value(&self) -> Option<clap::builder::PossibleValue> {
        Some(clap::builder::PossibleValue::new(self.name()))
    }
}

const EXAMPLES: &str = "\
Environment:
  CATOPTRIC_ISA=portable|avx2  instruction set of the packet engine, lowered to what the
                               processor has [default: the best that it has]

Examples:
  catoptric render scene.toml
  catoptric render scene.toml -o mirror.png --max-depth 50 --samples 4
  catoptric render scene.toml -o exact.pfm --engine recursive
  catoptric render scene.toml -o screen.png --transfer srgb
  catoptric render - -o - --format ppm < scene.toml > scene.ppm
  catoptric render scene.toml -o part.png --crop 0,0,64,48 --stats part.json";
