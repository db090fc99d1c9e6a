//! The text in front of PPM, PGM and PFM pixels: a magic word and three numbers, separated by
//! blanks, then one blank. A `#` begins a comment up to the line's end.

use super::source::Source;
use super::unreadable::Unreadable;

/// Bytes of a header, comments included, that are read in search of its end.
const HEADER_BYTES: u64 = 1 << 16;

/// Bytes of a word, at most: no number is longer.
const WORD_BYTES: usize = 64;

/// What the formats have in common.
pub(super) struct Header {
    pub(super) width: u32,
    pub(super) height: u32,
    /// PPM and PGM: the largest value; PFM: the scale, whose sign is the byte order.
    pub(super) third: String,
}

impl Header {
    /// Reads a header with its magic word; the pixels follow.
    pub(super) fn read(from: &mut Source) -> Result<Self, Unreadable> {
        let magic = from.fill(&mut [0; 2])?;
        debug_assert_eq!(magic, 2, "the magic word has been seen");
        let mut next = || {
            let word = word(from, HEADER_BYTES)?;
            word.ok_or_else(|| Unreadable::Bad("breaks off in its header".to_owned()))
        };
        let (width, height, third) = (side(&next()?)?, side(&next()?)?, next()?);
        Ok(Self { width, height, third })
    }

    /// Pixels in all.
    pub(super) fn pixels(&self) -> u64 {
        u64::from(self.width) * u64::from(self.height)
    }

    /// Holds the size that the header claims against the length of the file, where that is
    /// known: a header that lies is found before anything is taken for it.
    pub(super) fn check_length(&self, from: &Source, bytes_a_pixel: u64) -> Result<(), Unreadable> {
        let expected = u128::from(self.pixels()) * u128::from(bytes_a_pixel);
        match from.left() {
            Some(left) if u128::from(left) != expected => {
                Err(self.wrong_length(&left.to_string(), expected))
            }
            _ => Ok(()),
        }
    }

    /// Reads all pixels, of which nothing may be missing and after which nothing may come.
    pub(super) fn fill(&self, from: &mut Source, to: &mut [u8]) -> Result<(), Unreadable> {
        let found = from.fill(to)?;
        if found < to.len() {
            return Err(self.wrong_length(&found.to_string(), to.len() as u128));
        }
        Ok(())
    }

    /// Makes sure that nothing comes after all `expected` bytes.
    pub(super) fn end(&self, from: &mut Source, expected: u64) -> Result<(), Unreadable> {
        match from.byte()? {
            None => Ok(()),
            Some(_) => Err(self.wrong_length(&format!("more than {expected}"), expected.into())),
        }
    }

    pub(super) fn wrong_length(&self, found: &str, expected: u128) -> Unreadable {
        let Self { width, height, .. } = self;
        Unreadable::Bad(format!(
            "has {found} bytes of pixels where {width}x{height} are {expected}"
        ))
    }
}

/// The next word and the one blank after it, which must be there, within the first `limit`
/// bytes; `None` where the bytes end before.
fn word(from: &mut Source, limit: u64) -> Result<Option<String>, Unreadable> {
    let mut word = Vec::new();
    loop {
        let Some(byte) = from.byte()? else { return Ok(None) };
        match byte {
            b'#' if word.is_empty() => loop {
                match from.byte()? {
                    None => return Ok(None),
                    Some(b'\n') => break,
                    Some(_) => within(from, limit)?,
                }
            },
            blank if blank.is_ascii_whitespace() => {
                if !word.is_empty() {
                    return Ok(Some(String::from_utf8_lossy(&word).into_owned()));
                }
            }
            _ if word.len() == WORD_BYTES => {
                return Err(Unreadable::Bad(format!(
                    "has a number of more than {WORD_BYTES} bytes"
                )));
            }
            byte => word.push(byte),
        }
        within(from, limit)?;
    }
}

/// A header without an end would be read for ever.
fn within(from: &Source, limit: u64) -> Result<(), Unreadable> {
    if from.taken() <= limit {
        return Ok(());
    }
    Err(Unreadable::Bad(format!("has a header of more than {limit} bytes")))
}

fn side(word: &str) -> Result<u32, Unreadable> {
    let side = word.parse().ok().filter(|&side| side > 0);
    side.ok_or_else(|| Unreadable::Bad(format!("has a side of {word:?} pixels")))
}
