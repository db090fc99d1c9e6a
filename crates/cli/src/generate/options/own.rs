//! What every family's own options do.

use catoptric_scene::Draft;
use catoptric_scene::family::OutOfRange;

use crate::generate::recipe::Recipe;

/// What a family's own options make.
pub(in crate::generate) trait Own {
    /// The subcommand's name.
    fn name(&self) -> &'static str;

    /// The scene.
    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange>;

    /// The command with every own option.
    fn recipe(&self) -> Recipe;
}
