//! Words that every explanation uses.

use catoptric_scene::{Numerics, Scene, shown};

/// Columns of a scene's name among words.
const NAME: usize = 480;

/// The scene's name, as a terminal can show it.
pub(crate) fn name(scene: &str) -> String {
    shown(scene, NAME)
}

/// The scene's formulas: `robust` or `textbook`.
pub(crate) fn numerics(scene: &Scene) -> &'static str {
    match scene.render.numerics {
        Numerics::Robust => "robust",
        Numerics::Textbook => "textbook",
    }
}
