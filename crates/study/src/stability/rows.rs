//! The suite's findings as rows.

use super::cases::refusals::Refusal;
use super::suite::{Finding, Verdict, held_to, verdict};
use crate::formula::Formula;
use crate::report::{Cell, Column, Table};

const COLUMNS: &[Column] = &[
    Column { key: "case", heading: "case", meaning: "its name in the table of bounds" },
    Column { key: "formula", heading: "formula", meaning: "formulas and arithmetic" },
    Column { key: "verdict", heading: "verdict", meaning: "the measured value against the bound" },
    Column { key: "measured", heading: "measured", meaning: "in the unit of the quantity" },
    Column { key: "bound", heading: "bound", meaning: "the largest value that holds" },
    Column { key: "quantity", heading: "quantity", meaning: "what is measured, with its unit" },
    Column {
        key: "sentence",
        heading: "what was seen",
        meaning: "what was seen beside it; why it fails",
    },
    Column { key: "tested", heading: "tested", meaning: "what is tested, with its parameters" },
    Column { key: "source", heading: "source", meaning: "where the bound comes from" },
    Column { key: "why", heading: "why", meaning: "why the bound is this one" },
];

/// An empty table of findings.
pub(crate) fn table() -> Table {
    Table::new("suite", COLUMNS, "Every case with every formula. Failures are listed.")
}

/// Adds a finding.
pub(crate) fn push(table: &mut Table, finding: Finding) {
    let verdict = verdict(&finding);
    let (group, case) = held_to(&finding);
    let (most, _) = case.of(finding.formula);
    let sentence = match verdict {
        Verdict::FailsAsKnown(text) => format!("{text} {}", finding.sentence),
        _ => finding.sentence,
    };
    table.push([
        finding.case.into(),
        finding.formula.map_or("any", Formula::name).into(),
        verdict.text().into(),
        number(finding.measured),
        most.into(),
        group.quantity.into(),
        sentence.into(),
        finding.tested.into(),
        group.source.into(),
        group.why.into(),
    ]);
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
