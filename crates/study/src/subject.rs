//! Scenes that a study is made of.

use catoptric_scene::{Draft, Scene};

/// A scene and what reports call it.
#[derive(Clone, Debug)]
pub struct Subject {
    /// A file's stem, or the name of a family.
    pub name: String,
    /// The scene.
    pub scene: Scene,
}

impl Subject {
    /// The same scene with something changed.
    ///
    /// # Panics
    /// If the change makes it invalid; a study changes sizes, depths and weights within
    /// their ranges.
    #[must_use]
    pub fn with(&self, change: impl FnOnce(&mut Draft)) -> Scene {
        let mut draft = self.scene.clone().into_draft();
        change(&mut draft);
        Scene::new(draft).expect("a change within what is allowed")
    }

    /// The same scene to another depth.
    #[must_use]
    pub fn to_depth(&self, max_depth: u32) -> Scene {
        self.with(|draft| draft.render.max_depth = max_depth)
    }
}
