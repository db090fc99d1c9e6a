//! The suite of stiff and extreme cases, case by case against the table of bounds.
//!
//! `CATOPTRIC_EXTREME_SCENES` asks for more scenes of extreme input, or fewer.

use std::collections::BTreeSet;

use catoptric_report::{Cell, Report};
use catoptric_scene::family::Room;
use catoptric_scene::{Document, Scene, SceneFormat};
use catoptric_study::formula::Formula;
use catoptric_study::stability::backward::{ALLOWED, Judge};
use catoptric_study::stability::bounds::GROUPS;
use catoptric_study::stability::finding::{Effort, Finding};
use catoptric_study::stability::run;
use catoptric_study::stability::suite::{EXPERIMENTS, Verdict, held_to, verdict};
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

    // Every case with each formula once, or once with none.
    let mut seen = BTreeSet::new();
    for finding in &findings {
        let name = finding.formula.map(Formula::name);
        assert!(seen.insert((finding.case, name)), "{} twice", finding.case);
        let of_case = findings.iter().filter(|f| f.case == finding.case).count();
        assert_eq!(of_case, if finding.formula.is_none() { 1 } else { 3 }, "{}", finding.case);
    }
}

fn described(finding: &Finding) -> String {
    let (measured, (most, _)) = (finding.measured, held_to(finding).1.of(finding.formula));
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
fn apart() {
    is_as_listed("apart");
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
        "apart",
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
    let mut cases = BTreeSet::new();
    for group in GROUPS {
        for text in [group.quantity, group.source, group.why] {
            assert!(text.len() > 5, "{}", group.cases[0].name);
        }
        for case in group.cases {
            assert!(cases.insert(case.name), "{} has one bound", case.name);
            assert!(case.known.iter().flatten().all(|text| text.ends_with('.')), "{}", case.name);
        }
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
    assert!(found.by_eye > ALLOWED && found.by_input < 2.0, "{found:?}");
    assert_eq!(found.raw.off_by_more, 0);

    let mut other = scene.clone().into_draft();
    other.lights[0].position[0] += 1e-4;
    let picture = Formula::RobustF32.picture(&other).expect("depth 8");
    let found = judge.judge(&picture).expect("depth 8");
    assert!(found.by_input > ALLOWED, "{found:?}");
}

/// A thousand times the light, or a millionth: the same ratios, since lights only scale what is
/// computed, and the floor with it.
#[test]
fn brightness_changes_no_ratio() {
    let mut draft = scene("workshop").into_draft();
    (draft.image.width, draft.image.height) = (80, 60);
    let ratios = |factor: f64| {
        let mut draft = draft.clone();
        let scaled = |light: &mut [f64; 3]| *light = light.map(|x| x * factor);
        draft.lights.iter_mut().for_each(|light| scaled(&mut light.intensity));
        scaled(&mut draft.render.ambient);
        scaled(&mut draft.render.background);
        let judge = Judge::new(&Scene::new(draft.clone()).expect("valid")).expect("depth 5");
        Formula::ALL.map(|formula| {
            let picture = formula.picture(&draft).expect("depth 5");
            let found = judge.judge_as(formula, &picture).expect("depth 5");
            (found.by_eye, found.by_input, found.beyond)
        })
    };
    let as_stated = ratios(1.0);
    assert!(as_stated[0].0 > 1000.0 && as_stated[1].0 > 0.05, "{as_stated:?}");
    for exponent in [-20.0_f64, -3.0, 10.0, 24.0] {
        assert_eq!(ratios(exponent.exp2()), as_stated, "2^{exponent}");
    }
    let decimal = ratios(1e4);
    for (found, expected) in decimal.iter().zip(as_stated) {
        let near = (found.1 / expected.1 - 1.0).abs() < 0.5;
        assert!(near, "{found:?}, not {expected:?}");
    }
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

fn first_table(report: &Report) -> &catoptric_report::Table {
    report.tables().next().expect("a table")
}

#[test]
fn given_scenes_are_measured_with_every_formula() {
    let mut small = scene("workshop").into_draft();
    (small.image.width, small.image.height) = (64, 48);
    let scenes = [subject("small", Scene::new(small).expect("valid"))];
    let report = run(&scenes, &Unwatched, Effort::default());
    assert!(report.complete && !report.failed);
    let rows = &first_table(&report).rows;
    assert_eq!(rows.len(), 3);
    assert_eq!(rows[1][1], Cell::from("robust f32"));
    let verdicts = [0, 1, 2].map(|row: usize| rows[row][2].clone());
    assert_eq!(verdicts, ["fails as known", "holds", "holds"].map(Cell::from));
    assert_eq!(rows[1][7], Cell::Count(0), "no pixel off by more than a level");
    assert!(matches!(rows[0][7], Cell::Count(count) if count > 10), "textbook is");
}

/// After 64 reflections in a closed room two pixels meet edges that 4 u of input do not reach.
#[test]
fn a_given_scene_on_which_robust_fails_fails_the_study() {
    let mut room = Room { balls: 3, seed: 1, ..Room::default() }.draft().expect("in range");
    (room.image.width, room.image.height) = (60, 45);
    let report =
        run(&[subject("room", Scene::new(room).expect("valid"))], &Unwatched, Effort::default());
    let row = &first_table(&report).rows[1];
    assert_eq!((&row[1], &row[2]), (&Cell::from("robust f32"), &Cell::from("FAILS")), "{row:?}");
    assert!(report.failed);
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
