//! What robust costs over textbook: both trace the workshop's scene, one after the other; once
//! as they are rendered, and once with nothing left out on either side, which compares the
//! formulas alone.

use std::time::Instant;

use catoptric_core::Isa;
use catoptric_report::{Column, Table};
use catoptric_scene::{Compiled, Film, Grid, View};

use super::cases::scenes::workshop;
use crate::formula::Formula;
use crate::tracer::Tracer;
use crate::way::Way;

/// Renderings of each.
const ROUNDS: usize = 21;

/// Robust's time over textbook's that is asked.
const ASKED: f64 = 1.05;

const COLUMNS: &[Column] = &[
    Column { key: "tested", heading: "tested", meaning: "scene and size" },
    Column { key: "rounds", heading: "rounds", meaning: "renderings of each, in alternation" },
    Column { key: "textbook_ms", heading: "textbook", meaning: "least trace time, ms" },
    Column { key: "robust_ms", heading: "robust", meaning: "least trace time, ms" },
    Column {
        key: "ratio_of_minima",
        heading: "minima",
        meaning: "robust's least time over textbook's; at most 1.05 is asked",
    },
    Column {
        key: "median_of_ratios",
        heading: "median",
        meaning: "median over the rounds of robust's time over textbook's",
    },
    Column {
        key: "verdict",
        heading: "verdict",
        meaning: "whether the ratio of the minima is at most 1.05",
    },
];

/// Measures on rayon's current threads: a timing, so a quiet machine is the reader's business.
pub(crate) fn table() -> Table {
    let caption = "What robust costs over textbook in trace time, packet engine, rendered in alternation; at most 5 % is asked. Textbook's shadow rays and tiles know no omission, so only the second row compares formulas.";
    let mut table = Table::new("cost", COLUMNS, caption);
    let isa = Isa::detected();
    let ways = [
        ("as rendered", Way::Tracer(Tracer::Packet(isa))),
        ("nothing left out on either side", Way::Everything(isa)),
    ];
    for (omissions, way) in ways {
        let Cost { least: [textbook, robust], median } = measure(way);
        let ratio = robust / textbook;
        table.push([
            format!("the workshop's scene, 640x480, depth 5, {omissions}").into(),
            ROUNDS.into(),
            textbook.into(),
            robust.into(),
            ratio.into(),
            median.into(),
            if ratio <= ASKED { "holds" } else { "does not hold" }.into(),
        ]);
    }
    table
}

/// Times of textbook and robust.
struct Cost {
    /// ms
    least: [f64; 2],
    /// The median of robust's time over textbook's.
    median: f64,
}

fn measure(way: Way) -> Cost {
    let scenes = Formula::F32.map(|formula| {
        let scene = formula.scene(&workshop(640, 480, 5, 0.0));
        (Compiled::new(&scene), Grid::new(&View::whole(&scene)))
    });
    let time = |(compiled, grid): &(Compiled, Grid)| {
        let mut film = Film::new(grid.width, grid.height);
        let begun = Instant::now();
        way.render(compiled, grid, &mut film).expect("depth 5");
        begun.elapsed().as_secs_f64() * 1e3
    };
    // The first of each brings code and pages in.
    for scene in &scenes {
        let _ = time(scene);
    }
    let rounds: [[f64; 2]; ROUNDS] = std::array::from_fn(|round| {
        // Who goes first alternates too.
        let first = round % 2;
        let (a, b) = (time(&scenes[first]), time(&scenes[1 - first]));
        if first == 0 { [a, b] } else { [b, a] }
    });
    let least = [0, 1].map(|which| rounds.iter().map(|r| r[which]).fold(f64::INFINITY, f64::min));
    let mut ratios = rounds.map(|[textbook, robust]| robust / textbook);
    ratios.sort_by(f64::total_cmp);
    Cost { least, median: ratios[ROUNDS / 2] }
}
