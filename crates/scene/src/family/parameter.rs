//! Parameters and their ranges.

use std::ops::RangeInclusive;

use crate::error::number;

/// Most spheres of one scene; mirrors, floors and walls come on top. A draft of this many takes
/// about 40 MB.
pub const MOST_BALLS: u32 = 1_000_000;

/// A parameter that is out of its range: which, what was found, what is allowed.
#[derive(Clone, Debug, PartialEq, Eq, thiserror::Error)]
#[error("{parameter}: found {found}; allowed: {allowed}")]
pub struct OutOfRange {
    /// The field of the family's struct.
    pub parameter: &'static str,
    /// The value found.
    pub found: String,
    /// The range, in words.
    pub allowed: String,
}

/// Checks that a number is in its range; NaN never is.
pub(super) fn real(
    parameter: &'static str,
    found: f64,
    allowed: RangeInclusive<f64>,
) -> Result<(), OutOfRange> {
    if allowed.contains(&found) {
        return Ok(());
    }
    let (least, most) = (number(*allowed.start()), number(*allowed.end()));
    let allowed = format!("a number from {least} to {most}");
    Err(OutOfRange { parameter, found: number(found), allowed })
}

/// Checks that a count is in its range.
pub(super) fn count(
    parameter: &'static str,
    found: u32,
    allowed: RangeInclusive<u32>,
) -> Result<(), OutOfRange> {
    if allowed.contains(&found) {
        return Ok(());
    }
    let allowed = format!("an integer from {} to {}", allowed.start(), allowed.end());
    Err(OutOfRange { parameter, found: found.to_string(), allowed })
}

/// Checks a number of spheres: from `least` to [`MOST_BALLS`].
pub(super) fn balls(parameter: &'static str, found: u32, least: u32) -> Result<(), OutOfRange> {
    count(parameter, found, least..=MOST_BALLS)
}

/// Checks the factor of a mirror: from 0 to 1.
pub(super) fn reflect(found: f64) -> Result<(), OutOfRange> {
    real("reflect", found, 0.0..=1.0)
}
