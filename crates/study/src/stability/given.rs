//! The suite's measures of pictures, for scenes that somebody gave, and the same criterion.
//!
//! The robust formulas are held to it, the textbook's are only measured.

use catoptric_report::{Cell, Column, Table};
use catoptric_scene::Scene;

use super::backward::{Backward, Judge, passes};
use super::cases::edges::{brightest, outside};
use crate::formula::Formula;

const COLUMNS: &[Column] = &[
    Column { key: "scene", heading: "scene", meaning: "as it was named" },
    Column { key: "formula", heading: "formula", meaning: "formulas and arithmetic" },
    Column {
        key: "verdict",
        heading: "verdict",
        meaning: "holds: backward by all input at most 4, every value finite, every pixel in [0, B]",
    },
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
        key: "outside",
        heading: "not in [0, B]",
        meaning: "pixels beyond what the scene's light allows",
    },
    Column {
        key: "backward_by_eye",
        heading: "backward, eye ray",
        meaning: "largest ratio of error to max(spread, floor), truth moved by its eye rays",
    },
    Column {
        key: "backward_by_input",
        heading: "backward, input",
        meaning: "the same, truth moved by its eye rays and 64 times by all its input",
    },
    Column {
        key: "beyond",
        heading: "beyond",
        meaning: "pixels that are above 4 by all input; not counted above a ratio of 1000",
    },
    Column { key: "sentence", heading: "what was seen", meaning: "why the verdict is this one" },
];

/// An empty table of them.
pub(crate) fn table() -> Table {
    let caption = "Each picture against truth in double-double. Held to: backward ratio by all input at most 4, in u of the formula's arithmetic; every value finite; every pixel in [0, B]. An ill-conditioned scene may have a large difference and a small ratio.";
    Table::new("scenes", COLUMNS, caption)
}

/// Adds a row for each formula; says whether a robust one fails.
pub(crate) fn measure(table: &mut Table, name: &str, scene: &Scene) -> bool {
    let judge = &Judge::new(scene).map_err(|error| error.to_string());
    let mut failed = false;
    for formula in Formula::ALL {
        // A picture is judged only if truth and the picture can both be computed.
        let judged = judge.as_ref().map_err(String::clone).and_then(|judge| {
            let picture = formula.picture(scene).map_err(|error| error.to_string())?;
            let outside = outside(&picture, brightest(&formula.scene(scene)));
            let found = judge.judge_as(formula, &picture).map_err(|error| error.to_string())?;
            Ok((found, outside))
        });
        match judged {
            Ok((found, outside)) => {
                let Backward { by_eye, by_input, beyond, raw } = found;
                let seen = seen(&found, outside);
                let holds = seen.is_empty();
                // The textbook's formulas are known to fail; that does not fail the study.
                let known = formula == Formula::TextbookF32;
                failed |= !holds && !known;
                let (verdict, sentence) = match (holds, known) {
                    (true, _) => ("holds", "The true picture of a scene nearly as stated.".into()),
                    (false, true) => {
                        ("fails as known", format!("The textbook's formulas: {seen}."))
                    }
                    (false, false) => ("FAILS", format!("{seen}.")),
                };
                table.push([
                    name.into(),
                    formula.name().into(),
                    verdict.into(),
                    raw.max.into(),
                    raw.rmse.into(),
                    raw.p999.into(),
                    raw.off.into(),
                    raw.off_by_more.into(),
                    raw.not_finite.into(),
                    outside.into(),
                    by_eye.into(),
                    by_input.into(),
                    beyond.map(|[_, by_input]| by_input).into(),
                    sentence.into(),
                ]);
            }
            Err(error) => table.push(not_measured(name, formula, &error)),
        }
    }
    failed
}

/// What is not as it must be, in words; nothing if all is. NaN is not.
fn seen(found: &Backward, outside: u64) -> String {
    let mut seen = Vec::new();
    if !passes(found.by_input) {
        seen.push(found.beyond());
    }
    if found.raw.not_finite > 0 {
        seen.push(format!("{} values are not finite", found.raw.not_finite));
    }
    if outside > 0 {
        seen.push(format!("{outside} pixels are not in [0, B]"));
    }
    seen.join("; ")
}

fn not_measured(name: &str, formula: Formula, error: &str) -> [Cell; 14] {
    let mut cells: [Cell; 14] = std::array::from_fn(|_| Cell::Nothing);
    cells[0] = name.into();
    cells[1] = formula.name().into();
    cells[2] = "not measured".into();
    cells[13] = format!("Not measured: {error}.").into();
    cells
}
