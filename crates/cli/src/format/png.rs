//! PNG, 8-bit RGB: no time stamp and no other chunk that could differ, so equal pixels are
//! equal files.

mod reading;

use std::io::{self, Write};

use catoptric_scene::Transfer;
use png::{BitDepth, ColorType, Compression, Encoder, Filter, ScaledFloat, SrgbRenderingIntent};

pub(super) use reading::Pixels;

use super::picture::Levels;

pub(super) fn write(levels: &Levels, transfer: Transfer, to: &mut dyn Write) -> io::Result<()> {
    let Levels { width, height, ref pixels } = *levels;
    encode(pixels.as_flattened(), width, height, Some(transfer), to)
}

/// Writes levels, three a pixel from the top left, and how they come from light: an `sRGB` chunk
/// for that curve, a `gAMA` chunk of 1 for linear levels. Levels that are not light (`None`) have
/// neither.
pub(crate) fn encode(
    levels: &[u8],
    width: u32,
    height: u32,
    transfer: Option<Transfer>,
    to: &mut dyn Write,
) -> io::Result<()> {
    let mut encoder = Encoder::new(to, width, height);
    encoder.set_color(ColorType::Rgb);
    encoder.set_depth(BitDepth::Eight);
    match transfer {
        None => {}
        Some(Transfer::Linear) => encoder.set_source_gamma(ScaledFloat::from_scaled(100_000)),
        Some(Transfer::Srgb) => encoder.set_source_srgb(SrgbRenderingIntent::Perceptual),
    }
    // Measured on renderings of 1080p against every other level and filter: 5 to 11 ms and
    // 0.5 MB, where level 1 takes twice and the default twenty times as long for 0 to 40 %
    // less.
    encoder.set_compression(Compression::Fast);
    encoder.set_filter(Filter::Paeth);
    let mut writer = encoder.write_header()?;
    writer.write_image_data(levels)?;
    writer.finish()?;
    Ok(())
}
