//! Scene to text.
//!
//! Both formats hold the same keys with the same values, and the values even have the same
//! spelling in both (`entries`); only the layout around them differs (`layout`).

mod entries;
mod layout;
mod names;
mod text;

use crate::{Scene, SceneFormat};

impl Scene {
    /// The scene as text that reads back to the same numbers, bit by bit.
    ///
    /// Keys stand in the order of the format. Image size, camera and depth are always
    /// written, other keys only where they differ from their defaults. Named materials keep their
    /// names and their order, also if no body has them. A material without a name stands inline or,
    /// if several bodies share it, once under the first free of the names m0, m1, ...
    #[must_use]
    pub fn to_text(&self, format: SceneFormat) -> String {
        let sections = entries::sections(self);
        match format {
            SceneFormat::Toml => layout::toml(&sections),
            SceneFormat::Json => layout::json(&sections),
        }
    }
}
