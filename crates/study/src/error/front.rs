//! Settings that are worth their time.

use catoptric_report::Cell;

use super::row::{Row, Sweep};
use crate::formula::Formula;
use crate::metrics::Metrics;

/// Whether no other of these (time, error) beats one, being as good in one and better in the other.
/// Never true of a failure, which has neither.
/// Never a failure, which has none.
#[must_use]
pub fn on_front(points: &[Option<(f64, f64)>]) -> Vec<bool> {
    let beats = |(other, found): (f64, f64), (time, error): (f64, f64)| {
        found <= error && other <= time && (found < error || other < time)
    };
    let beaten = |point| points.iter().flatten().any(|&other| beats(other, point));
    points.iter().map(|point| point.is_some_and(|point| !beaten(point))).collect()
}

/// Whether no cheaper setting of depth or weight has less error, by RMSE: one flipped pixel
/// owns the largest error, so that one would be the front of luck. `None` of samples and of
/// what was not timed; never true of a failure.
pub(super) fn fronts(rows: &[Row]) -> Vec<Option<bool>> {
    let time = |row: &Row| row.times.min_ms().filter(|_| row.is_swept());
    let point = |row: &Row| Some((time(row)?, row.sound()?.rmse));
    let points: Vec<_> = rows.iter().map(point).collect();
    let on_front = on_front(&points).into_iter().zip(rows);
    on_front.map(|(on_front, row)| time(row).map(|_| on_front)).collect()
}

/// What each of some aims costs at least, and all that is worth its time, in words.
pub(super) fn words(rows: &[Row]) -> Vec<String> {
    vec![
        aim(rows, "Within one 8-bit level everywhere", &|error| error.off_by_more == 0),
        aim(rows, "RMSE at most 1e-3", &|error| error.rmse <= 1e-3),
        aim(rows, "RMSE at most 1e-5", &|error| error.rmse <= 1e-5),
        front(rows),
    ]
}

/// What the error that was asked for costs at least.
pub(super) fn target(rows: &[Row], target: f64) -> String {
    aim(rows, &format!("RMSE at most {target:e}, as asked"), &|error| error.rmse <= target)
}

/// The cheapest setting of each knob that reaches an aim, the cheapest of all first.
fn aim(rows: &[Row], aim: &str, reaches: &dyn Fn(&Metrics) -> bool) -> String {
    let reaching = |row: &&Row| row.sound().is_some_and(reaches);
    let cheapest = |sweep: Sweep| {
        // Only the coarsest setting of a formula: finer ones cost more, whatever the clock says.
        let coarsest = Formula::ALL.into_iter().filter_map(|formula| {
            rows.iter().filter(|r| r.sweep == sweep && r.formula == formula).find(reaching)
        });
        let time = |row: &Row| row.times.min_ms().unwrap_or(f64::INFINITY);
        let row = coarsest.min_by(|a, b| time(a).total_cmp(&time(b)))?;
        Some((time(row), format!("{}, {}", row.name(), ms(row))))
    };
    let mut found: Vec<_> =
        [Sweep::Depth, Sweep::Weight].into_iter().filter_map(cheapest).collect();
    found.sort_by(|a, b| a.0.total_cmp(&b.0));
    match &found[..] {
        [] => format!("{aim}: nothing that was measured."),
        [(_, first)] => format!("{aim}: cheapest is {first}."),
        [(_, first), (_, other), ..] => {
            format!("{aim}: cheapest is {first}; by the other knob, {other}.")
        }
    }
}

/// The Pareto front, from the cheapest setting on.
fn front(rows: &[Row]) -> String {
    let with_front = rows.iter().zip(fronts(rows));
    let mut front: Vec<&Row> =
        with_front.filter(|(_, on_front)| *on_front == Some(true)).map(|(row, _)| row).collect();
    let time = |row: &Row| row.times.min_ms().unwrap_or(f64::INFINITY);
    front.sort_by(|a, b| time(a).total_cmp(&time(b)));
    let setting = |row: &&Row| {
        let rmse = row.error.map(|error| Cell::from(error.rmse).to_string());
        format!("{} ({}, RMSE {})", row.name(), ms(row), rmse.unwrap_or_default())
    };
    let settings: Vec<String> = front.iter().map(setting).collect();
    if settings.is_empty() {
        return "Nothing was timed.".to_owned();
    }
    format!("The front, which nothing cheaper beats: {}.", settings.join("; "))
}

fn ms(row: &Row) -> String {
    row.times.min_ms().map_or_else(|| "not timed".to_owned(), |ms| format!("{ms:.2} ms"))
}
