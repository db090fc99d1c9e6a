//! Rung 4, packets: rung 3's two loops, each pass for eight rays side by side.
//!
//! The packet goes on while any ray does. A mask says which lanes still hold a ray on the way
//! down. On the way up there is no mask: a level where a lane's ray ended holds (colour, k = 0)
//! and a level below it (0, 0), so folding gives 0 + 0 · 0 there, then colour + 0 · 0. That
//! is the colour itself, since no colour is -0.
//!
//! The engine shades all lanes of a packet that met one primitive at once. Here each lane takes
//! the reference's scalar step, so this rung is no faster; it shows masks and nothing else.

use std::array::from_fn;

use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;

use crate::picture::rows;
use crate::{DEEPEST, Error, Flight, PendingBounce, Step, Walk, Watch};

/// Rays side by side.
pub(crate) const LANES: usize = 8;

/// One step's outcome in all lanes.
type Level = [PendingBounce; LANES];

/// The light that comes back along the eye rays in flight; other lanes are black.
fn trace<W: Watch>(
    walks: &mut [Walk<W>; LANES],
    eyes: [Flight; LANES],
    in_flight: [bool; LANES],
) -> [Vec3; LANES] {
    // Entry d: what each lane owes at depth d.
    let mut stack: Vec<Level> = Vec::new();

    // Down, while any lane goes on.
    let (mut flights, mut live) = (eyes, in_flight);
    let mut depth = 0;
    while live.contains(&true) {
        // A lane whose ray has ended, or that never had one, keeps (0, 0): folding gives black.
        let mut level = [PendingBounce { local: Vec3::ZERO, k: 0.0 }; LANES];
        for lane in 0..LANES {
            if !live[lane] {
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
        depth += 1;
    }

    // Up, in all lanes.
    let mut colours = [Vec3::ZERO; LANES];
    while let Some(level) = stack.pop() {
        depth -= 1;
        colours = from_fn(|lane| walks[lane].fold(depth, level[lane], colours[lane]));
    }
    colours
}

/// Renders in packets of eight pixels side by side; the last of a row may be partial.
pub(crate) fn render(scene: &Compiled, grid: &Grid, film: &mut Film) -> Result<Counts, Error> {
    let n = grid.samples as usize;
    rows(grid, film, |pixels, rows| {
        let mut walks = from_fn(|_| Walk::new(scene, DEEPEST, ()));
        for (pixels, columns) in pixels.chunks_mut(LANES).zip(grid.columns.chunks(LANES * n)) {
            let mut sums = [Vec3::ZERO; LANES];
            for &row in rows {
                for i in 0..n {
                    let (eyes, live) = packet(&walks, |lane| columns.get(lane * n + i), row);
                    let colours = trace(&mut walks, eyes, live);
                    sums = from_fn(|lane| sums[lane] + colours[lane]);
                }
            }
            for (pixel, sum) in pixels.iter_mut().zip(sums) {
                *pixel = (sum / (n * n) as f32).to_array();
            }
        }
        walks.into_iter().try_fold(Counts::default(), |mut sum, walk| {
            sum.add(&walk.finish()?);
            Ok(sum)
        })
    })
}

/// Watches one eye ray, with its whole packet traced; the other lanes go unseen.
pub(crate) fn watch(
    scene: &Compiled,
    grid: &Grid,
    (column, row): (usize, usize),
    watch: &mut dyn Watch,
) -> Result<Vec3, Error> {
    let n = grid.samples as usize;
    let (pixel, i) = (column / n, column % n);
    let (first, seen) = (pixel - pixel % LANES, pixel % LANES);
    let mut watch = Some(watch);
    let mut walks =
        from_fn(|lane| Walk::new(scene, DEEPEST, if lane == seen { watch.take() } else { None }));
    let columns = |lane| grid.columns.get((first + lane) * n + i);
    let (eyes, live) = packet(&walks, columns, grid.rows[row]);
    let colours = trace(&mut walks, eyes, live);
    walks.into_iter().try_for_each(|walk| walk.finish().map(|_| ()))?;
    Ok(colours[seen])
}

/// The eye rays of a packet, and which lanes are in use. Idle lanes hold the middle column's ray.
fn packet<'a, W: Watch>(
    walks: &[Walk<W>; LANES],
    column: impl Fn(usize) -> Option<&'a f32>,
    row: f32,
) -> ([Flight; LANES], [bool; LANES]) {
    let eyes = from_fn(|lane| walks[lane].eye(column(lane).copied().unwrap_or(0.0), row));
    (eyes, from_fn(|lane| column(lane).is_some()))
}
