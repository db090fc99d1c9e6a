//! Which settings are worth their time.

use super::sweep::{Row, Sweep};
use crate::formula::Formula;
use crate::report::Cell;

/// Whether no cheaper setting of depth or weight has less error, by RMSE. One flipped pixel
/// owns the largest error, so that one would be the front of luck.
pub(super) fn is_on(rows: &[Row], index: usize) -> bool {
    let row = &rows[index];
    let beats = |other: &Row| {
        let (Some(time), Some(other_time)) = (row.times.min_ms(), other.times.min_ms()) else {
            return false;
        };
        let no_worse = other.error.rmse <= row.error.rmse && other_time <= time;
        no_worse && (other.error.rmse < row.error.rmse || other_time < time)
    };
    row.times.min_ms().is_some() && is_swept(row) && !rows.iter().any(|r| is_swept(r) && beats(r))
}

/// For each of some aims, which depth and which weight are enough, in words.
pub(super) fn words(rows: &[Row], target: Option<f64>) -> Vec<String> {
    let mut lines = vec![
        aim(rows, "Within one 8-bit level everywhere", &|row| row.error.off_by_more == 0),
        aim(rows, "RMSE at most 1e-3", &|row| row.error.rmse <= 1e-3),
        aim(rows, "RMSE at most 1e-5", &|row| row.error.rmse <= 1e-5),
    ];
    if let Some(target) = target {
        let reaches = |row: &Row| row.error.rmse <= target;
        lines.push(aim(rows, &format!("RMSE at most {target}, as asked"), &reaches));
    }
    lines
}

/// The cheapest setting of each knob that reaches an aim.
fn aim(rows: &[Row], aim: &str, reaches: &dyn Fn(&Row) -> bool) -> String {
    let cheapest = |sweep: Sweep| {
        // Of a formula the coarsest setting: finer ones cost more, whatever the clock says.
        let coarsest = Formula::ALL.into_iter().filter_map(|formula| {
            let of_formula = rows.iter().filter(|r| r.sweep == sweep && r.formula == formula);
            let mut reaching = of_formula.filter(|row| reaches(row));
            let row = reaching.next()?;
            Some((row, row.times.min_ms()?))
        });
        let (row, ms) = coarsest.min_by(|a, b| a.1.total_cmp(&b.1))?;
        let (knob, formula) = (sweep.name(), row.formula.name());
        Some(format!("{knob} {} with {formula}, {ms:.2} ms", Cell::from(row.setting)))
    };
    let found: Vec<_> = [Sweep::Depth, Sweep::Weight].into_iter().filter_map(cheapest).collect();
    let found =
        if found.is_empty() { "nothing that was measured".into() } else { found.join("; ") };
    format!("{aim}: {found}.")
}

/// Samples are measured on another picture.
fn is_swept(row: &Row) -> bool {
    row.sweep != Sweep::Samples
}
