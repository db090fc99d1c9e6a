//! What a case of the suite is asked for, and what it finds.

use crate::formula::Formula;

/// How much is measured. The suite's own sizes by default.
#[derive(Clone, Copy, Debug)]
pub struct Effort {
    /// Drafts of extreme input, of which 44 % are scenes.
    pub scenes: u64,
    /// Rays for each parameter of the cases that shoot single rays.
    pub rays: u64,
}

impl Default for Effort {
    fn default() -> Self {
        Self { scenes: 230_000, rays: 2_000 }
    }
}

/// What one case found for one formula.
#[derive(Clone, Debug)]
pub struct Finding {
    /// The case's name in [`super::bounds::GROUPS`].
    pub case: &'static str,
    /// The formula that was used; `None` where none is asked yet, in validation.
    pub formula: Option<Formula>,
    /// What is tested, with its parameters.
    pub tested: String,
    /// The measured value.
    pub measured: f64,
    /// One sentence: what was seen beside it.
    pub sentence: String,
}

/// Collects the findings of one experiment.
pub(crate) struct Findings {
    all: Vec<Finding>,
}

impl Findings {
    pub(crate) fn new() -> Self {
        Self { all: Vec::new() }
    }

    /// A measured value.
    pub(crate) fn push(
        &mut self,
        case: &'static str,
        formula: impl Into<Option<Formula>>,
        tested: &str,
        measured: f64,
        sentence: String,
    ) {
        let (formula, tested) = (formula.into(), tested.to_owned());
        self.all.push(Finding { case, formula, tested, measured, sentence });
    }

    pub(crate) fn done(self) -> Vec<Finding> {
        self.all
    }
}
