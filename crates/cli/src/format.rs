//! Picture formats: what each of them holds, and its bytes, both ways.

mod header;
mod opened;
mod pfm;
mod picture;
pub(crate) mod png;
mod ppm;
mod source;
mod unreadable;

use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use catoptric_scene::{Quantiser, Transfer};
use clap::ValueEnum;

pub(crate) use opened::Opened;
pub(crate) use picture::{Levels, Picture};

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

    /// Whether it holds 8-bit levels, and not what was computed.
    pub(crate) fn is_8_bit(self) -> bool {
        self != Self::Pfm
    }

    /// Bytes that a picture takes, at most, from the first pixel to the last byte written:
    /// a film (12 a pixel) or levels (3 a pixel), and the writer's buffers.
    pub(crate) fn bytes(self, width: u32, height: u32, from_film: bool) -> u64 {
        let pixels = u64::from(width) * u64::from(height);
        match (self, from_film) {
            // The levels, while the film is still there. The compressed picture comes when
            // the film is gone, and is smaller than that.
            (Self::Png | Self::Ppm, true) => pixels * (12 + 3),
            // The compressed picture may be a little larger than the levels.
            (Self::Png, false) => pixels * (3 + 4),
            (Self::Ppm, false) => pixels * 3,
            (Self::Pfm, _) => pixels * 12 + pfm::row_bytes(width),
        }
    }

    /// Writes a picture. Takes it, so that its memory can be had back early. A film becomes
    /// levels here, for the formats that hold them.
    ///
    /// # Errors
    /// Only those of `to`.
    ///
    /// # Panics
    /// If a format of linear light is to be written from levels.
    pub(crate) fn write(
        self,
        picture: Picture,
        quantiser: &Quantiser,
        to: &mut dyn Write,
    ) -> io::Result<()> {
        match (self, picture) {
            (Self::Png, picture) => {
                let linear = quantiser.is_linear();
                let transfer = if linear { Transfer::Linear } else { Transfer::Srgb };
                png::write(&picture.into_levels(quantiser), transfer, to)
            }
            (Self::Ppm, picture) => ppm::write(&picture.into_levels(quantiser), to),
            (Self::Pfm, Picture::Linear(film)) => pfm::write(&film, to),
            (Self::Pfm, Picture::Levels(_)) => unreachable!("levels are only made to be written"),
        }
    }
}

impl fmt::Display for Format {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(self.name())
    }
}
