//! The error study: bounds, truth's depth, failures, what it was asked for.

use std::sync::atomic::{AtomicUsize, Ordering};

use catoptric_core::Isa;
use catoptric_report::{Cell, Report};
use catoptric_scene::family::{Kissing, Room};
use catoptric_scene::{Draft, Light, Material, Numerics, Scene, Sphere, Transfer};
use catoptric_study::error::{Request, Settled, enough, on_front, run};
use catoptric_study::metrics::Metrics;
use catoptric_study::subject::Subject;
use catoptric_study::timing::Repeat;
use catoptric_study::tracer::{Threads, Tracer};
use catoptric_study::{Unwatched, Watch};

use crate::scenes;
use crate::tables::{cell, number, table, text, words};

fn subject(name: &str, draft: Draft, width: u32, height: u32) -> Subject {
    let mut draft = draft;
    (draft.image.width, draft.image.height) = (width, height);
    Subject { name: name.to_owned(), scene: Scene::new(draft).expect("valid") }
}

fn room(balls: u32, reflect: f64) -> Subject {
    let draft = Room { balls, reflect, ..Room::default() }.draft().expect("in range");
    subject("closed-room", draft, 16, 12)
}

fn workshop() -> Subject {
    let draft = scenes::workshop(24, 18, Numerics::Robust).into_draft();
    subject("workshop", draft, 24, 18)
}

fn study(subject: Subject, target: Option<f64>, watch: &dyn Watch) -> Report {
    let threads = &Threads::new([1, 2]).expect("two threads");
    let tracer = Tracer::Packet(Isa::detected());
    let (subjects, repeat) = (&[subject], Repeat::Times(1));
    run(&Request { subjects, tracer, threads, timed_on: 1, repeat, target }, watch)
}

/// Whether every row is within its bounds, those of truncation multiplied by `planted`; with
/// the number of rows that have a pixel to compare.
fn within_bounds(report: &Report, planted: f64) -> (bool, usize) {
    let rows = table(report, "error");
    let (mut within, mut compared) = (true, 0);
    for row in rows.rows.iter().filter(|row| text(rows, row, "sweep") != "samples") {
        let bound_truncation = number(rows, row, "bound_truncation") * planted;
        within &= number(rows, row, "truncation") <= bound_truncation;
        if *cell(rows, row, "bound") == Cell::Nothing {
            assert_eq!(*cell(rows, row, "floor"), Cell::Nothing);
            continue;
        }
        compared += 1;
        let sum = bound_truncation + number(rows, row, "floor");
        within &= number(rows, row, "max_unflipped") <= sum;
        assert!(planted != 1.0 || sum == number(rows, row, "bound"));
    }
    (within, compared)
}

#[test]
fn no_error_is_above_its_bound() {
    let kissing = Kissing { reflect: 0.7, ..Kissing::default() }.draft().expect("in range");
    for scene in [room(3, 0.8), subject("kissing", kissing, 24, 18), workshop()] {
        let name = scene.name.clone();
        let report = study(scene, None, &Unwatched);
        let (within, compared) = within_bounds(&report, 1.0);
        assert!(within, "{name}");
        assert!(compared > 40, "{name}: {compared} rows with a pixel whose path is truth's");
    }
}

/// From inside an empty room a bound is close to what is left out, and half of it is below.
#[test]
fn a_bound_that_is_too_low_is_found() {
    let report = study(room(0, 0.8), None, &Unwatched);
    assert!(within_bounds(&report, 1.0).0);
    assert!(!within_bounds(&report, 0.5).0);
}

/// Four small mirrors whose longest path no pixel of a small picture holds.
#[test]
fn truth_is_as_deep_as_its_own_picture_asks() {
    let mut draft = Draft::default();
    let mirror = Material { reflect: Some(0.95), ..Material::matt([0.9, 0.6, 0.4]) };
    let mirror = draft.materials.add(mirror);
    let corners = [[1.0, 1.0, 1.0], [1.0, -1.0, -1.0], [-1.0, 1.0, -1.0], [-1.0, -1.0, 1.0]];
    let middle = [0.515, 0.329, -20.0];
    let sphere = |corner: [f64; 3]| Sphere {
        center: [0, 1, 2].map(|i| middle[i] + 0.142 * corner[i]),
        radius: 0.2,
        material: mirror,
    };
    draft.lights.push(Light { position: [0.0, 20.0, 0.0], intensity: [1.0; 3] });
    draft.spheres = corners.into_iter().map(sphere).collect();
    let settled = Settled::of(&subject("four", draft, 640, 480), &Unwatched).expect("not stopped");
    assert!(settled.words().contains("every path of that picture has ended"));
    // What it says, the f32 picture of that size to a far greater depth confirms.
    let sized = Subject { name: String::new(), scene: settled.scene.clone() };
    let deep = enough(&sized.to_depth(1000), Isa::detected()).expect("a shallow path");
    assert!(deep.deepest_ray > 14 && deep.deepest_ray < settled.depth, "{deep:?}");
    assert!(deep.same_bits > 14 && deep.same_bits <= settled.depth, "{deep:?}");
}

/// What is slower and no better is beaten, and a failure is worth no time.
#[test]
fn the_front_is_what_nothing_beats() {
    let points = [
        Some((1.0, 0.5)),
        Some((2.0, 0.5)),
        Some((2.0, 0.1)),
        None,
        Some((2.0, 0.1)),
        Some((3.0, 0.2)),
        Some((9.0, 0.0)),
    ];
    assert_eq!(on_front(&points), [true, false, true, false, true, false, true]);
}

#[test]
fn values_that_are_not_finite_are_counted_and_left_out() {
    let truth = [[0.5, 0.5, 0.5], [0.5, 0.5, 0.5]];
    let found = [[0.5, f64::NAN, 0.75], [f64::INFINITY, 0.5, 0.5]];
    let over = |counts: fn(usize) -> bool| Metrics::over(&found, &truth, Transfer::Linear, counts);
    let (all, second) = (over(|_| true), over(|index| index == 1));
    assert_eq!((all.not_finite, all.max), (2, 0.25));
    assert_eq!((second.not_finite, second.max, second.rmse), (1, 0.0, 0.0));
    assert_eq!(over(|_| false).not_finite, 0);
}

/// The same picture is off by more levels where the transfer lifts what is dark.
#[test]
fn levels_are_those_of_the_scene_s_transfer() {
    let off = |transfer| {
        let mut draft = workshop().scene.into_draft();
        draft.image.transfer = transfer;
        let report = study(subject("workshop", draft, 24, 18), None, &Unwatched);
        let rows = table(&report, "error");
        let off = rows.rows.iter().map(|row| number(rows, row, "off_by_more")).sum::<f64>();
        (off, rows.rows.iter().map(|row| number(rows, row, "rmse")).sum::<f64>())
    };
    let (linear, same) = off(Transfer::Linear);
    let (srgb, rmse) = off(Transfer::Srgb);
    assert_eq!(rmse, same);
    assert!(srgb > linear, "{srgb} and {linear}");
}

/// The depth before the one that is named misses.
#[test]
fn the_target_s_depth_is_the_smallest() {
    let report = study(room(2, 0.8), Some(1e-4), &Unwatched);
    let rows = table(&report, "error");
    for formula in ["robust f32", "robust f64"] {
        let depths: Vec<(f64, f64)> = rows
            .rows
            .iter()
            .filter(|r| text(rows, r, "sweep") == "depth" && text(rows, r, "formula") == formula)
            .map(|row| (number(rows, row, "setting"), number(rows, row, "rmse")))
            .collect();
        assert!(depths.is_sorted_by(|a, b| a.0 < b.0), "{depths:?}");
        let first = depths.iter().position(|(_, rmse)| *rmse <= 1e-4).expect("it is met");
        let (before, meets) = (depths[first - 1], depths[first]);
        assert_eq!(before.0 + 1.0, meets.0, "{formula}: {depths:?}");
    }
    let words = words(&report);
    let first = words.lines().next().expect("words");
    let expected = "closed-room: RMSE at most 1e-4, as asked: cheapest is ";
    assert!(first.starts_with(expected), "{first}");
}

/// Its own cut and formulas are what `enough` is said of.
#[test]
fn a_scene_s_own_settings_are_named() {
    let mut draft = workshop().scene.into_draft();
    draft.render.min_weight = 0.25;
    draft.render.numerics = Numerics::Textbook;
    let words = words(&study(subject("own", draft, 24, 18), None, &Unwatched));
    assert!(words.contains("The scene's own min_weight, 0.25, is left out"), "{words}");
    assert!(words.contains("textbook formulas, with the scene's min_weight, 0.25"), "{words}");
}

/// Says that it is to stop once it was asked so often.
struct Stops(AtomicUsize);

impl Watch for Stops {
    fn stopped(&self) -> bool {
        let left = self.0.fetch_update(Ordering::Relaxed, Ordering::Relaxed, |n| n.checked_sub(1));
        left.is_err()
    }

    fn say(&self, _: &str) {}
}

/// Stopped anywhere, what it keeps is timed.
#[test]
fn every_row_of_a_stopped_study_has_a_time() {
    let mut most = 0;
    for asked in [0, 15, 300, 620, 660, 700] {
        let report = study(room(1, 0.5), None, &Stops(AtomicUsize::new(asked)));
        assert!(!report.complete);
        let rows = table(&report, "error");
        for row in &rows.rows {
            assert!(number(rows, row, "min_ms") > 0.0, "{asked}: {row:?}");
        }
        most = most.max(rows.rows.len());
        assert!(rows.rows.len() < 90, "{asked}");
    }
    assert!(most > 10, "{most} rows at most");
}
