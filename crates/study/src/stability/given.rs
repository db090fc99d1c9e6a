//! The suite's measures of pictures, for scenes that somebody gave.

use catoptric_scene::Scene;

use super::backward::{Backward, Judge};
use crate::formula::Formula;
use crate::report::{Cell, Column, Table};

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "as it was named" },
    Column { key: "formula", heading: "formula", meaning: "formulas and arithmetic" },
    Column { key: "max", heading: "max", meaning: "largest difference of a channel from truth" },
    Column { key: "rmse", heading: "RMSE", meaning: "root of the mean squared difference" },
    Column {
        key: "p999",
        heading: "99.9 %",
        meaning: "99.9th percentile of each pixel's largest difference",
    },
    Column { key: "off", heading: "off", meaning: "pixels whose 8-bit levels differ" },
    Column {
        key: "off_by_more",
        heading: "off by more",
        meaning: "pixels whose levels differ by more than one",
    },
    Column { key: "not_finite", heading: "not finite", meaning: "values that are NaN or infinite" },
    Column {
        key: "backward_by_eye",
        heading: "backward, eye ray",
        meaning: "largest ratio of error to max(spread, 3e-6), truth moved by its eye rays; 4 passes",
    },
    Column {
        key: "backward_by_input",
        heading: "backward, input",
        meaning: "the same, truth moved by all its input; a pixel is looked at until it passes",
    },
    Column {
        key: "beyond",
        heading: "beyond",
        meaning: "pixels that do not pass by all input; not counted above a ratio of 1000",
    },
    Column { key: "note", heading: "", meaning: "why there are no values" },
];

/// An empty table of them.
pub(crate) fn table() -> Table {
    let caption = "Each picture against truth in double-double, and its backward error: an ill-conditioned scene may have a large difference and a small ratio.";
    Table::new("scenes", COLUMNS, caption)
}

/// Adds a row for each formula.
pub(crate) fn measure(table: &mut Table, name: &str, scene: &Scene) {
    let judge = &Judge::new(scene).map_err(|error| error.to_string());
    for formula in Formula::ALL {
        let judged = judge.as_ref().map_err(String::clone).and_then(|judge| {
            let picture = formula.picture(scene).map_err(|error| error.to_string())?;
            judge.judge(&picture).map_err(|error| error.to_string())
        });
        match judged {
            Ok(Backward { by_eye, by_input, beyond, raw }) => table.push([
                name.into(),
                formula.name().into(),
                raw.max.into(),
                raw.rmse.into(),
                raw.p999.into(),
                raw.off.into(),
                raw.off_by_more.into(),
                raw.not_finite.into(),
                by_eye.into(),
                by_input.into(),
                beyond.map(|[_, by_input]| by_input).into(),
                Cell::Nothing,
            ]),
            Err(error) => table.push(not_measured(name, formula, &error)),
        }
    }
}

fn not_measured(name: &str, formula: Formula, error: &str) -> [Cell; 12] {
    let nothing = || Cell::Nothing;
    let [a, b, c, d, e, f, g, h, i] = std::array::from_fn(|_| nothing());
    let note = format!("not measured: {error}");
    [name.into(), formula.name().into(), a, b, c, d, e, f, g, h, i, note.into()]
}
