//! Why something is not explained.

use catoptric_core::StackFull;
use catoptric_ladder::DEEPEST;
use catoptric_scene::SceneError;
use catoptric_study::tracer::TooDeep;

/// Why a scene or a ray is not explained.
#[derive(Debug, thiserror::Error)]
pub enum ExplainError {
    /// The image has no such pixel.
    #[error(
        "pixel {x},{y} is not in the image of {width}x{height}: allowed are X from 0 to {} and Y from 0 to {}",
        .width - 1, .height - 1
    )]
    NoPixel {
        /// The column that was asked.
        x: u32,
        /// The row that was asked.
        y: u32,
        /// The image's columns.
        width: u32,
        /// The image's rows.
        height: u32,
    },
    /// A path of the scene's picture is too deep for the engine's stack.
    #[error(
        "{deep} of the engine, with max_depth {max_depth} and min_weight {min_weight}: lower the one or raise the other in the scene"
    )]
    PictureTooDeep {
        /// What the engine says.
        deep: TooDeep,
        /// The scene's.
        max_depth: u32,
        /// The scene's.
        min_weight: f64,
    },
    /// The ray's path is too deep to be written down.
    #[error(
        "the path has more than {DEEPEST} reflections, which are too many to write down: lower max_depth, which is {max_depth}, or raise min_weight in the scene"
    )]
    LifeTooDeep {
        /// The scene's.
        max_depth: u32,
    },
    /// The engine did not do what the recursion does.
    #[error(
        "the engine's account of pixel {x},{y} is not the recursion's: this is a fault of the program, please report it with the scene"
    )]
    Differs {
        /// The pixel's column.
        x: u32,
        /// The pixel's row.
        y: u32,
    },
    /// The scene has no smaller picture for the page.
    #[error("{0}")]
    NoSmallerPicture(SceneError),
    /// A path of the page's picture is too deep for the engine's stack.
    #[error("{0}: lower max_depth in the scene")]
    PagePictureTooDeep(StackFull),
}
