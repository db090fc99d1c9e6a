//! Where a report goes: stdout, or the files of a folder.

use std::ffi::OsStr;
use std::fs;
use std::path::{Path, PathBuf};

use catoptric_study::occasion::Occasion;
use catoptric_study::report::{self, Report};
use serde_json::Value;

use super::options::Common;
use crate::exit::{Failure, say};
use crate::input::is_stream;
use crate::output::{Target, commit};

/// Looked at before hours of measuring.
pub(super) struct Destination {
    folder: Option<PathBuf>,
    /// Files of an earlier report of the same study in that folder.
    earlier: Vec<String>,
    json: bool,
    quiet: bool,
}

/// What the files of a report end with.
const ENDINGS: [&str; 6] = ["html", "json", "md", "csv", "svg", "png"];

impl Destination {
    /// Makes the folder, if one is asked for and is not there.
    ///
    /// # Errors
    /// Exit code 2 for stdout, which is no folder; 4 for a folder that cannot be written, or
    /// that holds the report of another study, whose page would be lost.
    pub(super) fn new(common: &Common, study: &str) -> Result<Self, Failure> {
        let mut earlier = Vec::new();
        if common.json || common.output.is_none() {
            Target::stdout()?;
        }
        if let Some(folder) = &common.output {
            if is_stream(folder) {
                return Err(Failure::wrong_use(
                    "-o names a folder, and - is none: use --json, or leave -o out, for stdout",
                ));
            }
            fs::create_dir_all(folder).map_err(|error| {
                let folder = folder.display();
                Failure::not_written(format_args!(
                    "folder {folder} cannot be made: {error}; name another one with -o"
                ))
            })?;
            Target::new(&folder.join("index.html"))?.probe()?;
            for (name, files) in reports(folder) {
                if name != study {
                    let folder = folder.display();
                    return Err(Failure::not_written(format_args!(
                        "folder {folder} holds a report of study {name}, whose page would be \
                         lost; name another one with -o"
                    )));
                }
                earlier = files;
            }
        }
        let Common { output, json, quiet, .. } = common;
        Ok(Self { folder: output.clone(), earlier, json: *json, quiet: *quiet })
    }

    /// Writes all files of the folder, or none, and removes those of an earlier report that are
    /// not written again; JSON or words to stdout.
    ///
    /// # Errors
    /// Exit code 4.
    pub(super) fn write(&self, report: &Report, made: &Occasion) -> Result<(), Failure> {
        if let Some(folder) = &self.folder {
            let files = report::files(report, made);
            let staged = files.iter().map(|file| {
                Target::new(&folder.join(&file.name))?.stage(|to| to.write_all(&file.bytes))
            });
            commit(staged.collect::<Result<Vec<_>, _>>()?)?;
            for name in &self.earlier {
                if files.iter().all(|file| file.name != *name) {
                    // Gone already is as good.
                    let _ = fs::remove_file(folder.join(name));
                }
            }
            if !self.quiet {
                let page = folder.join("index.html");
                say(format_args!("{} and {} more files", page.display(), files.len() - 1));
            }
        }
        let text = if self.json {
            report::document(report, made)
        } else if self.folder.is_none() {
            report::summary(report, made, false)
        } else {
            return Ok(());
        };
        Target::stdout()?.stage(|to| to.write_all(text.as_bytes())).map(drop)
    }
}

/// The studies whose reports a folder holds, with the files that each of them says are its own.
fn reports(folder: &Path) -> Vec<(String, Vec<String>)> {
    let Ok(entries) = fs::read_dir(folder) else { return Vec::new() };
    let paths = entries.filter_map(|entry| Some(entry.ok()?.path()));
    let documents = paths.filter(|path| path.extension() == Some(OsStr::new("json")));
    let report = |path: PathBuf| {
        let document: Value = serde_json::from_slice(&fs::read(path).ok()?).ok()?;
        let study = document["study"].as_str().filter(|_| document["schema"] == report::SCHEMA)?;
        let files = document["files"].as_array().into_iter().flatten().filter_map(Value::as_str);
        let files = files.filter(|name| is_of_a_report(name)).map(str::to_owned);
        Some((study.to_owned(), files.collect()))
    };
    documents.filter_map(report).collect()
}

/// Whether a name can be that of a report's file: in the folder, and of one of its formats.
fn is_of_a_report(name: &str) -> bool {
    let path = Path::new(name);
    let ending = path.extension().and_then(OsStr::to_str);
    path.file_name() == Some(OsStr::new(name)) && ending.is_some_and(|e| ENDINGS.contains(&e))
}
