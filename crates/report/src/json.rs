//! A report as one JSON document.
//!
//! `rows` are those of the first table, which every study has; `tables` holds all others by
//! name. A row is an object, its keys the columns' in their order; `columns` says what they are.

use serde::ser::SerializeMap;
use serde::{Serialize, Serializer};

use crate::occasion::Occasion;
use crate::plot::{Plot, Series};
use crate::report::{Block, Report};
use crate::sum::Sum;
use crate::table::{Cell, Column, Table};

/// What the document says that it is.
pub const SCHEMA: &str = "catoptric-study";

/// The document's version: it grows when a key changes its meaning or goes.
const VERSION: u32 = 2;

/// The document, indented, with a line break at the end.
#[must_use]
pub fn document(report: &Report, made: &Occasion) -> String {
    written(report, made, &[], &[])
}

/// The document of a report that is written as these files.
pub(crate) fn written(report: &Report, made: &Occasion, files: &[String], sums: &[Sum]) -> String {
    let mut tables = report.tables();
    let first = tables.next();
    let document = Document {
        schema: SCHEMA,
        version: VERSION,
        study: report.study,
        title: &report.title,
        complete: report.complete,
        made,
        files,
        sums,
        columns: first.map(|table| table.columns),
        rows: first.map(Rows),
        tables: tables.map(NamedTable::of).collect(),
        plots: plots(report).map(NamedPlot::of).collect(),
        notes: notes(report).collect(),
    };
    let text = serde_json::to_string_pretty(&document);
    text.expect("keys are strings, and nothing else can fail") + "\n"
}

#[derive(Serialize)]
struct Document<'a> {
    schema: &'static str,
    version: u32,
    study: &'static str,
    title: &'a str,
    /// False if it was interrupted.
    complete: bool,
    made: &'a Occasion,
    /// All of the folder's files that are this report's; none where it is not in a folder.
    files: &'a [String],
    /// What each of them holds but for this document; none where it is not in a folder.
    sums: &'a [Sum],
    columns: Option<&'a [Column]>,
    rows: Option<Rows<'a>>,
    tables: Vec<NamedTable<'a>>,
    plots: Vec<NamedPlot<'a>>,
    /// What the study says of them in words.
    notes: Vec<&'a str>,
}

#[derive(Serialize)]
struct NamedTable<'a> {
    name: &'static str,
    caption: &'a str,
    columns: &'a [Column],
    rows: Rows<'a>,
}

impl<'a> NamedTable<'a> {
    fn of(table: &'a Table) -> Self {
        let Table { name, caption, columns, .. } = table;
        Self { name, caption, columns, rows: Rows(table) }
    }
}

#[derive(Serialize)]
struct NamedPlot<'a> {
    name: &'a str,
    x: &'a str,
    y: &'a str,
    series: Vec<NamedSeries<'a>>,
}

#[derive(Serialize)]
struct NamedSeries<'a> {
    name: &'a str,
    points: &'a [(f64, f64)],
    /// A bound or a theory, not a measurement.
    dashed: bool,
}

impl<'a> NamedPlot<'a> {
    fn of(plot: &'a Plot) -> Self {
        let series =
            |s: &'a Series| NamedSeries { name: &s.name, points: &s.points, dashed: s.dashed };
        let series = plot.series.iter().map(series).collect();
        Self { name: &plot.name, x: &plot.x, y: &plot.y, series }
    }
}

/// The rows of a table.
struct Rows<'a>(&'a Table);

impl Serialize for Rows<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        to.collect_seq(self.0.rows.iter().map(|cells| Row { columns: self.0.columns, cells }))
    }
}

struct Row<'a> {
    columns: &'a [Column],
    cells: &'a [Cell],
}

impl Serialize for Row<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_map(Some(self.columns.len()))?;
        for (column, cell) in self.columns.iter().zip(self.cells) {
            map.serialize_entry(column.key, cell)?;
        }
        map.end()
    }
}

fn plots(report: &Report) -> impl Iterator<Item = &Plot> {
    report.blocks.iter().filter_map(|block| match block {
        Block::Plot(plot) => Some(plot),
        _ => None,
    })
}

fn notes(report: &Report) -> impl Iterator<Item = &str> {
    report.blocks.iter().filter_map(|block| match block {
        Block::Text(text) => Some(text.as_str()),
        _ => None,
    })
}
