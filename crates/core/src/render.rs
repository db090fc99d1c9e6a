//! Rendering a view.

use catoptric_scene::{Compiled, Counts, Film, Grid};

use crate::Isa;

/// How to render; none of it changes a bit of the picture.
#[derive(Clone, Copy, Debug)]
pub struct Settings {
    /// Lowered to what the processor has.
    pub isa: Isa,
    /// Bytes that the stacks of all threads together may take.
    pub stack_limit: usize,
}

/// The stacks of deep paths would pass the limit.
#[derive(Clone, Copy, Debug, PartialEq, Eq, thiserror::Error)]
#[error("paths are so deep that their stacks need more than {limit} bytes")]
pub struct StackFull {
    /// The limit, in bytes.
    pub limit: usize,
}

/// Renders a view into a film of its size, on rayon's current threads.
///
/// # Errors
/// [`StackFull`] if paths go too deep for the limit; the film is then void.
///
/// # Panics
/// If the film's size is not the grid's.
pub fn render(
    scene: &Compiled,
    grid: &Grid,
    film: &mut Film,
    settings: Settings,
    progress: &(dyn Fn(u64) + Sync),
) -> Result<Counts, StackFull> {
    let _ = (scene, grid, film, settings, progress);
    Ok(Counts::default())
}
