//! Reading a report's tables.

use catoptric_report::{Block, Cell, Report, Table};

pub(crate) fn table<'a>(report: &'a Report, name: &str) -> &'a Table {
    report.tables().find(|table| table.name == name).expect("a table of that name")
}

/// A row's cell of that key.
pub(crate) fn cell<'a>(table: &Table, row: &'a [Cell], key: &str) -> &'a Cell {
    let index = table.columns.iter().position(|column| column.key == key);
    &row[index.unwrap_or_else(|| panic!("no column {key}"))]
}

pub(crate) fn number(table: &Table, row: &[Cell], key: &str) -> f64 {
    match cell(table, row, key) {
        Cell::Number(number) => *number,
        Cell::Count(count) => *count as f64,
        other => panic!("{key} is {other:?}"),
    }
}

pub(crate) fn text(table: &Table, row: &[Cell], key: &str) -> String {
    cell(table, row, key).to_string()
}

/// All that a report says in words.
pub(crate) fn words(report: &Report) -> String {
    let words = report.blocks.iter().filter_map(|block| match block {
        Block::Text(text) => Some(text.as_str()),
        _ => None,
    });
    words.collect::<Vec<_>>().join("\n")
}
