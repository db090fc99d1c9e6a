//! A report as Markdown: what people read in a terminal or keep beside their data.

use std::fmt::Write;

use crate::occasion::Occasion;
use crate::report::{Block, Report};
use crate::table::{Cell, Table};

/// The summary. Plots and pictures are named by the files that a report writes for them, or
/// left out where there are none.
#[must_use]
pub fn summary(report: &Report, made: &Occasion, with_files: bool) -> String {
    let mut text = format!("# {}\n", report.title);
    if !report.complete {
        text += "\nInterrupted: these are the rows measured until then.\n";
    }
    for block in &report.blocks {
        text.push('\n');
        match block {
            Block::Heading(heading) => push(&mut text, format_args!("## {heading}\n")),
            Block::Text(words) => push(&mut text, format_args!("{words}\n")),
            Block::Table(table) => push_table(&mut text, table),
            Block::Plot(plot) if with_files => {
                push(&mut text, format_args!("![{}]({}.svg)\n\n", plot.title, plot.name));
                push(&mut text, format_args!("{}\n", plot.caption));
            }
            Block::Pictures(pictures) if with_files => {
                for picture in pictures {
                    let (caption, name) = (&picture.caption, &picture.name);
                    push(&mut text, format_args!("![{caption}]({name}.png) {caption}\n"));
                }
            }
            Block::Plot(_) | Block::Pictures(_) => {
                text.pop();
            }
        }
    }
    push(&mut text, format_args!("\n{made}\n"));
    text
}

fn push(text: &mut String, what: std::fmt::Arguments<'_>) {
    text.write_fmt(what).expect("a string takes all");
}

/// Columns are padded, so that the source can be read too.
fn push_table(text: &mut String, table: &Table) {
    push(text, format_args!("{}\n\n", table.caption));
    let headings: Vec<String> = table.columns.iter().map(|c| c.heading.to_owned()).collect();
    let cell = |cell: &Cell| cell.to_string().replace('|', "\\|");
    let rows: Vec<Vec<String>> =
        table.rows.iter().map(|row| row.iter().map(cell).collect()).collect();
    let widths: Vec<usize> = (0..headings.len())
        .map(|i| {
            let cells = rows.iter().map(|row| row[i].chars().count());
            cells.chain([headings[i].chars().count()]).max().unwrap_or(0)
        })
        .collect();
    push_row(text, &headings, &widths);
    let rule: Vec<String> = widths.iter().map(|width| "-".repeat(*width)).collect();
    push_row(text, &rule, &widths);
    for row in &rows {
        push_row(text, row, &widths);
    }
}

fn push_row(text: &mut String, cells: &[String], widths: &[usize]) {
    for (cell, width) in cells.iter().zip(widths) {
        push(text, format_args!("| {cell:<width$} "));
    }
    text.push_str("|\n");
}
