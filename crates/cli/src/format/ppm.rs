//! PPM, binary: `P6\nWIDTH HEIGHT\n255\n`, then three bytes a pixel from the top left.

use std::io::{self, Write};

use super::header::Header;
use super::{Levels, Unreadable};

pub(super) fn write(levels: &Levels, to: &mut dyn Write) -> io::Result<()> {
    write!(to, "P6\n{} {}\n255\n", levels.width, levels.height)?;
    to.write_all(levels.pixels.as_flattened())
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
