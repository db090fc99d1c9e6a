//! The command line of `generate`: what all families share. Each family's own options are
//! in a file of its name.

mod corridor;
mod kissing;
mod lattice;
mod own;
mod random;
mod room;
mod sphereflake;

use std::path::{Path, PathBuf};

use catoptric_scene::{Draft, SceneFormat};
use clap::{Args, Subcommand, ValueEnum};

use super::recipe::Recipe;
use crate::whole::whole;
use own::Own;

/// Make the scene of a family from a few numbers and a seed
///
/// The same family, options and seed make the same scene on every machine and in every
/// version. Numbers out of range are refused, and every scene within is valid.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(crate) struct Options {
    #[command(subcommand)]
    pub(super) family: Family,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate corridor
  catoptric generate random --balls 1000 --seed 7 -o cloud.toml
  catoptric generate sphereflake --levels 2 -o - | catoptric render - -o flake.png";

/// A family with its options.
#[derive(Debug, Subcommand)]
pub(super) enum Family {
    Corridor(Asked<corridor::Options>),
    Room(Asked<room::Options>),
    Kissing(Asked<kissing::Options>),
    Random(Asked<random::Options>),
    Lattice(Asked<lattice::Options>),
    Sphereflake(Asked<sphereflake::Options>),
}

// A family's own options, then those of all families. No doc comment here nor on `Common`:
// it would stand in the help in the place of the family's.
#[derive(Args, Debug)]
pub(super) struct Asked<F: Args> {
    #[command(flatten)]
    own: F,
    #[command(flatten)]
    common: Common,
}

impl Family {
    /// Own and common options of whichever family it is.
    pub(super) fn parts(&self) -> (&dyn Own, &Common) {
        match self {
            Self::Corridor(asked) => (&asked.own, &asked.common),
            Self::Room(asked) => (&asked.own, &asked.common),
            Self::Kissing(asked) => (&asked.own, &asked.common),
            Self::Random(asked) => (&asked.own, &asked.common),
            Self::Lattice(asked) => (&asked.own, &asked.common),
            Self::Sphereflake(asked) => (&asked.own, &asked.common),
        }
    }
}

// Options of all families.
#[derive(Args, Debug)]
pub(super) struct Common {
    /// What decides everything that is left to chance, 0 to 18446744073709551615
    #[arg(long, value_name = "N", allow_negative_numbers = true, default_value_t = 0)]
    pub(super) seed: u64,

    /// Columns of the image, 1 to 65535 [default: 640]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 65_535>)]
    width: Option<u32>,

    /// Rows of the image, 1 to 65535 [default: 480]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<1, 65_535>)]
    height: Option<u32>,

    /// Reflections that the scene asks for, 0 to 4294967295 [default: the family's]
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          value_parser = whole::<0, { u32::MAX }>)]
    max_depth: Option<u32>,

    /// Scene file to write; `-` is stdout
    ///
    /// A regular file is written beside its name and renamed when it is complete; a device
    /// or pipe is written directly. [default: the family's name with the format's ending, in
    /// the current folder]
    #[arg(short, long, value_name = "FILE|-")]
    pub(super) output: Option<PathBuf>,

    /// Format of the scene [default: by the ending of -o, else toml]
    #[arg(long, value_enum)]
    pub(super) format: Option<Format>,

    /// Nothing on stderr but errors: no closing line
    #[arg(short, long)]
    pub(super) quiet: bool,
}

impl Common {
    /// Sets what stands above the family's own.
    pub(super) fn override_scene(&self, draft: &mut Draft) {
        draft.image.width = self.width.unwrap_or(draft.image.width);
        draft.image.height = self.height.unwrap_or(draft.image.height);
        draft.render.max_depth = self.max_depth.unwrap_or(draft.render.max_depth);
    }

    /// The command with what these options say about the scene.
    pub(super) fn add_to(&self, recipe: Recipe) -> Recipe {
        recipe
            .with("--seed", self.seed)
            .with_any("--width", self.width)
            .with_any("--height", self.height)
            .with_any("--max-depth", self.max_depth)
    }
}

/// How a scene is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum Format {
    /// for people, with a comment that says how it was made
    Toml,
    /// for programs
    Json,
}

impl Format {
    /// The format of a file's ending, in any case.
    pub(super) fn of_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::value_variants().iter().copied().find(|format| format.name() == ending)
    }

    /// `toml` or `json`: also the file's ending.
    pub(super) fn name(self) -> &'static str {
        match self {
            Self::Toml => "toml",
            Self::Json => "json",
        }
    }

    /// The same format, as the library calls it.
    pub(super) fn of_scene(self) -> SceneFormat {
        match self {
            Self::Toml => SceneFormat::Toml,
            Self::Json => SceneFormat::Json,
        }
    }
}
