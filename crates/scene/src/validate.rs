//! The ranges of the scene format.

use crate::{Draft, SceneError};

pub(crate) fn validate(_draft: &Draft) -> Result<(), SceneError> {
    Ok(())
}
