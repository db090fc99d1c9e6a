//! The suite of stiff and extreme cases, case by case against the table of bounds.
//!
//! `CATOPTRIC_EXTREME_SCENES` asks for more scenes of extreme input, or fewer.

use std::collections::BTreeSet;

use catoptric_scene::{Document, Scene, SceneFormat};
use catoptric_study::formula::Formula;
use catoptric_study::report::{Cell, Report};
use catoptric_study::stability::backward::{ALLOWED, Judge};
use catoptric_study::stability::bounds::BOUNDS;
use catoptric_study::stability::run;
use catoptric_study::stability::suite::{EXPERIMENTS, Effort, Finding, Verdict, bound, verdict};
use catoptric_study::subject::Subject;
use catoptric_study::{Unwatched, Watch};

/// Everything that an experiment finds is what the table says: what fails is listed, and what
/// is listed fails.
#[track_caller]
fn is_as_listed(name: &str) {
    let mut effort = Effort::default();
    if let Some(scenes) = std::env::var_os("CATOPTRIC_EXTREME_SCENES") {
        let scenes = scenes.to_str().and_then(|text| text.parse().ok());
        effort.scenes = scenes.expect("CATOPTRIC_EXTREME_SCENES is a number");
    }
    let experiment = EXPERIMENTS.iter().find(|experiment| experiment.name == name);
    let findings = (experiment.expect("an experiment of that name").run)(effort);
    let unexpected: Vec<_> =
        findings.iter().filter(|f| !verdict(f).is_expected()).map(described).collect();
    assert!(unexpected.is_empty(), "{}", unexpected.join("\n"));

    // Every case with each formula once, and no formula of the table left out.
    let mut seen = BTreeSet::new();
    for finding in &findings {
        let name = finding.formula.map(Formula::name);
        assert!(seen.insert((finding.case, name)), "{} twice", finding.case);
        for (formula, _) in bound(finding).known {
            let has =
                findings.iter().any(|f| f.case == finding.case && f.formula == Some(*formula));
            assert!(has, "{} is listed for {}", finding.case, formula.name());
        }
        let of_case = findings.iter().filter(|f| f.case == finding.case).count();
        assert_eq!(of_case, if finding.formula.is_none() { 1 } else { 3 }, "{}", finding.case);
    }
}

fn described(finding: &Finding) -> String {
    let (measured, most) = (finding.measured, bound(finding).most);
    let (case, formula) = (finding.case, finding.formula.map_or("any", Formula::name));
    let text = verdict(finding).text();
    format!("{case}, {formula}: {text}, {measured:?}, bound {most:e}; {}", finding.sentence)
}

#[test]
fn workshop() {
    is_as_listed("workshop");
}

#[test]
fn large() {
    is_as_listed("large");
}

#[test]
fn distant() {
    is_as_listed("distant");
}

#[test]
fn contact() {
    is_as_listed("contact");
}

#[test]
fn invariance() {
    is_as_listed("invariance");
}

#[test]
fn mirrors() {
    is_as_listed("mirrors");
}

#[test]
fn refusals() {
    is_as_listed("refusals");
}

#[test]
fn edges() {
    is_as_listed("edges");
}

#[test]
fn extreme() {
    is_as_listed("extreme");
}

/// An experiment without a test of its own would be held to nothing here.
#[test]
fn every_experiment_has_its_test() {
    let names: Vec<_> = EXPERIMENTS.iter().map(|experiment| experiment.name).collect();
    let tests = [
        "workshop",
        "large",
        "distant",
        "contact",
        "invariance",
        "mirrors",
        "refusals",
        "edges",
        "extreme",
    ];
    assert_eq!(names, tests);
}

#[test]
fn the_table_says_why() {
    let cases: BTreeSet<_> = BOUNDS.iter().map(|bound| bound.case).collect();
    assert_eq!(cases.len(), BOUNDS.len(), "a case has one bound");
    for bound in BOUNDS {
        for text in [bound.quantity, bound.source, bound.why] {
            assert!(text.len() > 5, "{}", bound.case);
        }
        assert!(bound.known.iter().all(|(_, text)| text.ends_with('.')), "{}", bound.case);
    }
}

#[test]
fn verdicts_compare_with_the_bound_and_the_known_failures() {
    let finding = |case, formula, measured| Finding {
        case,
        formula: Some(formula),
        tested: String::new(),
        measured,
        sentence: String::new(),
    };
    let of = |case, formula, measured| verdict(&finding(case, formula, measured));
    let (robust, textbook) = (Formula::RobustF32, Formula::TextbookF32);
    assert_eq!(of("workshop, backward", robust, 4.0), Verdict::Holds);
    assert_eq!(of("workshop, backward", robust, 4.001), Verdict::Fails);
    assert_eq!(of("workshop, backward", robust, f64::NAN), Verdict::Fails);
    assert_eq!(of("workshop, backward", textbook, 3.0), Verdict::HoldsNow);
    assert!(matches!(of("workshop, backward", textbook, 5.0), Verdict::FailsAsKnown(_)));
    assert!(!Verdict::HoldsNow.is_expected() && !Verdict::Fails.is_expected());
}

/// A highlight in a mirror: nudged eye rays do not explain its error, moved input does; and
/// moved input does not excuse a picture of another scene.
#[test]
fn a_mirrored_highlight_is_judged_by_all_input() {
    let scene = scene("planes");
    let judge = Judge::new(&scene).expect("depth 8");
    let picture = Formula::RobustF32.picture(&scene).expect("depth 8");
    let found = judge.judge(&picture).expect("depth 8");
    assert!(found.by_eye > 7.0 && found.by_input < 2.0, "{found:?}");
    assert_eq!(found.raw.off_by_more, 0);

    let mut other = scene.clone().into_draft();
    other.lights[0].position[0] += 1e-4;
    let picture = Formula::RobustF32.picture(&other).expect("depth 8");
    let found = judge.judge(&picture).expect("depth 8");
    assert!(found.by_input > ALLOWED, "{found:?}");
}

fn scene(name: &str) -> Scene {
    let path = format!("{}/../../scenes/{name}.toml", env!("CARGO_MANIFEST_DIR"));
    let text = std::fs::read(&path).expect("a scene of scenes/");
    let document = Document::parse(name, &text, SceneFormat::Toml).expect("readable");
    document.into_scene().expect("valid")
}

fn subject(name: &str, scene: Scene) -> Subject {
    Subject { name: name.to_owned(), scene }
}

fn first_table(report: &Report) -> &catoptric_study::report::Table {
    report.tables().next().expect("a table")
}

#[test]
fn given_scenes_are_measured_with_every_formula() {
    let mut small = scene("workshop").into_draft();
    (small.image.width, small.image.height) = (64, 48);
    let scenes = [subject("small", Scene::new(small).expect("valid"))];
    let report = run(&scenes, &Unwatched, Effort::default());
    assert!(report.complete);
    let rows = &first_table(&report).rows;
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[1][1], Cell::from("robust f32"));
    assert_eq!(rows[1][6], Cell::Count(0), "no pixel off by more than a level");
    assert!(matches!(rows[0][6], Cell::Count(count) if count > 10), "textbook is");
}

#[test]
fn what_is_stopped_is_not_complete() {
    struct Stopped;
    impl Watch for Stopped {
        fn stopped(&self) -> bool {
            true
        }
        fn say(&self, _: &str) {
            panic!("nothing is measured");
        }
    }
    let report = run(&[], &Stopped, Effort::default());
    assert!(!report.complete);
    assert!(first_table(&report).rows.is_empty());
    let report = run(&[subject("workshop", scene("workshop"))], &Stopped, Effort::default());
    assert!(!report.complete && first_table(&report).rows.is_empty());
}
