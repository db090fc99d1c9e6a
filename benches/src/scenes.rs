//! The scenes that are timed as whole pictures.

use catoptric_scene::Draft;
use catoptric_scene::family::Sphereflake;
use catoptric_tests::scenes::named;

/// The workshop, five spheres and one lamp: the headline.
#[must_use]
pub fn workshop() -> Draft {
    named("workshop")
}

/// Two mirrors face to face: nearly every path goes on to `max_depth`.
#[must_use]
pub fn corridor() -> Draft {
    named("corridor")
}

/// A sphereflake of 91 balls on a plane under three lamps: every ray tries many primitives,
/// and paths end early and unevenly.
///
/// # Panics
/// If the family no longer takes two levels.
#[must_use]
pub fn flake() -> Draft {
    let flake = Sphereflake { levels: 2, ..Sphereflake::default() }.draft().expect("two levels");
    assert_eq!(flake.spheres.len(), 91, "the balls of two levels");
    flake
}
