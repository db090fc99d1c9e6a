//! Rungs broken on purpose. Each must be found different, and by the part of the comparison
//! that is there to find it.

use catoptric_core::Isa;
use catoptric_ladder::{FORWARD, Flight, RUNGS, Rung, Step, Walk, Watch, render_by, watch_by};
use catoptric_tests::scenes;
use glam::Vec3;

use crate::comparison::{Difference, view};

/// Which of picture, counts and logs differ on the workshop's scene.
pub(crate) fn differs(rung: &Rung) -> [bool; 3] {
    let (scene, grid) = view(&scenes::sized(&scenes::named("workshop"), 64, 48, 5), 1);
    let Difference { picture, counts, log } = Difference::new(rung, Isa::Portable, &scene, &grid);
    [picture.is_some(), counts.is_some(), log.is_some()]
}

/// A rung made of a `trace`, compared.
macro_rules! differs {
    ($trace:path) => {
        differs(&Rung {
            name: stringify!($trace),
            bit_identical: false,
            render: |scene, grid, film, _| render_by(scene, grid, film, 100, $trace),
            watch: |scene, grid, (column, row), _, watch| {
                let position = (grid.columns[column], grid.rows[row]);
                watch_by(scene, position, watch, 100, $trace)
            },
            ..RUNGS[3]
        })
    };
}

#[test]
fn nothing_broken_nothing_found() {
    fn trace<W: Watch>(walk: &mut Walk<W>, flight: Flight) -> Vec3 {
        match walk.step(flight) {
            Step::Ends(colour) => colour,
            Step::Mirrors(bounce, next) => {
                let back = trace(walk, next);
                walk.fold(flight.depth, bounce, back)
            }
        }
    }
    assert_eq!(differs!(trace), [false; 3]);
}

#[test]
fn folding_from_the_wrong_end() {
    fn trace<W: Watch>(walk: &mut Walk<W>, mut flight: Flight) -> Vec3 {
        let mut queue = Vec::new();
        let mut colour = loop {
            match walk.step(flight) {
                Step::Ends(colour) => break colour,
                Step::Mirrors(bounce, next) => {
                    queue.push(bounce);
                    flight = next;
                }
            }
        };
        for (depth, bounce) in (0..flight.depth).rev().zip(queue) {
            colour = walk.fold(depth, bounce, colour);
        }
        colour
    }
    assert_eq!(differs!(trace), [true, false, true]);
}

#[test]
fn the_sum_carried_along() {
    assert_eq!(differs(&FORWARD), [true, false, true]);
}

#[test]
fn a_ray_traced_twice() {
    fn trace<W: Watch>(walk: &mut Walk<W>, flight: Flight) -> Vec3 {
        walk.step(flight);
        match walk.step(flight) {
            Step::Ends(colour) => colour,
            Step::Mirrors(bounce, next) => {
                let back = trace(walk, next);
                walk.fold(flight.depth, bounce, back)
            }
        }
    }
    assert_eq!(differs!(trace), [false, true, true]);
}

/// The same picture by another road: only the log can tell.
#[test]
fn folding_at_the_wrong_depth() {
    fn trace<W: Watch>(walk: &mut Walk<W>, flight: Flight) -> Vec3 {
        match walk.step(flight) {
            Step::Ends(colour) => colour,
            Step::Mirrors(bounce, next) => {
                let back = trace(walk, next);
                walk.fold(next.depth, bounce, back)
            }
        }
    }
    assert_eq!(differs!(trace), [false, false, true]);
}
