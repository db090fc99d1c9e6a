//! The text in front of PPM and PFM pixels: a magic word and three numbers, separated by
//! blanks, then one blank. A `#` begins a comment up to the line's end.

use super::Unreadable;

/// What the two formats have in common.
pub(super) struct Header<'a> {
    pub(super) width: u32,
    pub(super) height: u32,
    /// PPM: the largest value; PFM: the scale, whose sign is the byte order.
    pub(super) third: &'a str,
    /// What follows: pixels and nothing else.
    pub(super) pixels: &'a [u8],
}

impl<'a> Header<'a> {
    /// Reads a header; `bytes_a_channel` of the third number says how much must follow.
    pub(super) fn read(
        bytes: &'a [u8],
        bytes_a_channel: impl FnOnce(&str) -> Result<usize, Unreadable>,
    ) -> Result<Self, Unreadable> {
        let mut rest = &bytes[2..];
        let mut next = || {
            let broken = || Unreadable::Bad("breaks off in its header".to_owned());
            word(&mut rest).ok_or_else(broken)
        };
        let (width, height, third) = (side(next()?)?, side(next()?)?, next()?);
        // The one blank after the header; `word` has seen that it is there.
        let pixels = &rest[1..];
        let channels = u128::from(width) * u128::from(height) * 3;
        let expected = channels * bytes_a_channel(third)? as u128;
        if pixels.len() as u128 != expected {
            let found = pixels.len();
            return Err(Unreadable::Bad(format!(
                "has {found} bytes of pixels where {width}x{height} are {expected}"
            )));
        }
        Ok(Self { width, height, third, pixels })
    }
}

/// The next word, which a blank must end.
fn word<'a>(rest: &mut &'a [u8]) -> Option<&'a str> {
    loop {
        *rest = rest.trim_ascii_start();
        if rest.first() != Some(&b'#') {
            break;
        }
        let end = rest.iter().position(|&b| b == b'\n')?;
        *rest = &rest[end..];
    }
    let end = rest.iter().position(u8::is_ascii_whitespace)?;
    let word = std::str::from_utf8(&rest[..end]).ok()?;
    *rest = &rest[end..];
    Some(word)
}

fn side(word: &str) -> Result<u32, Unreadable> {
    let side = word.parse().ok().filter(|&side| side > 0);
    side.ok_or_else(|| Unreadable::Bad(format!("has a side of {word:?} pixels")))
}
