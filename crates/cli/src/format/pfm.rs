//! PFM: `PF\nWIDTH HEIGHT\n-1.0\n`, then three f32 a pixel, bottom row first, each row from
//! the left. A negative scale means little-endian. Values are written as they are: no
//! clamp, no transfer, NaN with its payload.

use std::io::{self, Write};

use catoptric_scene::Film;

use super::header::Header;
use super::source::Source;
use super::unreadable::Unreadable;

/// Bytes of one row.
pub(super) fn row_bytes(width: u32) -> u64 {
    u64::from(width) * 12
}

pub(super) fn write(film: &Film, to: &mut dyn Write) -> io::Result<()> {
    write!(to, "PF\n{} {}\n-1.0\n", film.width(), film.height())?;
    let mut bytes = vec![[0; 4]; film.width() as usize * 3];
    for row in film.pixels().chunks_exact(film.width() as usize).rev() {
        for (to, channel) in bytes.iter_mut().zip(row.as_flattened()) {
            *to = channel.to_le_bytes();
        }
        to.write_all(bytes.as_flattened())?;
    }
    Ok(())
}

/// A PFM whose header has been read.
pub(super) struct Pixels {
    from: Source,
    pub(super) header: Header,
}

impl Pixels {
    /// Reads a header of either byte order. A scale other than 1 and -1 is refused: there is no
    /// agreement whether values are multiplied by it.
    pub(super) fn open(mut from: Source) -> Result<Self, Unreadable> {
        let header = Header::read(&mut from)?;
        let scale = &header.third;
        if !matches!(scale.parse::<f32>(), Ok(-1.0 | 1.0)) {
            return Err(Unreadable::Other(format!(
                "has the scale {scale:?}: allowed are -1.0 (little-endian) and 1.0 (big-endian)"
            )));
        }
        header.check_length(&from, 12)?;
        Ok(Self { from, header })
    }

    /// Bytes that reading takes: the film, and a row.
    pub(super) fn bytes(&self) -> u64 {
        self.header.pixels().saturating_mul(12).saturating_add(row_bytes(self.header.width))
    }

    pub(super) fn read(self) -> Result<Film, Unreadable> {
        let Self { mut from, header } = self;
        let value =
            if header.third.starts_with('-') { f32::from_le_bytes } else { f32::from_be_bytes };
        let mut film = Film::new(header.width, header.height);
        let mut bytes = vec![0; header.width as usize * 12];
        let (mut found, expected) = (0, u128::from(header.pixels()) * 12);
        for row in film.pixels_mut().chunks_exact_mut(header.width as usize).rev() {
            let filled = from.fill(&mut bytes)?;
            found += filled;
            if filled < bytes.len() {
                return Err(header.wrong_length(&found.to_string(), expected));
            }
            let from = bytes.as_chunks::<4>().0.as_chunks::<3>().0;
            for (pixel, from) in row.iter_mut().zip(from) {
                *pixel = from.map(value);
            }
        }
        header.end(&mut from, found as u64)?;
        Ok(film)
    }
}
