//! The scenes that a study is made of.

use std::path::{Path, PathBuf};

use catoptric_study::subject::Subject;

use crate::exit::Failure;
use crate::input::is_stream;
use crate::scene;

/// Reads scenes. Their names are the files' stems, with a number where two are alike, so that
/// each has files of its own in a report.
///
/// # Errors
/// Exit code 3.
pub(super) fn load(paths: &[PathBuf]) -> Result<Vec<Subject>, Failure> {
    let mut subjects: Vec<Subject> = Vec::new();
    for path in paths {
        let mut subject = read(path)?;
        let stem = subject.name.clone();
        let mut number = 1;
        while subjects.iter().any(|earlier| earlier.name == subject.name) {
            number += 1;
            subject.name = format!("{stem}-{number}");
        }
        subjects.push(subject);
    }
    Ok(subjects)
}

fn read(path: &Path) -> Result<Subject, Failure> {
    let scene = scene::read(path)?;
    let stem = path.file_stem().filter(|_| !is_stream(path));
    let name = stem.map_or_else(|| "stdin".to_owned(), |stem| plain(&stem.to_string_lossy()));
    Ok(Subject { name, scene })
}

/// A name that files and addresses can hold.
fn plain(stem: &str) -> String {
    stem.chars().map(|c| if c.is_alphanumeric() || "-_".contains(c) { c } else { '-' }).collect()
}
