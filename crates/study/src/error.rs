//! Error against run time: what a depth, a weight cut, samples, formulas and precision cost,
//! and what they bring.
//!
//! The practice is that of work-precision diagrams (Hairer and Wanner, Solving Ordinary
//! Differential Equations II, 1996): truth first, then one knob at a time, error over time on
//! logarithmic axes; what fails or is beaten is listed and not dropped.

mod enough;
mod floors;
mod front;
mod plots;
mod request;
mod row;
mod sample;
mod size;
mod sweep;
mod truth;
mod words;

use catoptric_report::{Report, Table};

use crate::Watch;
use crate::timing::noise;
pub use enough::{Enough, enough};
pub use front::on_front;
pub use request::Request;
use row::COLUMNS;
pub use truth::Settled;

/// Measures all of it.
#[must_use]
pub fn run(request: &Request, watch: &dyn Watch) -> Report {
    let mut report = Report::new("error", "Error against run time");
    let mut table = Table::new(
        "error",
        COLUMNS,
        "Error against truth and time of tracing, one knob at a time. Truth is in double-double \
         at a depth past which nothing changes; of samples, in f64 with 16 x 16 of them.",
    );
    let mut floors = floors::table();
    let mut parts = Vec::new();
    // Measure scene by scene. The table of all comes before the words on each.
    for subject in request.subjects {
        if watch.stopped() {
            break;
        }
        let measured = sweep::measure(subject, request, watch);
        for (row, on_front) in measured.rows.iter().zip(front::fronts(&measured.rows)) {
            row.push(&mut table, &subject.name, on_front);
        }
        for floor in &measured.floors {
            floor.push(&mut floors, &subject.name);
        }
        if let Some(target) = request.target.filter(|_| !measured.rows.is_empty()) {
            report.text(format!("{}: {}", subject.name, front::target(&measured.rows, target)));
        }
        parts.push((subject, measured));
    }
    // Words and plots of each scene.
    report.table(table);
    for (subject, measured) in &parts {
        report.heading(&subject.name);
        report.text(&measured.about);
        if measured.rows.is_empty() {
            continue;
        }
        for line in front::words(&measured.rows) {
            report.text(line);
        }
        if let Some(noise) = noise(measured.rows.iter().map(|row| &row.times)) {
            report.text(noise);
        }
        plots::add(&mut report, &subject.name, &measured.rows);
    }
    // What each formula leaves at full depth.
    report.heading("Floors");
    report.table(floors);
    for (subject, measured) in &parts {
        for failure in measured.floors.iter().filter_map(floors::Floor::failure) {
            report.text(format!("{}, {failure}.", subject.name));
        }
    }
    report.complete = !watch.stopped();
    report
}
