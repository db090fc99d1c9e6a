//! Tells the program which commit it is built from.

use std::process::Command;

fn main() {
    // A change of the sources, or of what they are compared with.
    println!("cargo::rerun-if-changed=..");
    if let Some(head) = git(&["rev-parse", "--git-path", "logs/HEAD"]) {
        println!("cargo::rerun-if-changed={head}");
    }
    println!("cargo::rustc-env=CATOPTRIC_COMMIT={}", commit().as_deref().unwrap_or("unknown"));
}

/// The short commit, with `+` where the crates differ from it.
fn commit() -> Option<String> {
    let commit = git(&["rev-parse", "--short", "HEAD"])?;
    let changes = git(&["status", "--porcelain", "--untracked-files=no", "--", ".."])?;
    Some(if changes.is_empty() { commit } else { commit + "+" })
}

/// What git printed, trimmed, if it succeeded.
fn git(arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
