//! The report: one structure, as text and as JSON.

use std::fmt;

use catoptric_scene::shown;
use serde::Serialize;

use super::difference::{Difference, First, Pair, Values, ulps};
use super::options::Options;
use super::verdict::Verdict;
use crate::exit::NAME;
use crate::input;

/// What `compare` says. Every key is always there.
#[derive(Debug, Serialize)]
pub(super) struct Report {
    /// `catoptric-compare`.
    schema: &'static str,
    /// Grows when a key changes its meaning or goes.
    version: u32,
    a: String,
    b: String,
    width: u32,
    height: u32,
    /// `levels` (0 to 255) or `linear` (f32): also the unit of `max` and `rmse`.
    values: &'static str,
    equal: bool,
    /// Pixels that differ.
    pixels: u64,
    /// The first that does, row by row from the top left; null where none does.
    first: Option<FirstPixel>,
    /// Largest absolute difference of a channel.
    max: f64,
    /// Root mean square difference over all channels.
    rmse: f64,
    /// Channels that `max` and `rmse` leave out, since one side is infinite or NaN.
    not_finite: u64,
    /// Pixels whose 8-bit levels differ (f32: quantised with the linear transfer).
    level_pixels: u64,
    /// Pixels whose levels differ by more than one.
    level_pixels_over_one: u64,
    /// `--tolerance`; null where it was not given.
    tolerance: Option<u8>,
    /// Pixels that count against the verdict: those whose levels differ by more than the
    /// tolerance; without one, all that differ.
    pixels_counted: u64,
    /// How many of them pass.
    pixels_allowed: u64,
    /// Whether no more count than are allowed: exit code 0, else 1.
    passed: bool,
    /// The difference image; null where none was asked for.
    diff: Option<Diff>,
    /// Whether a verdict was asked for; then the text has one.
    #[serde(skip)]
    judged: bool,
}

/// A pixel and its values. Infinite and NaN values are null; the bits tell them apart.
#[derive(Debug, Serialize)]
struct FirstPixel {
    x: u32,
    y: u32,
    a: [f32; 3],
    b: [f32; 3],
    /// f32 only, otherwise null: bit patterns, and steps from one f32 to the next, null for
    /// NaN.
    a_bits: Option<[String; 3]>,
    b_bits: Option<[String; 3]>,
    ulps: Option<[Option<u32>; 3]>,
}

/// The difference image.
#[derive(Debug, Serialize)]
struct Diff {
    file: String,
    /// Levels in the image for a difference of one unit.
    amplification: f64,
}

impl Report {
    pub(super) fn new(options: &Options, found: &Difference, verdict: &Verdict) -> Self {
        Self {
            schema: "catoptric-compare",
            version: 1,
            a: input::name(&options.a),
            b: input::name(&options.b),
            width: found.width,
            height: found.height,
            values: match found.values {
                Values::Levels => "levels",
                Values::Linear => "linear",
            },
            equal: found.pixels == 0,
            pixels: found.pixels,
            first: found.first.map(FirstPixel::from),
            max: found.largest,
            rmse: found.rmse,
            not_finite: found.not_finite,
            level_pixels: found.level_pixels_over(0),
            level_pixels_over_one: found.level_pixels_over(1),
            tolerance: options.verdict.tolerance(),
            pixels_counted: verdict.counted,
            pixels_allowed: verdict.allowed,
            passed: verdict.passed,
            diff: options.diff.as_ref().map(|file| Diff {
                file: file.display().to_string(),
                amplification: found.amplification(),
            }),
            judged: options.verdict.asked(),
        }
    }
}

impl From<First> for FirstPixel {
    fn from(First { x, y, values }: First) -> Self {
        match values {
            Pair::Levels(a, b) => Self {
                x,
                y,
                a: a.map(f32::from),
                b: b.map(f32::from),
                a_bits: None,
                b_bits: None,
                ulps: None,
            },
            Pair::Linear(a, b) => {
                let bits = |v: [f32; 3]| Some(v.map(|x| format!("{:#010x}", x.to_bits())));
                let ulps = std::array::from_fn(|i| ulps(a[i], b[i]));
                Self { x, y, a, b, a_bits: bits(a), b_bits: bits(b), ulps: Some(ulps) }
            }
        }
    }
}

impl fmt::Display for Report {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let all = u64::from(self.width) * u64::from(self.height);
        let size = format_args!("{}x{}, {}", self.width, self.height, self.values);
        let (a, b) = (shown(&self.a, NAME), shown(&self.b, NAME));
        if self.equal {
            writeln!(f, "{a} and {b} are equal ({size})")?;
        } else {
            writeln!(f, "{a} and {b} differ ({size})")?;
            writeln!(f, "pixels that differ     {} of {all}", self.pixels)?;
        }
        // The first pixel that differs, with its bits where the values are linear.
        if let Some(first) = &self.first {
            writeln!(f, "first, from top left   ({}, {})", first.x, first.y)?;
            for (name, values, bits) in
                [("A", first.a, &first.a_bits), ("B", first.b, &first.b_bits)]
            {
                write!(f, "  {name}  {} {} {}", values[0], values[1], values[2])?;
                match bits {
                    Some(bits) => writeln!(f, "  = {}", bits.join(" "))?,
                    None => writeln!(f)?,
                }
            }
            if let Some(ulps) = first.ulps {
                let shown = ulps.map(|n| n.map_or("NaN".to_owned(), |n| n.to_string()));
                writeln!(f, "  ulps apart  {}", shown.join(" "))?;
            }
            // How far apart the pictures are over all pixels.
            writeln!(f, "largest difference     {:.6e}", self.max)?;
            writeln!(f, "RMSE                   {:.6e}", self.rmse)?;
            if self.not_finite > 0 {
                writeln!(
                    f,
                    "  without {} channels that are infinite or NaN on one side",
                    self.not_finite
                )?;
            }
            writeln!(f, "8-bit pixels apart     {}", self.level_pixels)?;
            writeln!(f, "  by more than 1       {}", self.level_pixels_over_one)?;
        }
        // The verdict, where a tolerance was asked for.
        if self.judged {
            let passed = if self.passed { "passed" } else { "failed" };
            let (counted, allowed) = (self.pixels_counted, self.pixels_allowed);
            match self.tolerance {
                Some(levels) => {
                    writeln!(
                        f,
                        "8-bit pixels apart by more than {levels}: {counted}, allowed {allowed}: {passed}"
                    )?;
                }
                None => writeln!(f, "pixels that differ: {counted}, allowed {allowed}: {passed}")?,
            }
        }
        // The difference image, where one was written.
        if let Some(diff) = &self.diff {
            writeln!(
                f,
                "difference image       {}, amplified {:.6}",
                diff.file, diff.amplification
            )?;
        }
        Ok(())
    }
}
