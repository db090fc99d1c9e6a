//! The depth study: what it refuses to time, what it counts.

use catoptric_core::{Isa, tile_candidates};
use catoptric_ladder::{FORWARD, RUNGS, Rung};
use catoptric_report::{Cell, Report};
use catoptric_scene::family::Room;
use catoptric_scene::{Compiled, Draft, Grid, Scene, View};
use catoptric_study::Unwatched;
use catoptric_study::checked::Difference;
use catoptric_study::depth::{Mismatch, Request, run};
use catoptric_study::subject::Subject;
use catoptric_study::timing::Repeat;
use catoptric_study::tracer::{Threads, Tracer};
use catoptric_study::way::Way;

use crate::tables::{cell, number, table, text, words};

/// A room of mirrors: no ray escapes.
fn room(width: u32, height: u32, balls: u32) -> Subject {
    let mut draft = Room { balls, ..Room::default() }.draft().expect("in range");
    (draft.image.width, draft.image.height) = (width, height);
    draft.render.max_depth = 6;
    Subject { name: "room".to_owned(), scene: Scene::new(draft).expect("valid") }
}

fn study(subject: Subject, depths: &[u32], ways: &[Way]) -> Result<Report, Mismatch> {
    let threads = &Threads::new([1, 2]).expect("two threads");
    let (subjects, repeat) = (&[subject], Repeat::Times(1));
    run(&Request { subjects, depths, ways, threads, repeat, isa: Isa::Portable }, &Unwatched)
}

const RECURSION: Way = Way::Tracer(Tracer::Recursive);
const ENGINE: Way = Way::Tracer(Tracer::Packet(Isa::Portable));

/// The sum carried along is the same only in the reals.
#[test]
fn a_way_with_other_bits_fails_the_study() {
    let wrong = Way::Rung(&FORWARD, Isa::Portable);
    let error = study(room(33, 17, 3), &[0, 5], &[RECURSION, wrong]).expect_err("other bits");
    assert!(matches!(error.difference, Difference::Pixels(1..)), "{error}");
    assert_eq!((error.depth, error.way.as_str(), error.threads), (5, "forward", 1));
    assert!(error.to_string().contains("nothing was timed"), "{error}");
}

/// The recursion's picture, and a ray more than it has.
static MISCOUNTS: Rung = Rung {
    name: "miscounts",
    render: |scene, grid, film, settings| {
        let mut counts = (RUNGS[0].render)(scene, grid, film, settings)?;
        counts.depths[0].shadow += 1;
        Ok(counts)
    },
    ..RUNGS[0]
};

#[test]
fn a_way_with_other_rays_fails_the_study() {
    let ways = [RECURSION, ENGINE, Way::Rung(&MISCOUNTS, Isa::Portable)];
    let error = study(room(8, 8, 3), &[2], &ways).expect_err("other rays");
    assert_eq!((error.difference, error.way.as_str()), (Difference::Rays, "miscounts"));
}

/// Past the recursion's stack the ladder's loop says what is right; past that one's, nothing.
#[test]
fn what_cannot_be_compared_is_not_timed() {
    let mut draft = room(1, 1, 0).scene.into_draft();
    draft.materials[draft.spheres[0].material].reflect = Some(1.0);
    let subject = Subject { name: "r".to_owned(), scene: Scene::new(draft).expect("valid") };
    let deep = study(subject, &[10, 100_001, 1_000_001], &[RECURSION, ENGINE]).expect("same bits");
    let rows = table(&deep, "depth");
    let told = |depth: f64, engine: &str| {
        let mut of = rows.rows.iter().filter(|r| number(rows, r, "depth") == depth);
        let row = of.find(|row| text(rows, row, "engine") == engine).expect("a row");
        (text(rows, row, "note"), *cell(rows, row, "min_ms") == Cell::Nothing)
    };
    assert_eq!(told(10.0, "packet"), ("-".to_owned(), false));
    let by_loop = "compared with the ladder's loop: too deep for the recursion";
    assert_eq!(told(100_001.0, "packet"), (by_loop.to_owned(), false));
    assert_eq!(told(100_001.0, "recursive"), ("a path is deeper than the stack".to_owned(), true));
    let (note, untimed) = told(1_000_001.0, "packet");
    assert!(note.starts_with("not timed") && untimed, "{note}");
}

/// 33 x 17 pixels of which all live: four whole eights and a single one a row; of the engine's
/// tiles, 32 x 16, 1 x 16, 32 x 1 and 1 x 1.
#[test]
fn rays_alive_are_those_of_neighbours_and_of_packets() {
    let report = study(room(33, 17, 0), &[3], &[ENGINE]).expect("same bits");
    let levels = table(&report, "levels");
    let means = |key: &str| levels.rows.iter().map(|row| number(levels, row, key)).collect();
    let (neighbours, packets): (Vec<f64>, Vec<f64>) =
        (means("alive_neighbours"), means("alive_packet"));
    let all = 33.0 * 17.0;
    assert_eq!(neighbours, [all / (5.0 * 17.0); 4]);
    let eye = all / (64.0 + 16.0 + 4.0 + 1.0);
    let mirrored = all / (64.0 + 2.0 + 4.0 + 1.0);
    assert_eq!(packets, [eye, mirrored, mirrored, mirrored]);
}

/// That the tiles are of that size, the engine says.
#[test]
fn tiles_are_32_by_16() {
    for (width, height, tiles) in [(32, 16, 1), (33, 16, 2), (32, 17, 2), (64, 32, 4)] {
        let subject = room(width, height, 0);
        let grid = Grid::new(&View::whole(&subject.scene));
        let candidates = tile_candidates(&Compiled::new(&subject.scene), &grid);
        assert_eq!(candidates.tiles, tiles, "{width}x{height}");
    }
}

/// Where paths part, neighbours empty, and the engine's packets do not.
#[test]
fn packets_stay_fuller_than_neighbours() {
    let draft: Draft = catoptric_scene::family::Kissing::default().draft().expect("in range");
    let subject = Subject { name: "kissing".to_owned(), scene: Scene::new(draft).expect("valid") };
    let subject = Subject {
        scene: subject.with(|draft| (draft.image.width, draft.image.height) = (128, 96)),
        ..subject
    };
    let report = study(subject, &[4], &[ENGINE]).expect("same bits");
    let levels = table(&report, "levels");
    let at = |depth: usize, key: &str| number(levels, &levels.rows[depth], key);
    for depth in [2, 3, 4] {
        assert!(at(depth, "alive_neighbours") < 0.9 * at(depth, "alive_packet"), "depth {depth}");
        assert!(at(depth, "alive_packet") <= 8.0);
    }
}

#[test]
fn words_name_what_was_asked_for() {
    let said = |ways: &[Way]| words(&study(room(8, 8, 1), &[2], ways).expect("same bits"));
    assert!(said(&[RECURSION, ENGINE]).contains("There the packet engine on 2 threads is "));
    assert!(said(&[RECURSION]).contains("There the recursion on 2 threads is "));
    assert!(said(&[ENGINE]).contains("The recursion was not asked for"));
}

#[test]
fn the_waterfall_has_every_step_that_exists() {
    let report = study(room(33, 17, 3), &[1], &[ENGINE]).expect("same bits");
    let waterfall = table(&report, "waterfall");
    let steps: Vec<String> =
        waterfall.rows.iter().map(|row| text(waterfall, row, "step")).collect();
    let expected = [
        "the recursion",
        "a scalar loop with an explicit stack",
        "eight rays in turn, with masks",
        "eight portable lanes, nothing left out",
        "primitives out of a tile's sight left out",
        "primitives out of a lamp's way left out",
        "2 threads",
    ];
    assert_eq!(steps, expected);
    for row in &waterfall.rows {
        assert_eq!(number(waterfall, row, "runs"), 1.0);
    }
}
