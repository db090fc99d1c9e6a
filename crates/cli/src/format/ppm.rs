//! PPM: `P6\nWIDTH HEIGHT\n255\n`, then three bytes a pixel from the top left. Its sisters are
//! only read: P5 has one byte a pixel, P3 and P2 have the same numbers as text.

use std::io::{self, Write};

use super::header::Header;
use super::picture::Levels;
use super::source::Source;
use super::unreadable::Unreadable;

pub(super) fn write(levels: &Levels, to: &mut dyn Write) -> io::Result<()> {
    write!(to, "P6\n{} {}\n255\n", levels.width, levels.height)?;
    to.write_all(levels.pixels.as_flattened())
}

/// A PPM or PGM whose header has been read.
pub(super) struct Pixels {
    from: Source,
    pub(super) header: Header,
    /// One for grey, three for RGB.
    channels: u64,
    text: bool,
}

impl Pixels {
    pub(super) fn open(mut from: Source) -> Result<Self, Unreadable> {
        let kind = from.magic()[1];
        let (channels, text) = (if b"36".contains(&kind) { 3 } else { 1 }, b"23".contains(&kind));
        let header = Header::read(&mut from)?;
        match header.third.as_str() {
            "255" => {}
            other => {
                return Err(Unreadable::Other(format!(
                    "has the largest value {other:?}: only 8-bit pictures, with 255, can be compared"
                )));
            }
        }
        if !text {
            header.check_length(&from, channels)?;
        } else if let Some(left) = from.left() {
            // A digit and a blank each, at least; the last one needs no blank.
            let least = u128::from(header.pixels()) * u128::from(channels) * 2 - 1;
            if u128::from(left) < least {
                return Err(header.wrong_length(&left.to_string(), least));
            }
        }
        Ok(Self { from, header, channels, text })
    }

    /// Bytes that reading takes.
    pub(super) fn bytes(&self) -> u64 {
        self.header.pixels().saturating_mul(3)
    }

    pub(super) fn read(mut self) -> Result<Levels, Unreadable> {
        let mut levels = Levels::new(self.header.width, self.header.height);
        let to = levels.pixels.as_flattened_mut();
        let values = (self.header.pixels() * self.channels) as usize;
        if self.text {
            numbers(&mut self.from, &mut to[..values])?;
        } else {
            self.header.fill(&mut self.from, &mut to[..values])?;
            self.header.end(&mut self.from, values as u64)?;
        }
        if self.channels == 1 {
            spread_grey(to);
        }
        Ok(levels)
    }
}

/// Turns grey values, which fill the first third, into RGB in the same place.
pub(super) fn spread_grey(levels: &mut [u8]) {
    // From the end, so that no value is overwritten before it is read.
    for pixel in (0..levels.len() / 3).rev() {
        let grey = levels[pixel];
        levels[3 * pixel..3 * pixel + 3].fill(grey);
    }
}

/// Reads levels as text, separated by blanks and comments, and nothing after them.
fn numbers(from: &mut Source, to: &mut [u8]) -> Result<(), Unreadable> {
    let expected = to.len();
    for (index, to) in to.iter_mut().enumerate() {
        let Some(number) = number(from)? else {
            return Err(Unreadable::Bad(format!(
                "has {index} numbers of pixels where {expected} are expected"
            )));
        };
        *to = number;
    }
    match number(from)? {
        None => Ok(()),
        Some(_) => Err(Unreadable::Bad(format!(
            "has more than the {expected} numbers of pixels that are expected"
        ))),
    }
}

/// The next number and one byte after it; `None` at the end.
fn number(from: &mut Source) -> Result<Option<u8>, Unreadable> {
    let mut number: Option<u32> = None;
    loop {
        let mut byte = from.byte()?;
        // A comment stands for the line's end that it runs to.
        if byte == Some(b'#') {
            while !matches!(byte, None | Some(b'\n')) {
                byte = from.byte()?;
            }
        }
        match byte {
            Some(digit @ b'0'..=b'9') => {
                let value = number.unwrap_or(0) * 10 + u32::from(digit - b'0');
                if value > 255 {
                    let what = "has a number of pixels above 255, its largest value";
                    return Err(Unreadable::Bad(what.to_owned()));
                }
                number = Some(value);
            }
            Some(blank) if blank.is_ascii_whitespace() => {
                if number.is_some() {
                    return Ok(number.map(|number| number as u8));
                }
            }
            None => return Ok(number.map(|number| number as u8)),
            Some(other) => {
                let other = char::from(other);
                return Err(Unreadable::Bad(format!("has {other:?} among its numbers of pixels")));
            }
        }
    }
}
