//! Whether two pictures are near enough to pass, for graders.

use std::str::FromStr;

use clap::Args;

use super::difference::Difference;
use crate::whole::whole;

/// What passes.
#[derive(Args, Debug)]
pub(super) struct Options {
    /// Let pixels pass whose 8-bit levels differ by no more than that, 0 to 255
    ///
    /// PFM are quantised with the linear transfer for it. Without it all pixels count that
    /// differ at all, of PFM in a single bit.
    #[arg(long, value_name = "LEVELS", allow_negative_numbers = true,
          value_parser = whole::<0, 255>)]
    tolerance: Option<u32>,

    /// Let so many pixels be off, as a number or as a part of all, such as 0.1% [default: 0]
    #[arg(long, value_name = "PIXELS", allow_hyphen_values = true)]
    allow: Option<Allow>,
}

/// Pixels that may be off.
#[derive(Clone, Copy, Debug, PartialEq)]
enum Allow {
    Pixels(u64),
    /// Per cent of all pixels, from 0 to 100.
    Percent(f64),
}

impl FromStr for Allow {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let digits = |text: &str| text.bytes().all(|b| b.is_ascii_digit() || b == b'.');
        let read = match text.strip_suffix('%') {
            Some(part) if digits(part) => {
                part.parse().ok().filter(|part| *part <= 100.0).map(Self::Percent)
            }
            None if digits(text) => text.parse().ok().map(Self::Pixels),
            _ => None,
        };
        read.ok_or("allowed is a whole number of pixels, or a part of all from 0% to 100%")
    }
}

/// What the options make of a difference.
#[derive(Debug)]
pub(super) struct Verdict {
    /// Pixels that count.
    pub(super) counted: u64,
    /// How many of them pass.
    pub(super) allowed: u64,
    pub(super) passed: bool,
}

impl Options {
    pub(super) fn tolerance(&self) -> Option<u8> {
        self.tolerance.and_then(|levels| levels.try_into().ok())
    }

    /// Whether a verdict is asked for beyond equal or not.
    pub(super) fn asked(&self) -> bool {
        self.tolerance.is_some() || self.allow.is_some()
    }

    pub(super) fn verdict(&self, difference: &Difference) -> Verdict {
        let counted = match self.tolerance() {
            Some(levels) => difference.level_pixels_over(levels),
            None => difference.pixels,
        };
        let allowed = match self.allow {
            None => 0,
            Some(Allow::Pixels(pixels)) => pixels,
            Some(Allow::Percent(part)) => {
                let all = f64::from(difference.width) * f64::from(difference.height);
                (part * all / 100.0) as u64
            }
        };
        Verdict { counted, allowed, passed: counted <= allowed }
    }
}

#[cfg(test)]
mod tests {
    use super::Allow;

    #[test]
    fn pixels_or_percent() {
        assert_eq!("0".parse(), Ok(Allow::Pixels(0)));
        assert_eq!("4294836225".parse(), Ok(Allow::Pixels(4_294_836_225)));
        assert_eq!("0.1%".parse(), Ok(Allow::Percent(0.1)));
        assert_eq!("100%".parse(), Ok(Allow::Percent(100.0)));
        for refused in ["", "%", ".", "-1", "+1", "1.5", "100.1%", "-1%", "nan%", "1e1%", "1 %"] {
            assert!(refused.parse::<Allow>().is_err(), "{refused}");
        }
    }
}
