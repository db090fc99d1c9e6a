//! Sizes in bytes, and what a rendering will take.

use std::fmt;
use std::str::FromStr;

use crate::exit::Failure;
use crate::format::Format;
use crate::machine;

/// A number of bytes.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct Size(pub(crate) u64);

/// Suffixes and their factors, in lower case; a suffix stands before its own endings.
const UNITS: [(&str, u64); 10] = [
    ("kib", 1 << 10),
    ("mib", 1 << 20),
    ("gib", 1 << 30),
    ("kb", 1_000),
    ("mb", 1_000_000),
    ("gb", 1_000_000_000),
    ("k", 1_000),
    ("m", 1_000_000),
    ("g", 1_000_000_000),
    ("b", 1),
];

/// What [`Size::from_str`] accepts.
const ALLOWED: &str = "allowed is a whole number of bytes above 0, plain or with K, M, G (powers of 1000) or KiB, MiB, GiB (powers of 1024)";

impl FromStr for Size {
    type Err = &'static str;

    fn from_str(text: &str) -> Result<Self, Self::Err> {
        let lower = text.trim().to_ascii_lowercase();
        let suffixed = |&(unit, factor): &(&str, u64)| Some((lower.strip_suffix(unit)?, factor));
        let (digits, factor) = UNITS.iter().find_map(suffixed).unwrap_or((&lower, 1));
        let digits = digits.trim_end();
        // `parse` would accept a plus sign.
        let plain = digits.bytes().all(|b| b.is_ascii_digit());
        let number = if plain { digits.parse::<u64>().ok() } else { None };
        let bytes = number.and_then(|n| n.checked_mul(factor)).filter(|&bytes| bytes > 0);
        bytes.map(Self).ok_or(ALLOWED)
    }
}

impl fmt::Display for Size {
    /// In the largest binary unit that it reaches, rounded up to a tenth: "1.6 MiB".
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let units = [("GiB", 30), ("MiB", 20), ("KiB", 10)];
        let Some((name, shift)) = units.into_iter().find(|&(_, shift)| self.0 >> shift > 0) else {
            return write!(f, "{} bytes", self.0);
        };
        let tenths = (u128::from(self.0) * 10).div_ceil(1 << shift);
        match tenths % 10 {
            0 => write!(f, "{} {name}", tenths / 10),
            tenth => write!(f, "{}.{tenth} {name}", tenths / 10),
        }
    }
}

/// Bytes that the program takes beside what is counted: its code, stacks, tiles and buffers.
const OWN: u64 = 16 << 20;

/// What a rendering is made of, as far as its memory goes. What a thread keeps of a tile, and its
/// stack, are not part of it.
pub(crate) struct Need {
    /// Columns of what is rendered.
    pub(crate) width: u32,
    /// Rows of what is rendered.
    pub(crate) height: u32,
    /// Samples a side.
    pub(crate) samples: u32,
    /// How it is written.
    pub(crate) format: Format,
    /// Whether there is a film, and not 8-bit levels from the first.
    pub(crate) film: bool,
    /// The scene's text and what is made of it, in bytes.
    pub(crate) scene: u64,
}

impl Need {
    /// Bytes at most: the picture, the scene and the grid.
    fn bytes(&self) -> u64 {
        let (width, height) = (u64::from(self.width), u64::from(self.height));
        let picture = self.format.bytes(self.width, self.height, self.film);
        let grid = (width + height) * u64::from(self.samples) * 4;
        picture + grid + self.scene
    }

    /// What is left of the limit: bytes for the stacks of deep paths, and how to have more.
    ///
    /// # Errors
    /// Exit code 3 if the limit is not enough, or the memory of the system or of its control
    /// group. Nothing has been taken then.
    pub(crate) fn within(&self, limit: Size) -> Result<(u64, &'static str), Failure> {
        let need = self.bytes();
        let refused = |why: fmt::Arguments<'_>| {
            let (width, height, size) = (self.width, self.height, Size(need));
            Failure::bad_input(format_args!(
                "a picture of {width}x{height} needs {size} of memory ({need} bytes), {why} render parts with --crop"
            ))
        };
        // First, since no larger limit of the program's own would help.
        let granted_by_group = match machine::memory_left() {
            None => u64::MAX,
            Some(left) => left.saturating_sub(OWN).checked_sub(need).ok_or_else(|| {
                let left = Size(left.saturating_sub(OWN));
                refused(format_args!(
                    "of which the memory cgroup leaves {left}: raise its limit, or"
                ))
            })?,
        };
        let left = limit.0.checked_sub(need).ok_or_else(|| {
            refused(format_args!("the limit is {limit}: raise --memory-limit, or"))
        })?;
        if !granted(need) {
            return Err(refused(format_args!("which the system does not grant:")));
        }
        Ok(match granted_by_group < left {
            true => (granted_by_group, "raise the limit of the memory cgroup"),
            false => (left, "raise --memory-limit"),
        })
    }
}

/// Whether the system has room for so many bytes. They are asked for and given back
/// untouched; what fails later, when they are taken in earnest, ends the program.
pub(crate) fn granted(bytes: u64) -> bool {
    let bytes = usize::try_from(bytes).unwrap_or(usize::MAX);
    // Seen from outside, or the compiler would leave out what is given back at once.
    std::hint::black_box(Vec::<u8>::new()).try_reserve_exact(bytes).is_ok()
}

#[cfg(test)]
mod tests {
    use super::Size;

    #[test]
    fn sizes_are_read() {
        let cases = [
            ("1", 1),
            ("5000", 5_000),
            ("3b", 3),
            ("2K", 2_000),
            ("2kB", 2_000),
            ("2KiB", 2_048),
            ("7M", 7_000_000),
            ("7 MiB", 7 << 20),
            ("3G", 3_000_000_000),
            ("2GiB", 2 << 30),
            ("18446744073709551615", u64::MAX),
        ];
        for (text, bytes) in cases {
            assert_eq!(text.parse(), Ok(Size(bytes)), "{text}");
        }
        let refused =
            ["", "0", "0K", "K", "-1", "+1", "1.5G", "1T", "18446744073709551616", "20000000000G"];
        for text in refused {
            assert!(text.parse::<Size>().is_err(), "{text}");
        }
    }

    #[test]
    fn sizes_are_shown_rounded_up() {
        let cases = [
            (1_023, "1023 bytes"),
            (1_024, "1 KiB"),
            (1_025, "1.1 KiB"),
            (2 << 30, "2 GiB"),
            (51_539_607_552, "48 GiB"),
            (1_587_200, "1.6 MiB"),
        ];
        for (bytes, text) in cases {
            assert_eq!(Size(bytes).to_string(), text);
        }
    }
}
