//! Work-precision diagrams.

use catoptric_report::{Plot, Report, Scale, Series};

use super::row::{Parts, Row, Sweep};
use crate::formula::Formula;

/// Adds a scene's plots.
pub(super) fn add(report: &mut Report, scene: &str, rows: &[Row]) {
    let mut series = measured(rows, Sweep::Depth, by_time);
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
            let unflipped =
                |row: &Row| Some((row.times.min_ms()?, row.parts?.unflipped?.error.rmse));
            let points = points(rows, Sweep::Depth, formula, unflipped);
            let name = format!("{}, without {flipped} pixel{plural}", formula.name());
            series.push(Series { name, points, dashed: true });
        }
    }
    // Work against precision, a mark for each depth.
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
    // The error by each knob's own setting.
    knob(report, scene, rows, Sweep::Depth, "max_depth", Scale::Doublings);
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
        series: measured(rows, Sweep::Samples, by_time),
    });
}

/// The largest error over a knob's setting, with the a-priori bound.
fn knob(report: &mut Report, scene: &str, rows: &[Row], sweep: Sweep, x: &str, x_scale: Scale) {
    let unflipped = |row: &Row| Some((row.setting, row.parts?.unflipped?.error.max));
    let mut series = measured(rows, sweep, unflipped);
    let bound = |name: &str, bound: fn(&Parts) -> Option<f64>| Series {
        name: name.to_owned(),
        points: points(rows, sweep, Formula::RobustF32, |row| {
            Some((row.setting, bound(row.parts.as_ref()?)?))
        }),
        dashed: true,
    };
    series.push(bound("a-priori bound", |parts| Some(parts.bound_truncation)));
    series.push(bound("and the floor of robust f32", Parts::bound));
    report.plot(Plot {
        name: format!("error-{scene}-{}", sweep.name()),
        title: format!("{scene}: largest error against {x}"),
        caption: "Without pixels whose path is not truth's. The bound is of what the setting \
                  leaves out and known before anything is traced; the second adds to it what \
                  robust f32 leaves at that setting, which is measured. No mark of robust f32 is \
                  above that."
            .to_owned(),
        x: x.to_owned(),
        y: "largest error".to_owned(),
        x_scale,
        y_scale: Scale::Log,
        series,
    });
}

fn by_time(row: &Row) -> Option<(f64, f64)> {
    Some((row.times.min_ms()?, row.sound()?.rmse))
}

fn measured(rows: &[Row], sweep: Sweep, point: impl Fn(&Row) -> Option<(f64, f64)>) -> Vec<Series> {
    let curve = |formula: Formula| Series {
        name: formula.name().to_owned(),
        points: points(rows, sweep, formula, &point),
        dashed: false,
    };
    Formula::ALL.into_iter().map(curve).collect()
}

fn points(
    rows: &[Row],
    sweep: Sweep,
    formula: Formula,
    point: impl Fn(&Row) -> Option<(f64, f64)>,
) -> Vec<(f64, f64)> {
    let of_curve = rows.iter().filter(|row| row.sweep == sweep && row.formula == formula);
    of_curve.filter_map(point).collect()
}
