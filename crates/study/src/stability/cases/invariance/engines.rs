//! Pictures of both engines, compared as bits.

use catoptric_scene::{Compiled, Draft, Film, Grid, Scene, View};

use crate::formula::{Formula, pixels};
use crate::tracer::{Renders, Tracer};

/// The pictures of both engines, one after the other.
pub(super) fn both(formula: Formula, draft: &Draft) -> Vec<[f64; 3]> {
    fn recursion<S: Renders>(scene: &Scene) -> Vec<[f64; 3]> {
        let grid = Grid::of(&View::whole(scene));
        let mut film: Film<S> = Film::black(grid.width, grid.height);
        Tracer::Recursive.render(&Compiled::of(scene), &grid, &mut film).expect("depth 20");
        pixels(&film)
    }
    let mut both = formula.picture(draft).expect("depth 20");
    let scene = formula.scene(draft);
    both.extend(match formula {
        Formula::RobustF64 => recursion::<f64>(&scene),
        Formula::TextbookF32 | Formula::RobustF32 => recursion::<f32>(&scene),
    });
    both
}

/// Pixels with other bits.
pub(super) fn differing(a: &[[f64; 3]], b: &[[f64; 3]]) -> usize {
    a.iter().zip(b).filter(|(a, b)| a.map(f64::to_bits) != b.map(f64::to_bits)).count()
}
