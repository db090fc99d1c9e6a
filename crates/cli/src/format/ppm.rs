//! PPM, binary: `P6\nWIDTH HEIGHT\n255\n`, then three bytes a pixel from the top left.

use std::io::{self, Write};

use catoptric_scene::{Film, Quantiser};

use super::header::Header;
use super::{Levels, Unreadable, levels};

/// Pixels that are converted at a time: enough for all threads, and still in the cache.
const BAND: usize = 1 << 18;

/// Bytes of the band.
pub(super) fn band_bytes(width: u32, height: u32) -> u64 {
    3 * (u64::from(width) * u64::from(height)).min(BAND as u64)
}

pub(super) fn write(film: &Film, quantiser: &Quantiser, to: &mut dyn Write) -> io::Result<()> {
    write!(to, "P6\n{} {}\n255\n", film.width(), film.height())?;
    let mut band = vec![0; 3 * BAND.min(film.pixels().len())];
    for pixels in film.pixels().chunks(BAND) {
        let band = &mut band[..3 * pixels.len()];
        levels(pixels, quantiser, band);
        to.write_all(band)?;
    }
    Ok(())
}

pub(super) fn read(bytes: &[u8]) -> Result<Levels, Unreadable> {
    let header = Header::read(bytes, |largest| match largest {
        "255" => Ok(1),
        other => Err(Unreadable::Other(format!(
            "has the largest value {other}: only 8-bit pictures, with 255, can be compared"
        ))),
    })?;
    let pixels = header.pixels.as_chunks().0.to_vec();
    Ok(Levels { width: header.width, height: header.height, pixels })
}
