//! Picture formats: what each of them holds, and its bytes, both ways.

mod header;
mod pfm;
pub(crate) mod png;
mod ppm;

use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use catoptric_scene::{Film, Quantiser};
use clap::ValueEnum;
use rayon::prelude::*;

use crate::exit::Failure;

/// How a picture is written.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(crate) enum Format {
    /// 8 bits a channel, compressed without loss
    Png,
    /// 8 bits a channel, binary (P6)
    Ppm,
    /// the exact result: linear f32, little-endian, bottom row first
    Pfm,
}

impl Format {
    /// The format of a file's ending, in any case.
    pub(crate) fn of_path(path: &Path) -> Option<Self> {
        let ending = path.extension()?.to_str()?.to_ascii_lowercase();
        Self::value_variants().iter().copied().find(|format| format.name() == ending)
    }

    /// `png`, `ppm` or `pfm`: also the file's ending.
    pub(crate) fn name(self) -> &'static str {
        match self {
            Self::Png => "png",
            Self::Ppm => "ppm",
            Self::Pfm => "pfm",
        }
    }

    /// Bytes that writing takes beside the film, at most.
    pub(crate) fn writer_bytes(self, width: u32, height: u32) -> u64 {
        let pixels = u64::from(width) * u64::from(height);
        match self {
            // The levels, while the film is still there. The compressed picture comes when
            // the film is gone, and is smaller than that.
            Self::Png => pixels * 3,
            Self::Ppm => ppm::band_bytes(width, height),
            Self::Pfm => pfm::row_bytes(width),
        }
    }

    /// Writes a picture. Takes the film, so that its memory can be had back early.
    ///
    /// # Errors
    /// Only those of `to`.
    pub(crate) fn write(
        self,
        film: Film,
        quantiser: &Quantiser,
        to: &mut dyn Write,
    ) -> io::Result<()> {
        match self {
            Self::Png => png::write(film, quantiser, to),
            Self::Ppm => ppm::write(&film, quantiser, to),
            Self::Pfm => pfm::write(&film, to),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}

/// 8-bit levels of pixels, three a pixel, on rayon's current threads.
fn levels(pixels: &[[f32; 3]], quantiser: &Quantiser, to: &mut [u8]) {
    /// Pixels in a piece of work: enough to be worth handing over.
    const PIECE: usize = 1 << 14;
    to.par_chunks_mut(3 * PIECE).zip(pixels.par_chunks(PIECE)).for_each(|(to, pixels)| {
        quantiser.levels(pixels, to.as_chunks_mut().0);
    });
}

/// A picture that was read.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Picture {
    /// From PNG or PPM.
    Levels(Levels),
    /// From PFM.
    Linear(Film),
}

/// An 8-bit picture.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(crate) struct Levels {
    pub(crate) width: u32,
    pub(crate) height: u32,
    /// Row by row from the top left.
    pub(crate) pixels: Vec<[u8; 3]>,
}

impl Picture {
    /// Reads a picture; its first bytes say which format it has. `name` is for messages.
    ///
    /// # Errors
    /// Exit code 3 for what is no picture of the three formats or is broken; exit code 2
    /// for one that holds something else than 8-bit or f32 RGB.
    pub(crate) fn parse(name: &str, bytes: &[u8]) -> Result<Self, Failure> {
        let read = match bytes {
            [0x89, b'P', b'N', b'G', ..] => png::read(bytes).map(Self::Levels),
            [b'P', b'6', ..] => ppm::read(bytes).map(Self::Levels),
            [b'P', b'F', ..] => pfm::read(bytes).map(Self::Linear),
            _ => {
                let what = "is no picture that is known: allowed are PNG, PPM (P6) and PFM (PF)";
                Err(Unreadable::Bad(what.to_owned()))
            }
        };
        read.map_err(|error| match error {
            Unreadable::Bad(what) => Failure::bad_input(format_args!("{name} {what}")),
            Unreadable::Other(what) => Failure::wrong_use(format_args!("{name} {what}")),
        })
    }

    /// Columns and rows.
    pub(crate) fn size(&self) -> (u32, u32) {
        match self {
            Self::Levels(levels) => (levels.width, levels.height),
            Self::Linear(film) => (film.width(), film.height()),
        }
    }

    /// What its values are, for messages.
    pub(crate) fn kind(&self) -> &'static str {
        match self {
            Self::Levels(_) => "8-bit levels",
            Self::Linear(_) => "linear f32",
        }
    }
}

/// Why a picture could not be read; the text continues the file's name.
#[derive(Debug, PartialEq, Eq)]
enum Unreadable {
    /// Broken.
    Bad(String),
    /// Sound, but not what is compared here.
    Other(String),
}
