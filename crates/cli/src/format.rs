//! Picture formats: what each of them holds, and its bytes, both ways.

mod header;
mod opened;
mod pfm;
pub(crate) mod png;
mod ppm;
mod source;

use std::fmt;
use std::io::{self, Write};
use std::path::Path;

use catoptric_scene::{Film, Quantiser, Transfer};
use clap::ValueEnum;
use rayon::prelude::*;

pub(crate) use opened::Opened;
use opened::Unreadable;

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

/// A picture, read or rendered.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Picture {
    /// What PNG and PPM hold.
    Levels(Levels),
    /// What PFM holds.
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

impl Levels {
    /// A black picture. Its pages are taken as they are first written.
    pub(crate) fn new(width: u32, height: u32) -> Self {
        Self { width, height, pixels: vec![[0; 3]; width as usize * height as usize] }
    }
}

impl Picture {
    /// As 8-bit levels; a film is converted on rayon's current threads.
    fn into_levels(self, quantiser: &Quantiser) -> Levels {
        /// Pixels in a piece of work: enough to be worth handing over.
        const PIECE: usize = 1 << 14;
        match self {
            Self::Levels(levels) => levels,
            Self::Linear(film) => {
                let mut levels = Levels::new(film.width(), film.height());
                let pieces = levels.pixels.par_chunks_mut(PIECE);
                let linear = film.pixels().par_chunks(PIECE);
                pieces.zip(linear).for_each(|(to, linear)| quantiser.levels(linear, to));
                levels
            }
        }
    }
}
