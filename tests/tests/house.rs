//! The house rules of `crates/README.md`: which way the arrows point, and what stands where.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};

use cargo_metadata::{DependencyKind, MetadataCommand};
use catoptric_tests::scenes::root;

/// Every package of the workspace, and which packages of the workspace it may depend on.
/// Dependencies for its tests alone are not arrows.
const ARROWS: &[(&str, &[&str])] = &[
    ("catoptric-scene", &[]),
    ("catoptric-reference", &["catoptric-scene"]),
    ("catoptric-core", &["catoptric-scene"]),
    ("catoptric-ladder", &["catoptric-core", "catoptric-reference", "catoptric-scene"]),
    ("catoptric-report", &[]),
    (
        "catoptric-study",
        &[
            "catoptric-core",
            "catoptric-ladder",
            "catoptric-reference",
            "catoptric-report",
            "catoptric-scene",
        ],
    ),
    (
        "catoptric-explain",
        &[
            "catoptric-core",
            "catoptric-ladder",
            "catoptric-report",
            "catoptric-scene",
            "catoptric-study",
        ],
    ),
    (
        "catoptric-cli",
        &[
            "catoptric-core",
            "catoptric-explain",
            "catoptric-reference",
            "catoptric-report",
            "catoptric-scene",
            "catoptric-study",
        ],
    ),
    ("catoptric-tests", &["catoptric-core", "catoptric-reference", "catoptric-scene"]),
    (
        "catoptric-benches",
        &[
            "catoptric-core",
            "catoptric-reference",
            "catoptric-report",
            "catoptric-scene",
            "catoptric-tests",
        ],
    ),
];

#[test]
fn arrows_point_down() {
    let metadata = MetadataCommand::new()
        .manifest_path(root().join("Cargo.toml"))
        .no_deps()
        .exec()
        .expect("cargo metadata");
    let members: BTreeSet<_> =
        metadata.workspace_packages().iter().map(|package| package.name.to_string()).collect();
    let listed: BTreeSet<_> = ARROWS.iter().map(|(name, _)| (*name).to_owned()).collect();
    assert_eq!(members, listed, "every package stands in the table");

    let allowed: BTreeMap<_, _> = ARROWS.iter().copied().collect();
    for package in metadata.workspace_packages() {
        let normal = package.dependencies.iter().filter(|d| d.kind == DependencyKind::Normal);
        for dependency in normal.filter(|d| members.contains(&d.name)) {
            assert!(
                allowed[package.name.as_str()].contains(&dependency.name.as_str()),
                "{} may not depend on {}",
                package.name,
                dependency.name
            );
        }
    }
}

#[test]
fn wide_and_unsafe_stand_in_one_folder() {
    for file in sources("crates").into_iter().chain(sources("tests/src")) {
        if file.components().any(|part| part.as_os_str() == "simd") {
            continue;
        }
        for line in code(&file) {
            assert!(!line.contains("wide::"), "{}: {line}", file.display());
            let unsafe_code = line.contains("unsafe ") || line.contains("unsafe_code");
            assert!(!unsafe_code, "{}: {line}", file.display());
        }
    }
}

/// Clocks, environment, thread counts and files are the business of programs and tests.
#[test]
fn the_libraries_touch_nothing_outside() {
    let outside =
        ["std::time", "std::env", "std::fs", "std::io", "std::process", "ThreadPool", "println!"];
    for library in ["scene", "reference", "core", "ladder"] {
        for file in sources(&format!("crates/{library}/src")) {
            for line in code(&file) {
                let named = outside.iter().find(|name| line.contains(**name));
                assert_eq!(named, None, "{}: {line}", file.display());
            }
        }
    }
}

#[test]
fn no_file_is_called_util_or_common() {
    for file in sources("crates").into_iter().chain(sources("tests")).chain(sources("benches")) {
        for part in file.components() {
            let name = Path::new(part.as_os_str()).file_stem().unwrap_or_default();
            assert!(!["util", "utils", "common", "misc", "helpers"].iter().any(|n| name == *n));
        }
    }
}

#[test]
fn the_top_level_is_the_owners() {
    let fixed = ["Cargo.toml", "crates", "benches", "tests", "scenes", "README.md"];
    let beside = ["Cargo.lock", "LICENSE-MIT", "LICENSE-APACHE", "target"];
    for entry in fs::read_dir(root()).expect("the workspace") {
        let name = entry.expect("an entry").file_name().to_string_lossy().into_owned();
        // What .gitignore keeps out of the repository: pictures that somebody rendered here.
        let picture = [".png", ".ppm", ".pfm"].iter().any(|ending| name.ends_with(ending));
        let known = fixed.contains(&name.as_str()) || beside.contains(&name.as_str());
        assert!(known || picture || name.starts_with('.'), "{name} at the top level");
    }
}

/// Lines without comments.
fn code(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).expect("a source file");
    let lines = text.lines().map(|line| line.split("//").next().unwrap_or_default().to_owned());
    lines.collect()
}

/// All Rust files below a folder of the workspace.
pub(crate) fn sources(folder: &str) -> Vec<PathBuf> {
    let mut found = Vec::new();
    let mut folders = vec![root().join(folder)];
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of the workspace") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|e| e == "rs") {
                found.push(path);
            }
        }
    }
    assert!(!found.is_empty(), "{folder} has source files");
    found
}
