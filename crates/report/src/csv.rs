//! A table as CSV (RFC 4180): a line of keys, then a line a row.

use crate::table::{Cell, Table};

/// The file's bytes. Numbers have all their digits; what was not measured is empty.
#[must_use]
pub(crate) fn file(table: &Table) -> Vec<u8> {
    let mut writer = csv::Writer::from_writer(Vec::new());
    let expected = "a writer to memory with rows of one length does not fail";
    writer.write_record(table.columns.iter().map(|column| column.key)).expect(expected);
    for row in &table.rows {
        writer.write_record(row.iter().map(exact)).expect(expected);
    }
    writer.into_inner().expect(expected)
}

fn exact(cell: &Cell) -> String {
    match cell {
        Cell::Text(text) => text.clone(),
        Cell::Count(count) => count.to_string(),
        Cell::Truth(truth) => truth.to_string(),
        Cell::Number(number) => format!("{number:?}"),
        Cell::Nothing => String::new(),
    }
}
