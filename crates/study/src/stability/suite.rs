//! The cases, and how they are judged.

use super::bounds::{Case, GROUPS, Group};
use super::cases;
use super::finding::{Effort, Finding};

/// How a finding compares with its bound.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Verdict {
    /// Within the bound.
    Holds,
    /// Beyond the bound, for a known reason, which it says.
    FailsAsKnown(&'static str),
    /// Beyond the bound.
    Fails,
    /// Within the bound, though it is listed as a known failure: the table is out of date.
    HoldsNow,
}

impl Verdict {
    /// The verdict as reports write it.
    #[must_use]
    pub fn text(self) -> &'static str {
        match self {
            Self::Holds => "holds",
            Self::FailsAsKnown(_) => "fails as known",
            Self::Fails => "FAILS",
            Self::HoldsNow => "HOLDS, though listed as a known failure",
        }
    }

    /// Whether the table of bounds says so too.
    #[must_use]
    pub fn is_expected(self) -> bool {
        matches!(self, Self::Holds | Self::FailsAsKnown(_))
    }
}

/// Some cases that are measured together.
pub struct Experiment {
    /// The experiment's name, for people who wait.
    pub name: &'static str,
    /// Measures all its cases with every formula.
    pub run: fn(Effort) -> Vec<Finding>,
}

/// All, in the order of the report.
pub const EXPERIMENTS: [Experiment; 10] = [
    Experiment { name: "workshop", run: cases::workshop::run },
    Experiment { name: "large", run: cases::large::run },
    Experiment { name: "distant", run: cases::distant::run },
    Experiment { name: "apart", run: cases::apart::run },
    Experiment { name: "contact", run: cases::contact::run },
    Experiment { name: "invariance", run: cases::invariance::run },
    Experiment { name: "mirrors", run: cases::mirrors::run },
    Experiment { name: "refusals", run: cases::refusals::run },
    Experiment { name: "edges", run: cases::edges::run },
    Experiment { name: "extreme", run: cases::extreme::run },
];

/// What a finding is held to.
///
/// # Panics
/// If the table has no such case.
#[must_use]
pub fn held_to(finding: &Finding) -> (&'static Group, &'static Case) {
    let all = GROUPS.iter().flat_map(|group| group.cases.iter().map(move |case| (group, case)));
    let found = all.into_iter().find(|(_, case)| case.name == finding.case);
    found.unwrap_or_else(|| panic!("no bound for {}", finding.case))
}

/// Compares a finding with its bound. NaN fails.
#[must_use]
pub fn verdict(finding: &Finding) -> Verdict {
    let (most, known) = held_to(finding).1.of(finding.formula);
    match (finding.measured <= most, known) {
        (true, None) => Verdict::Holds,
        (true, Some(_)) => Verdict::HoldsNow,
        (false, Some(text)) => Verdict::FailsAsKnown(text),
        (false, None) => Verdict::Fails,
    }
}
