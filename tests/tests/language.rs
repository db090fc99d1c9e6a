//! How docstrings begin: with a verb or a noun, so that the first line stands alone.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;

use catoptric_tests::scenes::root;

use crate::house::sources;

/// Words that answer to a line above. "Whether", "What" and "How" are not among them: they begin
/// what stands for a noun.
const REFUSED: &[&str] = &[
    "And", "As", "At", "By", "For", "From", "In", "It", "Its", "Of", "On", "So", "That", "Their",
    "Them", "They", "Those", "To", "Where", "Which", "Whose", "With",
];

/// Crates with docstrings that still begin so, and how many. A number may only fall.
const OFFENCES: &[(&str, usize)] = &[("cli", 5)];

#[test]
fn docstrings_begin_with_a_verb_or_a_noun() {
    let mut found: BTreeMap<String, Vec<String>> = BTreeMap::new();
    for entry in fs::read_dir(root().join("crates")).expect("the crates") {
        let entry = entry.expect("an entry");
        let name = entry.file_name().to_string_lossy().into_owned();
        if entry.path().is_dir() {
            let files = sources(&format!("crates/{name}/src"));
            found.insert(name, files.iter().flat_map(|file| offences(file)).collect());
        }
    }
    let mut wrong = Vec::new();
    for (name, lines) in found {
        let allowed = OFFENCES.iter().find(|(listed, _)| *listed == name);
        let allowed = allowed.map_or(0, |(_, lines)| *lines);
        if lines.len() > allowed {
            let (many, told) = (lines.len(), lines.join("\n"));
            wrong.push(format!("{name}: {many} docstrings, and {allowed} are allowed\n{told}"));
        } else if lines.len() < allowed {
            wrong.push(format!("{name}: only {} left; lower its entry in OFFENCES", lines.len()));
        }
    }
    assert!(wrong.is_empty(), "{}", wrong.join("\n"));
}

/// The first lines of docstrings that begin with a word that is refused.
fn offences(file: &Path) -> Vec<String> {
    let text = fs::read_to_string(file).expect("a source file");
    let path = file.strip_prefix(root()).unwrap_or(file).display();
    let refused = first_lines(&text).into_iter().filter(|(_, line)| is_refused(line));
    refused.map(|(number, line)| format!("  {path}:{number}: {line}")).collect()
}

/// The first lines of a text's docstrings, with their numbers from 1.
fn first_lines(text: &str) -> Vec<(usize, &str)> {
    let mut first = Vec::new();
    let mut before = "";
    for (line, number) in text.lines().map(str::trim).zip(1..) {
        let mark = ["///", "//!"].into_iter().find(|mark| line.starts_with(mark)).unwrap_or("");
        if !mark.is_empty() && mark != before {
            first.push((number, line[mark.len()..].trim()));
        }
        before = mark;
    }
    first
}

fn is_refused(line: &str) -> bool {
    let end = line.find(|c: char| !c.is_alphanumeric() && c != '\'').unwrap_or(line.len());
    REFUSED.contains(&&line[..end])
}

#[test]
fn first_lines_are_found_and_judged() {
    let text = "//! Of a file.\n//! In it.\n\n/// Which one.\nfn a() {\n    /// Whether it is.\n    x\n}\n";
    let lines = first_lines(text);
    assert_eq!(lines, [(1, "Of a file."), (4, "Which one."), (6, "Whether it is.")]);
    let refused: Vec<_> = lines.iter().map(|(_, line)| is_refused(line)).collect();
    assert_eq!(refused, [true, true, false]);
}
