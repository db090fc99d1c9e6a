//! What a case showed, and what theory foretells of it.

use crate::stability::paths::Arithmetic;

/// An error above it, in the case's units, is a lost path.
pub const LOST: f64 = 1e-3;

/// What one case showed.
#[derive(Clone, Debug)]
pub struct Growth {
    /// The case's name.
    pub name: String,
    /// Growth per bounce by a closed form, where there is one.
    pub closed: Option<f64>,
    /// Growth per bounce along truth's paths to first order: the median over the paths.
    pub transported: Option<f64>,
    /// Growth per bounce between truth's paths and nudged ones: the median over the paths.
    pub nudged: Option<f64>,
    /// Entry n: truth's paths that have a hit at bounce n.
    pub living: Vec<usize>,
    /// Median errors by arithmetic, in units; entry n is at bounce n. Ends where fewer than
    /// [`super::LEAST_PATHS`] live.
    pub errors: Vec<(Arithmetic, Vec<f64>)>,
}

impl Growth {
    /// The first bounce at which an arithmetic has lost the path; `None` if it never did.
    #[must_use]
    pub fn lost(&self, arithmetic: Arithmetic) -> Option<usize> {
        let (_, medians) = self.errors.iter().find(|(a, _)| *a == arithmetic)?;
        medians.iter().position(|median| *median > LOST)
    }

    /// The bounce at which theory loses the path: 2^-p Lambda^n = [`LOST`] at
    /// n = (p ln 2 + ln LOST)/ln Lambda, with the closed form, or else the growth to first order.
    /// `None` where errors do not grow.
    #[must_use]
    pub fn foretold(&self, arithmetic: Arithmetic) -> Option<f64> {
        let lambda = self.lambda().filter(|lambda| *lambda > 1.0)?;
        let digits = f64::from(arithmetic.bits()) * std::f64::consts::LN_2 + LOST.ln();
        Some(digits / lambda.ln())
    }

    /// Whether both measured growths are the closed form within 1e-6 of it; `None` without one.
    #[must_use]
    pub fn holds(&self) -> Option<bool> {
        let closed = self.closed?;
        let is = |found: Option<f64>| found.is_some_and(|x| (x / closed - 1.0).abs() < 1e-6);
        Some(is(self.transported) && is(self.nudged))
    }

    /// The growth that theory uses.
    #[must_use]
    pub fn lambda(&self) -> Option<f64> {
        self.closed.or(self.transported)
    }
}
