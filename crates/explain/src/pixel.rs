//! The pixel whose ray is followed.

use catoptric_scene::Scene;

use crate::error::ExplainError;

/// A pixel of the image; 0, 0 is the top left.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Pixel {
    /// The pixel's column.
    pub x: u32,
    /// The pixel's row.
    pub y: u32,
}

impl Pixel {
    /// Checks that the scene's image has it.
    ///
    /// # Errors
    /// [`ExplainError::NoPixel`], which says which pixels there are.
    pub fn check(self, scene: &Scene) -> Result<(), ExplainError> {
        let (width, height) = (scene.image.width, scene.image.height);
        let Self { x, y } = self;
        if x < width && y < height {
            Ok(())
        } else {
            Err(ExplainError::NoPixel { x, y, width, height })
        }
    }
}
