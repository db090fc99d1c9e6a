//! Stiff and extreme cases against truth.
//!
//! ```text
//! suite.rs        all cases, and the verdicts on them
//! finding.rs      what a case is asked for, and what it finds
//! bounds.rs       what every case is held to: the one table
//! cases.rs        the measurements
//!   cases/          by what is stiff or extreme
//! given.rs        the measures of pictures and the criterion, for scenes that somebody gave
//! followed.rs     the measures that follow paths, together
//! paths.rs        paths in each arithmetic, and where two of them part
//!   agreement.rs    how many meet what truth meets, by bounce
//!   causes.rs       what an error is due to: rounding, or a path that flipped
//!   input.rs        what the rounding of the input costs by itself
//!   amplification.rs  growth of errors by bounce, against closed forms
//!   condition.rs    how far each pixel can be known
//! backward.rs     backward error: is the picture that of a scene nearly as stated?
//! rays.rs         single rays through the formulas
//! exact.rs        rays and spheres in double-double
//! search.rs       scenes of any magnitude, searched for what does not hold
//! generic.rs      generic positions
//! cost.rs         what robust costs over textbook
//! crops.rs        pictures of the instructive cases
//! rows.rs         findings as rows of a report
//! ```

pub mod agreement;
pub mod amplification;
pub mod backward;
pub mod bounds;
mod cases;
pub mod causes;
pub mod condition;
mod cost;
mod crops;
mod exact;
pub mod finding;
mod followed;
mod generic;
mod given;
pub mod input;
pub mod paths;
mod rays;
mod rows;
pub mod search;
pub mod suite;

use catoptric_report::Report;

use crate::Watch;
use crate::subject::Subject;
use finding::Effort;
use suite::{EXPERIMENTS, Verdict, verdict};

/// The suite, or, where scenes are given, its measures of pictures and paths on these.
///
/// Runs on rayon's current threads. The suite takes no more of their stacks than 2 MiB; scenes
/// with deep paths need [`catoptric_reference::truth::STACK_BYTES`].
#[must_use]
pub fn run(subjects: &[Subject], watch: &dyn Watch, effort: Effort) -> Report {
    let mut report =
        if subjects.is_empty() { the_suite(watch, effort) } else { pictures_of(subjects, watch) };
    report.complete = !watch.stopped();
    report
}

fn the_suite(watch: &dyn Watch, effort: Effort) -> Report {
    let mut report = Report::new("stability", "Stiff and extreme cases against truth");
    add_verdicts(&mut report, watch, effort);
    // Each part on its own, for an interruption keeps what is there.
    let parts: [fn(&mut Report, &dyn Watch); 4] = [add_refusals, add_crops, add_growth, add_paths];
    for part in parts {
        if watch.stopped() {
            return report;
        }
        part(&mut report, watch);
    }
    if !watch.stopped() {
        watch.say("cost");
        report.heading("Cost");
        report.table(cost::table());
    }
    report
}

fn add_verdicts(report: &mut Report, watch: &dyn Watch, effort: Effort) {
    let mut rows = rows::Rows::new();
    let mut counts = [0; 4];
    for experiment in &EXPERIMENTS {
        if watch.stopped() {
            break;
        }
        watch.say(experiment.name);
        for finding in (experiment.run)(effort) {
            let verdict = verdict(&finding);
            report.failed |= !verdict.is_expected();
            counts[match verdict {
                Verdict::Holds => 0,
                Verdict::FailsAsKnown(_) => 1,
                Verdict::Fails => 2,
                Verdict::HoldsNow => 3,
            }] += 1;
            rows.push(finding);
        }
    }
    let [holds, known, fails, now] = counts;
    report.heading("Verdicts");
    report.text(format!(
        "{holds} hold, {known} fail as known, {fails} FAIL, {now} hold though listed as known \
         failures. Truth is double-double from the unrounded scene."
    ));
    report.table(rows.verdicts);
    report.heading("What the cases are");
    report.table(rows.cases);
}

fn add_refusals(report: &mut Report, _: &dyn Watch) {
    report.heading("Refusals");
    report.table(rows::refusals(cases::refusals::all()));
}

fn add_crops(report: &mut Report, watch: &dyn Watch) {
    report.heading("Truth, result, difference");
    for crop in crops::all() {
        if watch.stopped() {
            return;
        }
        watch.say("pictures");
        report.text(crop.text);
        report.pictures(crop.pictures());
    }
}

fn add_growth(report: &mut Report, watch: &dyn Watch) {
    let workshop = cases::scenes::workshop(80, 60, 14, 0.3);
    let workshop = catoptric_scene::Scene::new(workshop).expect("the workshop's scene");
    let mut cases = amplification::orbits();
    cases.push(amplification::Case::room());
    // In units of the red sphere's radius.
    cases.push(amplification::picture("workshop", workshop, 4.0));
    let growths = amplification::measure_all(&cases, watch);
    report.heading("Growth of errors from mirror to mirror");
    report.text(
        "Between convex mirrors an error grows by a factor Lambda at each reflection, so a path \
         in p bits is lost after about (p ln 2 + ln tolerance)/ln Lambda of them, whatever the \
         formulas. Open scenes let their rays escape before; closed rooms do not.",
    );
    report.failed |= growths.iter().any(|growth| growth.holds() == Some(false));
    report.table(amplification::table(&growths));
    for growth in &growths {
        report.plot(amplification::plot(growth));
    }
}

fn add_paths(report: &mut Report, watch: &dyn Watch) {
    followed::add(report, &followed::own_subjects(), watch);
}

fn pictures_of(subjects: &[Subject], watch: &dyn Watch) -> Report {
    let mut report = Report::new("stability", "Pictures against truth");
    let mut table = given::table();
    for Subject { name, scene } in subjects {
        if watch.stopped() {
            break;
        }
        watch.say(&format!("{name}: backward error"));
        report.failed |= given::measure(&mut table, name, scene);
    }
    report.table(table);
    if !watch.stopped() {
        followed::add(&mut report, subjects, watch);
    }
    report
}
