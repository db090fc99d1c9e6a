//! A picture that may be timed, since it has been checked.

use catoptric_scene::{Compiled, Counts, Film, Grid, Scene, View};
use catoptric_tests::identity;

/// A scene, compiled, with its grid and the picture that the recursion made of it.
///
/// Everything that a timed rendering reads is made here, before any clock runs.
pub struct Subject {
    /// What it is called in reports.
    pub name: String,
    /// The constants that both renderers start from.
    pub compiled: Compiled,
    /// The whole picture, one sample a pixel.
    pub grid: Grid,
    expected: Film,
    counts: Counts,
}

impl Subject {
    /// Renders the scene by the recursion and by every backend of the engine that this
    /// processor has, and compares pictures and ray counts bit for bit.
    ///
    /// # Panics
    /// If any of them differs: what computes something else is not timed.
    #[must_use]
    pub fn checked(name: &str, scene: &Scene) -> Self {
        identity::assert_identical(name, scene);
        let compiled = Compiled::new(scene);
        let grid = Grid::new(&View::whole(scene));
        let (expected, counts) = identity::recursive(&compiled, &grid);
        Self { name: name.to_owned(), compiled, grid, expected, counts }
    }

    /// Rays of the picture, logical: eye, reflection and shadow rays of all depths.
    #[must_use]
    pub fn rays(&self) -> u64 {
        self.eye_rays() + self.counts.reflection() + self.counts.shadow()
    }

    /// Eye rays alone: one a pixel.
    #[must_use]
    pub fn eye_rays(&self) -> u64 {
        self.counts.primary()
    }

    /// A black film of the picture's size.
    #[must_use]
    pub fn film(&self) -> Film {
        Film::new(self.grid.width, self.grid.height)
    }

    /// Checks a film on which this subject was timed.
    ///
    /// # Panics
    /// If it is not the recursion's picture, compared as bits; a NaN equals a NaN.
    pub fn confirm(&self, film: &Film) {
        let same = |a: f32, b: f32| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        let (found, expected) = (film.pixels().as_flattened(), self.expected.pixels());
        let equal = found.iter().zip(expected.as_flattened()).all(|(&a, &b)| same(a, b));
        let sizes = (film.width(), film.height()) == (self.grid.width, self.grid.height);
        assert!(sizes && equal, "{}: the timed picture is not the recursion's", self.name);
    }
}
