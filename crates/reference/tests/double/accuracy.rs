//! The recursion in f64 against double-double truth.

use catoptric_reference::double;
use catoptric_reference::truth::Precision;
use catoptric_scene::{Compiled, Film, Grid, Scene, View};

use crate::truth::scenes::{closed_room, render, workshop};

/// Measured, largest error and RMSE: 6.0e-14 and 8.4e-16 with the matt ground, 6.7e-13 and
/// 2.9e-15 with one that mirrors, in the closed room 1.9e-13 and 2.1e-15.
/// No ray meets, and no shadow falls, elsewhere than in truth.
#[test]
fn f64_is_within_its_rounding_of_truth() {
    for (name, draft, largest, rmse) in [
        ("matt ground", workshop(320, 240, 8, 0.0), 2e-13, 2e-15),
        ("mirror ground", workshop(320, 240, 8, 0.3), 2e-12, 1e-14),
        ("closed room", closed_room(160, 120, 3), 1e-12, 6e-15),
    ] {
        let truth = render(&draft, Precision::DoubleDouble);
        let scene = Scene::new(draft).expect("valid");
        let grid = Grid::<f64>::of(&View::whole(&scene));
        let mut film = Film::black(grid.width, grid.height);
        let counts = double::render(&Compiled::of(&scene), &grid, &mut film, &|_| ());
        assert_eq!(counts.expect("shallow"), truth.counts, "{name}");

        let channels = film.pixels().as_flattened().iter().zip(truth.pixels.as_flattened());
        let errors: Vec<f64> = channels.map(|(found, truth)| (found - truth).abs()).collect();
        let max = errors.iter().copied().fold(0.0, f64::max);
        let mean_square = errors.iter().map(|e| e * e).sum::<f64>() / errors.len() as f64;
        let error = format!("{name}: largest {max:e}, RMSE {:e}", mean_square.sqrt());
        assert!(max < largest && mean_square.sqrt() < rmse, "{error}");
        // As many digits from truth itself would mean that it was compared with itself.
        assert!(max > 1e-15, "{error}");
        println!("{error}");
    }
}
