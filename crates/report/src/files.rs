//! The files that a report is written as.

use crate::occasion::Occasion;
use crate::report::{Block, Report};
use crate::sum::Sum;
use crate::{csv, html, json, markdown, png, svg};

/// A file of a report.
#[derive(Clone, Debug)]
pub struct File {
    /// The file's name within the report's folder.
    pub name: String,
    /// What the file holds.
    pub bytes: Vec<u8>,
}

/// `index.html`, and for programs and papers the same as JSON, CSV, Markdown, SVG and PNG.
#[must_use]
pub fn files(report: &Report, made: &Occasion) -> Vec<File> {
    let study = report.study;
    let file = |name: String, bytes: Vec<u8>| File { name, bytes };
    let mut files = vec![
        file("index.html".to_owned(), html::page(report, made).into_bytes()),
        file(format!("{study}.json"), Vec::new()),
        file(format!("{study}.md"), markdown::summary(report, made, true).into_bytes()),
    ];
    for (index, table) in report.tables().enumerate() {
        let name = if index == 0 { study.to_owned() } else { format!("{study}-{}", table.name) };
        files.push(file(name + ".csv", csv::file(table)));
    }
    for block in &report.blocks {
        match block {
            Block::Plot(plot) => {
                files.push(file(format!("{}.svg", plot.name), svg::file(plot).into_bytes()));
            }
            Block::Pictures(pictures) => {
                let pictures = pictures.iter();
                files.extend(pictures.map(|p| file(format!("{}.png", p.name), png::file(p))));
            }
            Block::Heading(_) | Block::Text(_) | Block::Table(_) => {}
        }
    }
    // The document names the files, itself among them.
    let names: Vec<String> = files.iter().map(|file| file.name.clone()).collect();
    // It also says what every other file holds.
    let others = files.iter().enumerate().filter(|(index, _)| *index != 1);
    let sums: Vec<Sum> = others.map(|(_, file)| Sum::of(&file.name, &file.bytes)).collect();
    files[1].bytes = json::written(report, made, &names, &sums).into_bytes();
    files
}
