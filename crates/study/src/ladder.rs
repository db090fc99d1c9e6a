//! The ladder: what each step from the recursion to the engine costs and buys.
//!
//! Every rung's picture is compared with the recursion's, bit for bit, before it is timed. All
//! are timed on one thread.

mod climbed;
mod request;
mod table;

use catoptric_report::{Report, Table};

use crate::Watch;
use climbed::{Climbed, Row};
pub use request::Request;
use table::COLUMNS;

/// Measures all of it. The report says that something failed where a rung that promises the
/// recursion's bits has others.
#[must_use]
pub fn run(request: &Request, watch: &dyn Watch) -> Report {
    let mut report = Report::new("ladder", "The ladder: from the recursion to the engine");
    let mut table =
        Table::new("ladder", COLUMNS, "Every rung on one thread, all of a scene run in turn.");
    let mut words = Vec::new();
    for subject in request.subjects {
        if watch.stopped() {
            break;
        }
        watch.say(&format!("{}: checking every rung's picture, then timing", subject.name));
        let climbed = Climbed::new(subject, request, watch);
        report.failed |= climbed.rows.iter().any(Row::is_wrong);
        climbed.push(&mut table, &subject.name);
        words.push((subject.name.as_str(), climbed.words()));
    }
    report.table(table);
    for (name, words) in words {
        report.heading(name);
        report.text(words);
    }
    report.complete = !watch.stopped();
    report
}
