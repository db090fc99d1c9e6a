//! Which source was measured.

use std::path::Path;
use std::process::Command;

/// The short commit of the work tree at `root`, with `+` where tracked files other than the
/// history itself differ from it; `unknown` without git.
#[must_use]
pub fn of(root: &Path) -> String {
    let Some(commit) = git(root, &["rev-parse", "--short", "HEAD"]) else {
        return "unknown".to_owned();
    };
    let status = ["status", "--porcelain", "--untracked-files=no", "--", ".", HISTORY];
    // A tree whose state cannot be had is not known to be clean.
    let dirty = git(root, &status).is_none_or(|changes| !changes.is_empty());
    if dirty { commit + "+" } else { commit }
}

/// Recording changes it, which is not a change of what is measured.
const HISTORY: &str = ":(exclude)benches/history.csv";

/// What git printed, trimmed, if it succeeded.
fn git(root: &Path, arguments: &[&str]) -> Option<String> {
    let output = Command::new("git").arg("-C").arg(root).args(arguments).output().ok()?;
    let text = String::from_utf8(output.stdout).ok()?;
    output.status.success().then(|| text.trim().to_owned())
}
