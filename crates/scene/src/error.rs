//! What can be wrong with a scene, said in terms of the user's file.

/// A scene that cannot be used.
#[derive(Debug, thiserror::Error)]
#[error("{0}")]
pub struct SceneError(pub(crate) String);
