//! Forward accumulation is the same sum in the reals alone.

use catoptric_core::Isa;
use catoptric_ladder::{Event, FORWARD, RUNGS};
use catoptric_scene::Film;
use catoptric_tests::identity::{pool, recursive};
use catoptric_tests::scenes;

use crate::comparison::{eye_rays, settings, view, watched};

/// Of a picture of 320x240, how much forward accumulation changes.
struct Change {
    /// Numbers, three a pixel, with other bits.
    values: usize,
    /// Pixels with other bits.
    pixels: usize,
    /// Pixels that show two mirrors or more.
    mirrored: usize,
    /// The largest change of a number.
    largest: f32,
}

fn change(name: &str, depth: u32) -> Change {
    let (scene, grid) = view(&scenes::sized(&scenes::named(name), 320, 240, depth), 1);
    let (recursive, _) = recursive(&scene, &grid);
    let mut forward = Film::new(grid.width, grid.height);
    let settings = settings(Isa::Portable);
    let rendered = pool(2).install(|| (FORWARD.render)(&scene, &grid, &mut forward, settings));
    rendered.expect("not deep");

    let mut change = Change { values: 0, pixels: 0, mirrored: 0, largest: 0.0 };
    let pairs = recursive.pixels().iter().zip(forward.pixels());
    for (at, (a, b)) in eye_rays(&grid).zip(pairs) {
        let log = watched(&RUNGS[0], Isa::Portable, &scene, &grid, at);
        let folds = log.iter().filter(|event| matches!(event, Event::Fold { .. })).count();
        let values = a.iter().zip(b).filter(|(a, b)| a.to_bits() != b.to_bits()).count();
        assert!(values == 0 || folds >= 2, "{name} at {at:?}: nothing was multiplied out");
        change.values += values;
        change.pixels += usize::from(values > 0);
        change.mirrored += usize::from(folds >= 2);
        for (a, b) in a.iter().zip(b) {
            let off = (a - b).abs();
            change.largest = if off > change.largest { off } else { change.largest };
        }
    }
    change
}

/// With one mirror k0 · local1 is the same either way.
#[test]
fn equal_up_to_one_mirror() {
    for depth in [0, 1] {
        assert_eq!(change("workshop", depth).values, 0);
    }
}

/// The README's figures: `--nocapture` shows them.
#[test]
fn other_bits_from_the_second_mirror_on() {
    for (name, depth) in [("workshop", 2), ("workshop", 5), ("kissing", 8), ("closed-room", 8)] {
        let Change { values, pixels, mirrored, largest } = change(name, depth);
        let percent = |part: usize, whole: usize| 100.0 * part as f64 / whole as f64;
        println!(
            "{name} at depth {depth}: of all pixels {:.1} % differ, of those with two mirrors or \
             more {:.1} % and of their numbers {:.1} %, by up to {largest:.1e}",
            percent(pixels, 320 * 240),
            percent(pixels, mirrored),
            percent(values, 3 * mirrored),
        );
        assert!(values > 0 && largest < 1e-5, "{name}");
    }
}
