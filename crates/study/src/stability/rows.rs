//! The suite's findings as rows: verdicts in one table; in another, in words, what the cases
//! are, so that lines stay short.

use catoptric_report::{Cell, Column, Table};

use super::cases::refusals::Refusal;
use super::finding::Finding;
use super::suite::{held_to, verdict};
use crate::formula::Formula;

const COLUMNS: &[Column] = &[
    Column { key: "case", heading: "case", meaning: "its name in the table of bounds" },
    Column { key: "formula", heading: "formula", meaning: "formulas and arithmetic" },
    Column { key: "verdict", heading: "verdict", meaning: "the measured value against the bound" },
    Column { key: "measured", heading: "measured", meaning: "in the unit of the quantity" },
    Column { key: "bound", heading: "bound", meaning: "the largest value that holds" },
    Column { key: "sentence", heading: "what was seen", meaning: "what was seen beside it" },
];

const CASES: &[Column] = &[
    Column { key: "case", heading: "case", meaning: "its name" },
    Column { key: "part", heading: "", meaning: "which of the words below" },
    Column {
        key: "words",
        heading: "words",
        meaning: "what is tested, with its parameters; what is measured, with its unit; where the \
                  bound comes from; why it is this one; why a formula is known to fail",
    },
];

/// The suite's findings: the verdicts, and what the cases are.
pub(crate) struct Rows {
    pub(crate) verdicts: Table,
    pub(crate) cases: Table,
}

impl Rows {
    pub(crate) fn new() -> Self {
        let verdicts = "Every case with every formula. Failures are listed.";
        let cases = "What the cases test, and what they are held to.";
        Self {
            verdicts: Table::new("suite", COLUMNS, verdicts),
            cases: Table::new("cases", CASES, cases),
        }
    }

    /// Adds a finding.
    pub(crate) fn push(&mut self, finding: Finding) {
        let verdict = verdict(&finding);
        let (group, case) = held_to(&finding);
        let (most, known) = case.of(finding.formula);
        let name = finding.formula.map_or("any", Formula::name);
        let mut say = |part: String, words: &str| {
            let row = [Cell::from(finding.case), part.into(), words.into()];
            if !self.cases.rows.contains(&row.to_vec()) {
                self.cases.push(row);
            }
        };
        say("tested".to_owned(), &finding.tested);
        say("measured".to_owned(), group.quantity);
        say("source".to_owned(), group.source);
        say("why".to_owned(), group.why);
        if let Some(known) = known {
            say(format!("{name} fails"), known);
        }
        self.verdicts.push([
            finding.case.into(),
            name.into(),
            verdict.text().into(),
            number(finding.measured),
            most.into(),
            finding.sentence.into(),
        ]);
    }
}

/// A number, or in words what JSON would have no number for.
fn number(measured: f64) -> Cell {
    if measured.is_finite() { measured.into() } else { format!("not finite: {measured}").into() }
}

const REFUSALS: &[Column] = &[
    Column { key: "stated", heading: "stated", meaning: "the key and its value" },
    Column { key: "named", heading: "named", meaning: "whether the error names that key" },
    Column { key: "message", heading: "message", meaning: "the error's text" },
];

/// Every input of the case `refusals`, with its message.
pub(crate) fn refusals(refusals: Vec<Refusal>) -> Table {
    let mut table =
        Table::new("refusals", REFUSALS, "What is not a scene, and what is said of it.");
    for Refusal { stated, message, named } in refusals {
        table.push([stated.into(), if named { "yes" } else { "NO" }.into(), message.into()]);
    }
    table
}
