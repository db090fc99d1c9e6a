//! Packets broken on purpose: rung 4 with a fault in its masks. Each must be found.

use std::array::from_fn;

use catoptric_ladder::{Error, Flight, PendingBounce, RUNGS, Rung, Step, Walk, Watch};
use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;

use crate::broken::differs;

const LANES: usize = 8;

/// `MASKED`: lanes whose ray has ended are not stepped. `CLEARED`: a level starts empty, so that
/// they owe nothing. Rung 4 has both.
fn trace<W: Watch, const MASKED: bool, const CLEARED: bool>(
    walks: &mut [Walk<W>; LANES],
    mut flights: [Flight; LANES],
) -> [Vec3; LANES] {
    const EMPTY: [PendingBounce; LANES] = [PendingBounce { local: Vec3::ZERO, k: 0.0 }; LANES];
    let mut stack: Vec<[PendingBounce; LANES]> = Vec::new();
    let mut live = [true; LANES];
    while live.contains(&true) {
        let before = stack.last().copied();
        let mut level = before.filter(|_| !CLEARED).unwrap_or(EMPTY);
        for lane in 0..LANES {
            if MASKED && !live[lane] {
                continue;
            }
            match walks[lane].step(flights[lane]) {
                Step::Ends(colour) => {
                    level[lane].local = colour;
                    live[lane] = false;
                }
                Step::Mirrors(bounce, next) => {
                    level[lane] = bounce;
                    flights[lane] = next;
                }
            }
        }
        stack.push(level);
    }
    let mut colours = [Vec3::ZERO; LANES];
    while let Some(level) = stack.pop() {
        let depth = stack.len() as u32;
        colours = from_fn(|lane| walks[lane].fold(depth, level[lane], colours[lane]));
    }
    colours
}

/// A view whose width is a number of whole packets.
fn render<const MASKED: bool, const CLEARED: bool>(
    scene: &Compiled,
    grid: &Grid,
    film: &mut Film,
) -> Result<Counts, Error> {
    let mut walks = from_fn(|_| Walk::new(scene, 100, ()));
    let rows = film.pixels_mut().chunks_exact_mut(grid.columns.len());
    for (pixels, &row) in rows.zip(&grid.rows) {
        for (pixels, columns) in pixels.chunks_exact_mut(LANES).zip(grid.columns.chunks(LANES)) {
            let eyes = from_fn(|lane| walks[lane].eye(columns[lane], row));
            let colours = trace::<_, MASKED, CLEARED>(&mut walks, eyes);
            for (pixel, colour) in pixels.iter_mut().zip(colours) {
                *pixel = colour.to_array();
            }
        }
    }
    walks.into_iter().try_fold(Counts::default(), |mut sum, walk| {
        sum.add(&walk.finish()?);
        Ok(sum)
    })
}

fn watch<const MASKED: bool, const CLEARED: bool>(
    scene: &Compiled,
    grid: &Grid,
    (column, row): (usize, usize),
    watch: &mut dyn Watch,
) -> Result<Vec3, Error> {
    let (first, seen) = (column - column % LANES, column % LANES);
    let mut watch = Some(watch);
    let mut walks =
        from_fn(|lane| Walk::new(scene, 100, if lane == seen { watch.take() } else { None }));
    let eyes = from_fn(|lane| walks[lane].eye(grid.columns[first + lane], grid.rows[row]));
    Ok(trace::<_, MASKED, CLEARED>(&mut walks, eyes)[seen])
}

fn rung<const MASKED: bool, const CLEARED: bool>() -> Rung {
    Rung {
        name: "packets",
        bit_identical: false,
        render: |scene, grid, film, _| render::<MASKED, CLEARED>(scene, grid, film),
        watch: |scene, grid, at, _, to| watch::<MASKED, CLEARED>(scene, grid, at, to),
        ..RUNGS[4]
    }
}

#[test]
fn nothing_broken_nothing_found() {
    assert_eq!(differs(&rung::<true, true>()), [false; 3]);
}

/// A ray that has ended is traced again until the packet's last has: the same colour each time,
/// since below it k is 0.
#[test]
fn without_the_mask() {
    assert_eq!(differs(&rung::<false, true>()), [false, true, true]);
}

/// What a lane owed on the level before is paid again.
#[test]
fn idle_lanes_that_keep_what_they_held() {
    assert_eq!(differs(&rung::<true, false>()), [true, false, true]);
}
