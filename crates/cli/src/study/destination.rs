//! Where a report goes: stdout, or the files of a folder.

use std::fs;
use std::path::{Path, PathBuf};

use catoptric_study::occasion::Occasion;
use catoptric_study::report::{self, Report};

use super::options::Common;
use crate::exit::{Failure, say};
use crate::output::{Target, commit};

/// Looked at before hours of measuring.
pub(super) struct Destination {
    folder: Option<PathBuf>,
    json: bool,
    quiet: bool,
}

impl Destination {
    /// Makes the folder, if one is asked for and is not there.
    ///
    /// # Errors
    /// Exit code 4.
    pub(super) fn new(common: &Common) -> Result<Self, Failure> {
        if let Some(folder) = &common.output {
            fs::create_dir_all(folder).map_err(|error| {
                let folder = folder.display();
                Failure::not_written(format_args!(
                    "folder {folder} cannot be made: {error}; name another one with -o"
                ))
            })?;
            Target::new(&folder.join("index.html"))?.probe()?;
        }
        Ok(Self { folder: common.output.clone(), json: common.json, quiet: common.quiet })
    }

    /// Writes all files of the folder, or none; JSON or words to stdout.
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
        Target::new(Path::new("-"))?.stage(|to| to.write_all(text.as_bytes())).map(drop)
    }
}
