//! The scenes of `scenes/`.

use std::path::{Path, PathBuf};

use catoptric_scene::{Document, Draft, Scene, SceneFormat};

/// The workspace's root.
#[must_use]
pub fn root() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).parent().expect("tests/ has a parent").to_owned()
}

/// Every scene of `scenes/` with its name, by name.
///
/// # Panics
/// If one cannot be read; a broken scene is a failed test.
#[must_use]
pub fn all() -> Vec<(String, Draft)> {
    let folder = root().join("scenes");
    let mut paths: Vec<_> = std::fs::read_dir(&folder)
        .expect("scenes/ can be listed")
        .map(|entry| entry.expect("an entry of scenes/").path())
        .filter(|path| path.extension().is_some_and(|e| e == "toml" || e == "json"))
        .collect();
    paths.sort();
    paths.iter().map(|path| (stem(path), load(path))).collect()
}

/// One scene of `scenes/`, by its stem.
///
/// # Panics
/// If it cannot be read.
#[must_use]
pub fn named(stem: &str) -> Draft {
    load(&root().join("scenes").join(stem).with_extension("toml"))
}

/// The draft as a scene of another size and depth.
///
/// # Panics
/// If it is not valid.
#[must_use]
pub fn sized(draft: &Draft, width: u32, height: u32, max_depth: u32) -> Scene {
    let mut draft = draft.clone();
    draft.image.width = width;
    draft.image.height = height;
    draft.render.max_depth = max_depth;
    Scene::new(draft).expect("a valid scene")
}

fn load(path: &Path) -> Draft {
    let text = std::fs::read(path).expect("a scene can be read");
    let document = Document::parse(&path.display().to_string(), &text, SceneFormat::of_path(path));
    document.unwrap_or_else(|error| panic!("{error}")).draft().clone()
}

fn stem(path: &Path) -> String {
    path.file_stem().expect("a file").to_string_lossy().into_owned()
}
