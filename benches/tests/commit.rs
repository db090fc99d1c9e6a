//! Which source was measured, as git says.

use std::fs;
use std::path::Path;
use std::process::Command;

use catoptric_benches::history::commit::of;
use tempfile::TempDir;

fn git(root: &Path, arguments: &[&str]) {
    let identity = ["-c", "user.name=Nobody", "-c", "user.email=nobody@example.org"];
    let output = Command::new("git").arg("-C").arg(root).args(identity).args(arguments).output();
    assert!(output.expect("git runs").status.success(), "{arguments:?}");
}

#[test]
fn changed_sources_are_marked_and_the_history_is_not_one() {
    let folder = TempDir::new().expect("a folder");
    let root = folder.path();
    assert_eq!(of(root), "unknown", "not a work tree");

    fs::create_dir(root.join("benches")).expect("a folder");
    let (source, history) = (root.join("source"), root.join("benches/history.csv"));
    fs::write(&source, "1").expect("a file");
    fs::write(&history, "1").expect("a file");
    git(root, &["init", "--quiet"]);
    assert_eq!(of(root), "unknown", "no commit yet");
    git(root, &["add", "."]);
    git(root, &["commit", "--quiet", "--no-gpg-sign", "-m", "first"]);
    let clean = of(root);
    assert!(clean.len() >= 4 && clean.chars().all(|c| c.is_ascii_hexdigit()), "{clean}");

    fs::write(root.join("picture"), "1").expect("a file");
    assert_eq!(of(root), clean, "an untracked file is no source");
    fs::write(&history, "2").expect("a file");
    assert_eq!(of(root), clean, "recording does not change what is measured");
    fs::write(&source, "2").expect("a file");
    assert_eq!(of(root), clean + "+");
}
