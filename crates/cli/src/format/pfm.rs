//! PFM: `PF\nWIDTH HEIGHT\n-1.0\n`, then three f32 a pixel, bottom row first, each row from
//! the left. A negative scale means little-endian. Values are written as they are: no
//! clamp, no transfer, NaN with its payload.

use std::io::{self, Write};

use catoptric_scene::Film;

use super::Unreadable;
use super::header::Header;

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

/// Reads either byte order. A scale other than 1 and -1 is refused: there is no agreement
/// whether values are multiplied by it.
pub(super) fn read(bytes: &[u8]) -> Result<Film, Unreadable> {
    let header = Header::read(bytes, |scale| match scale.parse::<f32>() {
        Ok(-1.0 | 1.0) => Ok(size_of::<f32>()),
        _ => Err(Unreadable::Other(format!(
            "has the scale {scale}: allowed are -1.0 (little-endian) and 1.0 (big-endian)"
        ))),
    })?;
    let value = if header.third.starts_with('-') { f32::from_le_bytes } else { f32::from_be_bytes };
    let mut film = Film::new(header.width, header.height);
    let width = header.width as usize;
    let from = header.pixels.as_chunks::<4>().0.as_chunks::<3>().0.chunks_exact(width);
    for (row, from) in film.pixels_mut().chunks_exact_mut(width).rev().zip(from) {
        for (pixel, from) in row.iter_mut().zip(from) {
            *pixel = from.map(value);
        }
    }
    Ok(film)
}
