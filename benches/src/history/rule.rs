//! Whether the last line of a scene is worse than the noise.
//!
//! The rule. A line is compared with the last [`WINDOW`] earlier lines of the same work (scene,
//! size, depth, threads, rays) on the same processor and instruction set, of which there must be
//! [`NEEDED`]. The margin is the largest spread among all of them, the judged line included, but at
//! least [`LEAST_MARGIN`]; above [`LARGEST_MARGIN`] nothing can be said. A line is worse when its
//! speed-up over the recursion on the same number of threads lies below
//!
//! ```text
//! least earlier speed-up · (1 - margin)
//! ```
//!
//! both as formed from minima and as formed from medians: a disturbed run rarely lowers the
//! two together.

use std::fmt;

use super::entry::Entry;

/// Earlier lines compared with.
pub const WINDOW: usize = 5;

/// Earlier lines without which nothing is said.
pub const NEEDED: usize = 2;

/// What repeated runs differ by even where the rounds of each agree.
pub const LEAST_MARGIN: f64 = 0.03;

/// Noise under which a loss that matters would disappear.
pub const LARGEST_MARGIN: f64 = 0.25;

/// What the rule says of a line.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Verdict {
    /// Within the noise or better.
    Fine(Limits),
    /// Both speed-ups are below their limits.
    Worse(Limits),
    /// The spread passes [`LARGEST_MARGIN`].
    TooNoisy(f64),
    /// So many lines to compare with, fewer than [`NEEDED`].
    TooLittle(usize),
    /// Earlier lines of this work exist, all from other processors or instruction sets.
    OtherMachine,
}

/// What the speed-ups must reach.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Limits {
    /// For the one formed from minima.
    pub min: f64,
    /// For the one formed from medians.
    pub median: f64,
    /// The margin taken off, as a share.
    pub margin: f64,
    /// Lines compared with.
    pub lines: usize,
}

/// The last line of each scene, in the order in which scenes first appear, and its verdict.
#[must_use]
pub fn judge_all(history: &[Entry]) -> Vec<(&Entry, Verdict)> {
    let mut scenes: Vec<&str> = Vec::new();
    for entry in history {
        if !scenes.contains(&entry.scene.as_str()) {
            scenes.push(&entry.scene);
        }
    }
    let last = |scene| history.iter().rposition(|entry| entry.scene == scene);
    let last = scenes.into_iter().filter_map(last);
    last.map(|i| (&history[i], judge(&history[..i], &history[i]))).collect()
}

/// The rule on one line and all lines before it.
#[must_use]
pub fn judge(earlier: &[Entry], line: &Entry) -> Verdict {
    let same_work = earlier.iter().filter(|e| e.same_work(line));
    let comparable = same_work.clone().filter(|e| e.same_machine(line));
    let window: Vec<&Entry> = comparable.rev().take(WINDOW).collect();
    if window.is_empty() && same_work.count() > 0 {
        return Verdict::OtherMachine;
    }
    if window.len() < NEEDED {
        return Verdict::TooLittle(window.len());
    }
    let spreads = window.iter().map(|e| e.over_same_spread);
    let margin = spreads.fold(line.over_same_spread.max(LEAST_MARGIN), f64::max);
    if margin > LARGEST_MARGIN {
        return Verdict::TooNoisy(margin);
    }
    let least = |of: fn(&Entry) -> f64| window.iter().map(|e| of(e)).fold(f64::INFINITY, f64::min);
    let limits = Limits {
        min: least(|e| e.over_same_min) * (1.0 - margin),
        median: least(|e| e.over_same_median) * (1.0 - margin),
        margin,
        lines: window.len(),
    };
    if line.over_same_min < limits.min && line.over_same_median < limits.median {
        Verdict::Worse(limits)
    } else {
        Verdict::Fine(limits)
    }
}

impl fmt::Display for Verdict {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Fine(limits) => write!(f, "not worse than the noise ({limits})"),
            Self::Worse(limits) => write!(f, "WORSE than the noise ({limits})"),
            Self::TooNoisy(margin) => write!(
                f,
                "not judged: a spread of {:.1}% is above {:.0}%, record on a quieter machine",
                100.0 * margin,
                100.0 * LARGEST_MARGIN
            ),
            Self::TooLittle(found) => {
                write!(f, "not judged: {found} earlier lines to compare with, {NEEDED} are needed")
            }
            Self::OtherMachine => write!(
                f,
                "not judged: all earlier lines are from another processor or instruction set"
            ),
        }
    }
}

impl fmt::Display for Limits {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (min, median, margin) = (self.min, self.median, 100.0 * self.margin);
        let lines = self.lines;
        write!(f, "limits {min:.2} min, {median:.2} median: {margin:.1}% below {lines} lines")
    }
}
