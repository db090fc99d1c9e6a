//! Sizes in bytes, as the command line and messages state them.

use std::fmt;
use std::str::FromStr;

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
    /// Writes the size in the largest binary unit it reaches, rounded up to a tenth: "1.6 MiB".
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
