//! How a rung is compared with the recursion: picture, counts, and the log of every eye ray.

use catoptric_core::{Isa, Settings};
use catoptric_ladder::{Event, RUNGS, Rung};
use catoptric_scene::{Compiled, Film, Grid, Scene, View};
use catoptric_tests::identity::{different_pixels, pool, recursive};

/// What a rung has otherwise than the recursion; all `None` where it has the same.
#[derive(Debug, Default)]
pub(crate) struct Difference {
    pub(crate) picture: Option<String>,
    pub(crate) counts: Option<String>,
    pub(crate) log: Option<String>,
}

impl Difference {
    /// Compares a rung on one view. Pictures and counts are compared with the reference's, logs
    /// with those of rung 0.
    pub(crate) fn new(rung: &Rung, isa: Isa, scene: &Compiled, grid: &Grid) -> Self {
        let (expected, expected_counts) = recursive(scene, grid);
        let mut film = Film::new(grid.width, grid.height);
        let counts = pool(2)
            .install(|| (rung.render)(scene, grid, &mut film, settings(isa)))
            .unwrap_or_else(|error| panic!("{}: {error}", rung.name));
        let mut log = None;
        for at in eye_rays(grid) {
            let expected = watched(&RUNGS[0], isa, scene, grid, at);
            let found = watched(rung, isa, scene, grid, at);
            let differs = expected.iter().zip(&found).position(|(a, b)| !a.agrees(b));
            if differs.is_some() || expected.len() != found.len() {
                let first = differs.unwrap_or(expected.len().min(found.len()));
                log = Some(format!(
                    "eye ray {at:?}, event {first}: {:?}, but {:?}",
                    expected.get(first),
                    found.get(first)
                ));
                break;
            }
        }
        Self {
            picture: different_pixels(&expected, &film),
            counts: (counts != expected_counts).then(|| format!("{expected_counts:?}\n{counts:?}")),
            log,
        }
    }

    pub(crate) fn is_none(&self) -> bool {
        self.picture.is_none() && self.counts.is_none() && self.log.is_none()
    }
}

/// Where the eye rays of a grid stand.
pub(crate) fn eye_rays(grid: &Grid) -> impl Iterator<Item = (usize, usize)> {
    let columns = grid.columns.len();
    (0..grid.rows.len()).flat_map(move |row| (0..columns).map(move |column| (column, row)))
}

/// How the engine runs here.
pub(crate) fn settings(isa: Isa) -> Settings {
    Settings { isa, stack_limit: 2 << 30 }
}

/// Every rung on every instruction set of this processor that makes a difference to it.
pub(crate) fn rungs() -> impl Iterator<Item = (Rung, Isa)> {
    let isas = || Isa::ALL.into_iter().filter(|&isa| isa <= Isa::detected());
    let of = move |rung: Rung| {
        let all = isas().filter(move |&isa| rung.name == "r5" || isa == Isa::detected());
        all.map(move |isa| (rung, isa))
    };
    RUNGS.into_iter().flat_map(of)
}

/// The log of one eye ray.
pub(crate) fn watched(
    rung: &Rung,
    isa: Isa,
    scene: &Compiled,
    grid: &Grid,
    at: (usize, usize),
) -> Vec<Event> {
    // On a thread whose stack holds deep paths.
    pool(1).install(|| {
        let mut log = Vec::new();
        let colour = (rung.watch)(scene, grid, at, settings(isa), &mut log)
            .unwrap_or_else(|error| panic!("{}: {error}", rung.name));
        if rung.bit_identical {
            assert_eq!(log.last(), Some(&Event::Return { depth: 0, colour }), "{}", rung.name);
        }
        log
    })
}

/// The scene with its whole view, compiled.
pub(crate) fn view(scene: &Scene, samples: u32) -> (Compiled, Grid) {
    let view = View::new(scene, None, samples).expect("whole");
    (Compiled::new(scene), Grid::new(&view))
}
