//! What a study found, before it takes any format.

use crate::picture::Picture;
use crate::plot::Plot;
use crate::table::Table;

/// What a study found, in the order in which it is read.
#[derive(Clone, Debug)]
pub struct Report {
    /// The study's name on the command line: `stability`, `error`, `depth` ...
    pub study: &'static str,
    /// One line: the page's title.
    pub title: String,
    /// Words, tables, plots and pictures.
    pub blocks: Vec<Block>,
    /// False if it was interrupted: the rows are those measured until then.
    pub complete: bool,
    /// Whether something is not as it must be: a case of a suite that fails unexpectedly.
    pub failed: bool,
}

/// A part of a report.
#[derive(Clone, Debug)]
pub enum Block {
    /// A heading of a section.
    Heading(String),
    /// A paragraph, plain text.
    Text(String),
    /// Rows.
    Table(Table),
    /// Curves.
    Plot(Plot),
    /// Pictures side by side.
    Pictures(Vec<Picture>),
}

impl Report {
    /// An empty report.
    #[must_use]
    pub fn new(study: &'static str, title: impl Into<String>) -> Self {
        Self { study, title: title.into(), blocks: Vec::new(), complete: true, failed: false }
    }

    /// Adds a heading.
    pub fn heading(&mut self, heading: impl Into<String>) {
        self.blocks.push(Block::Heading(heading.into()));
    }

    /// Adds a paragraph.
    pub fn text(&mut self, text: impl Into<String>) {
        self.blocks.push(Block::Text(text.into()));
    }

    /// Adds a table.
    pub fn table(&mut self, table: Table) {
        self.blocks.push(Block::Table(table));
    }

    /// Adds a plot.
    pub fn plot(&mut self, plot: Plot) {
        self.blocks.push(Block::Plot(plot));
    }

    /// Adds pictures side by side.
    pub fn pictures(&mut self, pictures: Vec<Picture>) {
        self.blocks.push(Block::Pictures(pictures));
    }

    /// All tables, in order; the first holds the study's main rows.
    pub fn tables(&self) -> impl Iterator<Item = &Table> {
        self.blocks.iter().filter_map(|block| match block {
            Block::Table(table) => Some(table),
            _ => None,
        })
    }
}
