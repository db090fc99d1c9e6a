//! Reading a PNG: row by row into the picture, so that nothing else is as large as that.

use png::{BitDepth, Decoder, DecodingError, Limits, Reader, Transformations};

use crate::format::picture::Levels;
use crate::format::source::Source;
use crate::format::unreadable::Unreadable;

/// Bytes that chunks other than the picture may take. Text and colour profiles are skipped.
const CHUNK_BYTES: usize = 1 << 20;

/// First column and row of the passes of an interlaced picture, and their steps.
const PASSES: [([u32; 2], [u32; 2]); 7] = [
    ([0, 0], [8, 8]),
    ([4, 0], [8, 8]),
    ([0, 4], [4, 8]),
    ([2, 0], [4, 4]),
    ([0, 2], [2, 4]),
    ([1, 0], [2, 2]),
    ([0, 1], [1, 2]),
];

/// A PNG whose header has been read.
pub(in crate::format) struct Pixels {
    decoder: Decoder<Source>,
    pub(in crate::format) width: u32,
    pub(in crate::format) height: u32,
    interlaced: bool,
}

impl Pixels {
    pub(in crate::format) fn open(from: Source) -> Result<Self, Unreadable> {
        let mut decoder = Decoder::new_with_limits(from, Limits { bytes: CHUNK_BYTES });
        // Palettes become RGB, few bits 8, a transparent colour an alpha channel.
        decoder.set_transformations(Transformations::EXPAND);
        decoder.set_ignore_text_chunk(true);
        decoder.set_ignore_iccp_chunk(true);
        let header = decoder.read_header_info().map_err(unreadable)?;
        if header.bit_depth == BitDepth::Sixteen {
            return Err(Unreadable::Other(
                "is a PNG of 16 bits a channel: only 8-bit pictures can be compared".to_owned(),
            ));
        }
        let (width, height, interlaced) = (header.width, header.height, header.interlaced);
        Ok(Self { decoder, width, height, interlaced })
    }

    /// Bytes that reading takes: the levels, a row here and at most three of the decoder's.
    pub(in crate::format) fn bytes(&self) -> u64 {
        let pixels = u64::from(self.width) * u64::from(self.height);
        pixels.saturating_mul(3).saturating_add(u64::from(self.width) * 16)
    }

    /// Reads grey, RGB and palettes; alpha only where it is 255 everywhere, since leaving out
    /// anything else could hide a difference.
    pub(in crate::format) fn read(self) -> Result<Levels, Unreadable> {
        let Self { decoder, width, height, interlaced } = self;
        let mut reader = decoder.read_info().map_err(unreadable)?;
        if reader.info().animation_control.is_some() {
            return Err(Unreadable::Other(
                "is an animated PNG: only single pictures can be compared".to_owned(),
            ));
        }
        // One loop reads both layouts: a picture that is not interlaced is a single pass.
        let channels = reader.output_color_type().0.samples();
        let mut row = vec![0; width as usize * channels];
        let mut levels = Levels::new(width, height);
        let whole = [([0, 0], [1, 1])];
        for &([x0, y0], [dx, dy]) in if interlaced { PASSES.as_slice() } else { &whole } {
            let columns = width.saturating_sub(x0).div_ceil(dx) as usize;
            // A pass over a narrow picture can be empty, and then has no rows in the file.
            if columns == 0 {
                continue;
            }
            let row = &mut row[..columns * channels];
            for y in (y0..height).step_by(dy as usize) {
                let start = y as usize * width as usize + x0 as usize;
                let to = &mut levels.pixels[start..];
                // Whole rows of RGB are read in place.
                if channels == 3 && dx == 1 {
                    next_row(&mut reader, to[..columns].as_flattened_mut())?;
                    continue;
                }
                // Other rows are spread over their columns, one pixel at a time.
                next_row(&mut reader, row)?;
                let to = to.iter_mut().step_by(dx as usize);
                for (column, (to, from)) in to.zip(row.chunks_exact(channels)).enumerate() {
                    *to = opaque(from).ok_or_else(|| {
                        let x = x0 as usize + column * dx as usize;
                        let alpha = from[channels - 1];
                        Unreadable::Other(format!(
                            "is a PNG whose pixel ({x}, {y}) has the alpha {alpha}: only pictures without transparency, with 255 everywhere, can be compared"
                        ))
                    })?;
                }
            }
        }
        // The end is read too, so that a damaged file is not taken for whole.
        reader.finish().map_err(unreadable)?;
        Ok(levels)
    }
}

fn next_row(reader: &mut Reader<Source>, row: &mut [u8]) -> Result<(), Unreadable> {
    match reader.read_row(row) {
        Ok(Some(_)) => Ok(()),
        Ok(None) => Err(Unreadable::Bad("is a PNG with too few rows".to_owned())),
        Err(error) => Err(unreadable(error)),
    }
}

/// The RGB of a pixel of one to four channels; `None` where it is not opaque.
fn opaque(pixel: &[u8]) -> Option<[u8; 3]> {
    match *pixel {
        [grey] | [grey, 255] => Some([grey; 3]),
        [r, g, b] | [r, g, b, 255] => Some([r, g, b]),
        _ => None,
    }
}

fn unreadable(error: DecodingError) -> Unreadable {
    match error {
        // Where the file ends early, the decoder's words say so.
        DecodingError::IoError(error) if error.kind() != std::io::ErrorKind::UnexpectedEof => {
            Unreadable::Io(error)
        }
        DecodingError::LimitsExceeded => Unreadable::Bad(format!(
            "is a PNG with more than {CHUNK_BYTES} bytes beside its pixels, or of a size that no memory holds"
        )),
        error => Unreadable::Bad(format!("is a PNG that cannot be read: {error}")),
    }
}
