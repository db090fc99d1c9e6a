//! The destination of a report: stdout, or the files of a folder.

mod earlier;

use std::fs;
use std::path::{Path, PathBuf};

use catoptric_report::{Occasion, Report};

use super::options::{Common, Study};
use crate::exit::{Failure, say};
use crate::input::is_stream;
use crate::output::{Target, commit};
use earlier::{Earlier, is_of_a_report};

/// Looked at before hours of measuring.
pub(super) struct Destination {
    folder: Option<PathBuf>,
    /// The report of the same study in that folder.
    earlier: Option<Earlier>,
    json: bool,
    quiet: bool,
}

impl Destination {
    /// Makes the folder, if one is asked for and is not there.
    ///
    /// # Errors
    /// Exit code 2 for stdout, which is no folder; 4 for a folder that cannot be written, that
    /// holds the report of another study, whose page would be lost, or something that is no
    /// file under a name of this study's; and for a closed stdout that words are to go to.
    pub(super) fn new(common: &Common, study: &str) -> Result<Self, Failure> {
        let Common { output, json, quiet, .. } = common;
        let (json, quiet) = (*json, *quiet);
        // Without a folder all goes to stdout.
        let Some(folder) = output else {
            Target::stdout()?;
            return Ok(Self { folder: None, earlier: None, json, quiet });
        };
        if is_stream(folder) {
            return Err(Failure::wrong_use(
                "-o names a folder, and - is none: use --json, or leave -o out, for stdout",
            ));
        }
        if json {
            Target::stdout()?;
        }
        // Make the folder, and find out whether its files can be written.
        fs::create_dir_all(folder).map_err(|error| {
            let folder = folder.display();
            Failure::not_written(format_args!(
                "folder {folder} cannot be made: {error}; name another one with -o"
            ))
        })?;
        Target::file(&folder.join("index.html"))?.probe()?;
        for path in in_the_way(folder, study) {
            Target::file(&path)?;
        }
        // All studies write to the same page, so a folder holds one report.
        for other in Study::NAMES.into_iter().filter(|name| *name != study) {
            if Earlier::find(folder, other).is_some() {
                let folder = folder.display();
                return Err(Failure::not_written(format_args!(
                    "folder {folder} holds a report of study {other}, whose page would be \
                     lost; name another one with -o"
                )));
            }
        }
        let earlier = Earlier::find(folder, study);
        Ok(Self { folder: Some(folder.clone()), earlier, json, quiet })
    }

    /// Writes all files of the folder, or none, and removes those of an earlier report that are
    /// not written again; JSON or words to stdout.
    ///
    /// # Errors
    /// Exit code 4.
    pub(super) fn write(&self, report: &Report, made: &Occasion) -> Result<(), Failure> {
        if let Some(folder) = &self.folder {
            let files = catoptric_report::files(report, made);
            let staged = files.iter().map(|file| {
                Target::file(&folder.join(&file.name))?.stage(|to| to.write_all(&file.bytes))
            });
            commit(staged.collect::<Result<Vec<_>, _>>()?)?;
            let stale = |name: &str| files.iter().all(|file| file.name != name);
            let kept = self.earlier.as_ref().map(|earlier| earlier.remove(folder, stale));
            if !self.quiet {
                for name in kept.into_iter().flatten() {
                    let path = folder.join(name);
                    say(format_args!(
                        "{} is an earlier report's, not as it was written, and is kept",
                        path.display()
                    ));
                }
                let page = folder.join("index.html");
                say(format_args!("{} and {} more files", page.display(), files.len() - 1));
            }
        }
        let text = if self.json {
            catoptric_report::document(report, made)
        } else if self.folder.is_none() {
            catoptric_report::summary(report, made, false)
        } else {
            return Ok(());
        };
        Target::stdout()?.stage(|to| to.write_all(text.as_bytes())).map(drop)
    }
}

/// What is in a folder under names that a study's files have: `depth.csv`, `depth-room-ray.svg`.
fn in_the_way(folder: &Path, study: &str) -> Vec<PathBuf> {
    let names = fs::read_dir(folder).into_iter().flatten().flatten();
    let names = names.filter_map(|entry| entry.file_name().into_string().ok());
    let of_the_study = |name: &String| {
        let rest = name.strip_prefix(study);
        is_of_a_report(name) && rest.is_some_and(|rest| rest.starts_with(['.', '-']))
    };
    names.filter(of_the_study).map(|name| folder.join(name)).collect()
}
