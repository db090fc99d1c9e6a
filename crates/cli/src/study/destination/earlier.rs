//! A report that a folder holds already.
//!
//! Its document lists its files, with a sum of what each holds. Anybody can write such a list;
//! a file that is listed is removed only if it holds what the list says, so that it was there
//! as it is when the list was made.

use std::ffi::OsStr;
use std::fs::{self, File};
use std::io::Read;
use std::path::Path;

use catoptric_report::{SCHEMA, Sum};
use serde::Deserialize;

/// What the files of a report end with.
const ENDINGS: [&str; 6] = ["html", "json", "md", "csv", "svg", "png"];

/// The longest document that is read; real ones have some hundred kilobytes.
const MOST: u64 = 256 << 20;

/// A report's document, as far as it is needed here.
#[derive(Deserialize)]
pub(super) struct Earlier {
    schema: String,
    study: String,
    /// Reports of before it was kept have none.
    #[serde(default)]
    sums: Vec<Sum>,
}

impl Earlier {
    /// The report of a study in a folder, if there is one.
    pub(super) fn find(folder: &Path, study: &str) -> Option<Self> {
        let bytes = read(&folder.join(format!("{study}.json")), MOST)?;
        let found: Self = serde_json::from_slice(&bytes).ok()?;
        (found.schema == SCHEMA && found.study == study).then_some(found)
    }

    /// Removes its files that are stale, and returns those that are not as it wrote them, which
    /// are left alone.
    pub(super) fn remove(&self, folder: &Path, stale: impl Fn(&str) -> bool) -> Vec<&str> {
        let mut kept = Vec::new();
        let listed = self.sums.iter().filter(|sum| is_of_a_report(&sum.file) && stale(&sum.file));
        for sum in listed {
            let path = folder.join(&sum.file);
            // Gone already is as good.
            let Ok(found) = fs::symlink_metadata(&path) else { continue };
            let as_written = found.is_file()
                && found.len() == sum.bytes
                && read(&path, sum.bytes).is_some_and(|bytes| Sum::of(&sum.file, &bytes) == *sum);
            if !as_written || fs::remove_file(&path).is_err() {
                kept.push(sum.file.as_str());
            }
        }
        kept
    }
}

/// Whether a name can be that of a report's file: in the folder, and of one of its formats.
pub(super) fn is_of_a_report(name: &str) -> bool {
    let path = Path::new(name);
    let ending = path.extension().and_then(OsStr::to_str);
    path.file_name() == Some(OsStr::new(name)) && ending.is_some_and(|e| ENDINGS.contains(&e))
}

/// What a regular file holds, if it has at most that many bytes. Opening anything else, such as
/// a pipe, could wait for ever.
fn read(path: &Path, most: u64) -> Option<Vec<u8>> {
    let regular = fs::metadata(path).is_ok_and(|found| found.is_file() && found.len() <= most);
    let file = regular.then(|| File::open(path).ok()).flatten()?;
    let mut bytes = Vec::new();
    file.take(most).read_to_end(&mut bytes).ok()?;
    Some(bytes)
}
