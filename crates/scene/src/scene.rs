//! A scene that is known to be valid.

use std::ops::Deref;

use crate::{Draft, SceneError, validate::validate};

/// A valid scene: every number is finite and in its range, also in f32 once compiled.
///
/// Read it like a [`Draft`]; to change it, take the draft out and validate again.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    draft: Draft,
}

impl Scene {
    /// Validates a draft.
    ///
    /// # Errors
    /// The first key, in the order of the format, whose value is not allowed.
    pub fn new(draft: Draft) -> Result<Self, SceneError> {
        validate(&draft)?;
        Ok(Self { draft })
    }

    /// The plain description, for changing it.
    #[must_use]
    pub fn into_draft(self) -> Draft {
        self.draft
    }
}

impl Deref for Scene {
    type Target = Draft;

    fn deref(&self) -> &Draft {
        &self.draft
    }
}
