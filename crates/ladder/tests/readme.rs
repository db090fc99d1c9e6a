//! The code that the README shows is that of the files.

use std::fs;
use std::path::Path;

use catoptric_ladder::RUNGS;

/// Lines without indentation, so that a part of a function can be shown.
fn lines(text: &str) -> Vec<&str> {
    text.lines().map(str::trim).collect()
}

#[test]
fn shows_the_code_as_it_is() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let readme = fs::read_to_string(folder.join("README.md")).expect("the README");
    let blocks: Vec<&str> = readme.split("```rust\n").skip(1).collect();
    assert!(blocks.len() > 8, "the README shows code");
    for block in blocks {
        let (block, _) = block.split_once("```").expect("a block ends");
        let (file, shown) = block.split_once('\n').expect("a block starts with its file");
        let file = file.strip_prefix("// ").expect("a block starts with its file");
        let source = fs::read_to_string(folder.join("src").join(file)).expect(file);
        let (shown, source) = (lines(shown), lines(&source));
        let found = source.windows(shown.len()).any(|part| part == shown);
        assert!(found, "{file} does not hold\n{}", shown.join("\n"));
    }
}

#[test]
fn shows_the_bytes_of_a_level() {
    let readme = include_str!("../README.md");
    for rung in RUNGS {
        let mut rows =
            readme.lines().filter(|line| line.starts_with(&format!("| {} |", rung.name)));
        let cells: Vec<_> = rows.next().expect("a row").split('|').map(str::trim).collect();
        let bytes = cells[cells.len() - 2].parse().unwrap_or(0);
        assert_eq!(bytes, rung.level_bytes, "{}", rung.name);
    }
}
