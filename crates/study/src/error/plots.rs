//! Work-precision diagrams.

use super::sweep::{Row, Sweep};
use crate::formula::Formula;
use crate::report::{Plot, Report, Scale, Series};

/// Adds a scene's plots.
pub(super) fn add(report: &mut Report, scene: &str, rows: &[Row]) {
    let by_depth = |row: &Row| Some((row.times.min_ms()?, row.error.rmse));
    let mut series = measured(rows, Sweep::Depth, by_depth);
    // One flipped pixel hides what the others have reached.
    let flipped = |formula: Formula| {
        let of_formula = |row: &&Row| row.sweep == Sweep::Depth && row.formula == formula;
        let parts = rows.iter().filter(of_formula).filter_map(|row| row.parts);
        parts.map(|parts| parts.flipped).max().unwrap_or(0)
    };
    for formula in [Formula::RobustF32, Formula::RobustF64] {
        let flipped = flipped(formula);
        if flipped > 0 {
            let plural = if flipped == 1 { "" } else { "s" };
            let unflipped = |row: &Row| Some((row.times.min_ms()?, row.parts?.error.rmse));
            let points = measured(rows, Sweep::Depth, unflipped)
                .into_iter()
                .find(|series| series.name == formula.name())
                .map_or_else(Vec::new, |series| series.points);
            let name = format!("{}, without {flipped} pixel{plural}", formula.name());
            series.push(Series { name, points, dashed: true });
        }
    }
    report.plot(Plot {
        name: format!("error-{scene}-work-precision"),
        title: format!("{scene}: error against time of tracing"),
        caption: "Each mark is a max_depth, from 0 on. A curve ends level where its formulas or \
                  its precision, and not its depth, make the error; dashed, the same \
                  without pixels whose path is not truth's."
            .to_owned(),
        x: "ms".to_owned(),
        y: "RMSE".to_owned(),
        x_scale: Scale::Log,
        y_scale: Scale::Log,
        series,
    });
    knob(report, scene, rows, Sweep::Depth, "max_depth", Scale::Linear);
    knob(report, scene, rows, Sweep::Weight, "min_weight", Scale::Log);
    report.plot(Plot {
        name: format!("error-{scene}-samples"),
        title: format!("{scene}: error against time, more samples a pixel"),
        caption: "1, 2, 3, 4, 6 and 8 samples a side, against 16 a side: what is left of edges \
                  between samples is far above what any formula leaves."
            .to_owned(),
        x: "ms".to_owned(),
        y: "RMSE".to_owned(),
        x_scale: Scale::Log,
        y_scale: Scale::Log,
        series: measured(rows, Sweep::Samples, |row| Some((row.times.min_ms()?, row.error.rmse))),
    });
}

/// The largest error over a knob's setting, with the a-priori bound.
fn knob(report: &mut Report, scene: &str, rows: &[Row], sweep: Sweep, x: &str, x_scale: Scale) {
    let mut series = measured(rows, sweep, |row| Some((row.setting, row.parts?.error.max)));
    let robust = rows.iter().filter(|r| r.sweep == sweep && r.formula == Formula::RobustF32);
    series.push(Series {
        name: "bound, robust f32".to_owned(),
        points: robust.filter_map(|row| Some((row.setting, row.parts?.bound))).collect(),
        dashed: true,
    });
    report.plot(Plot {
        name: format!("error-{scene}-{}", sweep.name()),
        title: format!("{scene}: largest error against {x}"),
        caption: "Without pixels whose path is not truth's. The bound is known before anything \
                  is traced, but for the floor of f32, which is added to it."
            .to_owned(),
        x: x.to_owned(),
        y: "largest error".to_owned(),
        x_scale,
        y_scale: Scale::Log,
        series,
    });
}

fn measured(rows: &[Row], sweep: Sweep, point: impl Fn(&Row) -> Option<(f64, f64)>) -> Vec<Series> {
    let curve = |formula: Formula| Series {
        name: formula.name().to_owned(),
        points: rows
            .iter()
            .filter(|row| row.sweep == sweep && row.formula == formula)
            .filter_map(&point)
            .collect(),
        dashed: false,
    };
    Formula::ALL.into_iter().map(curve).collect()
}
