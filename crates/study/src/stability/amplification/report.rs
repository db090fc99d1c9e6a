//! Growth as rows and curves.

use catoptric_report::{Cell, Column, Plot, Scale, Series, Table};

use super::growth::Growth;
use crate::stability::paths::Arithmetic;

const COLUMNS: &[Column] = &[
    Column { key: "case", heading: "Case", meaning: "The scene; a number is distance/radius." },
    Column {
        key: "lambda_closed",
        heading: "Lambda, closed form",
        meaning: "Growth of an error per bounce on the periodic orbit.",
    },
    Column {
        key: "lambda_transported",
        heading: "transported",
        meaning: "Growth per bounce to first order along truth's paths; median.",
    },
    Column {
        key: "lambda_nudged",
        heading: "nudged",
        meaning: "Growth per bounce of a nudge of 1e-20 in double-double; median.",
    },
    Column { key: "f32", heading: "f32 lost", meaning: LOST },
    Column { key: "f32_foretold", heading: "foretold", meaning: FORETOLD },
    Column { key: "f64", heading: "plain f64 lost", meaning: LOST },
    Column { key: "f64_foretold", heading: "foretold", meaning: FORETOLD },
    Column { key: "dd", heading: "double-double lost", meaning: LOST },
    Column { key: "dd_foretold", heading: "foretold", meaning: FORETOLD },
    Column {
        key: "judged",
        heading: "Bounces judged",
        meaning: "Bounces that enough paths of truth reach.",
    },
    Column {
        key: "verdict",
        heading: "Verdict",
        meaning: "Both measured growths against the closed form: holds within 1e-6 of it.",
    },
];
const LOST: &str =
    "First bounce at which the median error is above 1e-3 radii; 0 is the first hit.";
const FORETOLD: &str = "(p ln 2 + ln 1e-3)/ln Lambda for p bits.";

/// A row a case. An empty cell under "lost": never, within the bounces judged.
#[must_use]
pub fn table(cases: &[Growth]) -> Table {
    let caption = "Growth of errors from mirror to mirror, and the bounce at which a path is lost. Plain f64 is truth's formulas in f64, which can be given an eye ray to 1e-15. Where double-double is lost is foretold by a nudge of 2^-103 that grows in double-double, not measured against more digits.";
    let mut table = Table::new("amplification", COLUMNS, caption);
    for case in cases {
        let f32 = case.errors.first().map_or(Arithmetic::Robust, |(arithmetic, _)| *arithmetic);
        let lost = |a| Cell::from(case.lost(a));
        let foretold = |a| Cell::from(case.foretold(a));
        table.push([
            case.name.clone().into(),
            case.closed.into(),
            case.transported.into(),
            case.nudged.into(),
            lost(f32),
            foretold(f32),
            lost(Arithmetic::F64),
            foretold(Arithmetic::F64),
            lost(Arithmetic::DoubleDouble),
            foretold(Arithmetic::DoubleDouble),
            case.errors.first().map_or(0, |(_, medians)| medians.len()).into(),
            case.holds()
                .map_or("no closed form", |holds| if holds { "holds" } else { "FAILS" })
                .into(),
        ]);
    }
    table
}

/// Error against bounce: a curve for each arithmetic, theory dashed: 2^-p Lambda^n.
#[must_use]
pub fn plot(case: &Growth) -> Plot {
    let mut series = Vec::new();
    for (arithmetic, medians) in &case.errors {
        let points = medians.iter().enumerate().map(|(n, error)| (n as f64, *error)).collect();
        series.push(Series { name: arithmetic.name().to_owned(), points, dashed: false });
        let Some(lambda) = case.lambda() else { continue };
        let start = (-f64::from(arithmetic.bits())).exp2();
        let theory = (0..medians.len()).map(|n| (n as f64, start * lambda.powf(n as f64)));
        let points = theory.take_while(|(_, error)| *error <= 1.0).collect();
        let name = format!("{}, foretold", arithmetic.name());
        series.push(Series { name, points, dashed: true });
    }
    Plot {
        name: format!("amplification-{}", file_name(&case.name)),
        title: format!("Error against bounce: {}", case.name),
        caption: "Median distance of the hit from truth's, in radii; where a curve ends, half of \
                  the paths meet something else. Dashed: 2^-p Lambda^n."
            .to_owned(),
        x: "bounce".to_owned(),
        y: "error, radii".to_owned(),
        x_scale: Scale::Linear,
        y_scale: Scale::Log,
        series,
    }
}

/// Letters and digits in lower case, anything else a hyphen.
fn file_name(name: &str) -> String {
    let letters = name.chars().map(|c| if c.is_ascii_alphanumeric() { c } else { '-' });
    letters.collect::<String>().to_ascii_lowercase()
}
