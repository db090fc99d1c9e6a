//! A picture whose header has been read, and no more: what it claims can be weighed before
//! anything is taken for it.

use std::path::Path;

use super::picture::Picture;
use super::source::Source;
use super::unreadable::Unreadable;
use super::{pfm, png, ppm};
use crate::exit::Failure;
use crate::input;

/// A picture that can be read.
pub(crate) struct Opened {
    name: String,
    pixels: Pixels,
}

enum Pixels {
    Png(Box<png::Pixels>),
    Ppm(ppm::Pixels),
    Pfm(pfm::Pixels),
}

impl Opened {
    /// Opens a picture, `-` from stdin; its first bytes say which format it has.
    ///
    /// # Errors
    /// Exit code 3 for what is missing, no picture of these formats or broken; exit code 2 for
    /// one that holds something else than 8-bit levels or f32 RGB.
    pub(crate) fn open(path: &Path) -> Result<Self, Failure> {
        let name = input::name(path);
        match Source::open(path).map_err(Unreadable::from).and_then(pixels) {
            Ok(pixels) => Ok(Self { name, pixels }),
            Err(error) => Err(error.of(&name)),
        }
    }

    /// How messages call it.
    pub(crate) fn name(&self) -> &str {
        &self.name
    }

    /// Columns and rows.
    pub(crate) fn size(&self) -> (u32, u32) {
        match &self.pixels {
            Pixels::Png(png) => (png.width, png.height),
            Pixels::Ppm(ppm) => (ppm.header.width, ppm.header.height),
            Pixels::Pfm(pfm) => (pfm.header.width, pfm.header.height),
        }
    }

    /// The kind of the picture's values, for messages.
    pub(crate) fn kind(&self) -> &'static str {
        match &self.pixels {
            Pixels::Png(_) | Pixels::Ppm(_) => "8-bit levels",
            Pixels::Pfm(_) => "linear f32",
        }
    }

    /// Bytes that [`Opened::read`] takes, at most, besides a fixed number of buffers.
    pub(crate) fn bytes(&self) -> u64 {
        match &self.pixels {
            Pixels::Png(png) => png.bytes(),
            Pixels::Ppm(ppm) => ppm.bytes(),
            Pixels::Pfm(pfm) => pfm.bytes(),
        }
    }

    /// Reads its pixels.
    ///
    /// # Errors
    /// As [`Opened::open`].
    pub(crate) fn read(self) -> Result<Picture, Failure> {
        let read = match self.pixels {
            Pixels::Png(png) => png.read().map(Picture::Levels),
            Pixels::Ppm(ppm) => ppm.read().map(Picture::Levels),
            Pixels::Pfm(pfm) => pfm.read().map(Picture::Linear),
        };
        read.map_err(|error| error.of(&self.name))
    }
}

fn pixels(from: Source) -> Result<Pixels, Unreadable> {
    match from.magic() {
        [0x89, b'P'] => png::Pixels::open(from).map(|png| Pixels::Png(Box::new(png))),
        [b'P', b'2' | b'3' | b'5' | b'6'] => ppm::Pixels::open(from).map(Pixels::Ppm),
        [b'P', b'F'] => pfm::Pixels::open(from).map(Pixels::Pfm),
        _ => Err(Unreadable::Bad(
            "is no picture that is known: allowed are PNG, PPM (P6, P3), PGM (P5, P2) and PFM (PF)"
                .to_owned(),
        )),
    }
}
