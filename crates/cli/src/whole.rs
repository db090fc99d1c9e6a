//! Whole numbers of the command line.

/// A whole number from `LEAST` to `MOST`, as clap's `value_parser`.
pub(crate) fn whole<const LEAST: u32, const MOST: u32>(text: &str) -> Result<u32, String> {
    let number = text.parse().ok().filter(|number| (LEAST..=MOST).contains(number));
    number.ok_or_else(|| format!("allowed is a whole number from {LEAST} to {MOST}"))
}
