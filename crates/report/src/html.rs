//! A report as one HTML page that needs nothing beside it and no network: styles, drawings
//! and pictures stand in the file.

use base64::Engine;
use base64::engine::general_purpose::STANDARD;

use crate::escape::escaped;
use crate::occasion::Occasion;
use crate::picture::Picture;
use crate::plot::Plot;
use crate::report::{Block, Report};
use crate::table::{Cell, Column, Table};
use crate::{png, svg};

const STYLE: &str = include_str!("page.css");

/// What the page may load: nothing but what stands in it. A browser refuses the rest.
const POLICY: &str = "default-src 'none'; style-src 'unsafe-inline'; img-src data:";

/// The page.
#[must_use]
pub(crate) fn page(report: &Report, made: &Occasion) -> String {
    let title = escaped(&report.title);
    let body: String = report.blocks.iter().map(block).collect();
    let interrupted = if report.complete {
        ""
    } else {
        "<p class=\"warning\">Interrupted: these are the rows measured until then.</p>\n"
    };
    format!(
        "<!DOCTYPE html>\n<html lang=\"en\">\n<head>\n<meta charset=\"utf-8\">\n\
         <meta name=\"viewport\" content=\"width=device-width\">\n\
         <meta http-equiv=\"Content-Security-Policy\" content=\"{POLICY}\">\n\
         <title>{title}</title>\n<style>\n{STYLE}</style>\n</head>\n<body>\n<main>\n\
         <h1>{title}</h1>\n{interrupted}{body}<footer>{}</footer>\n</main>\n</body>\n</html>\n",
        escaped(&made.to_string())
    )
}

fn block(block: &Block) -> String {
    match block {
        Block::Heading(heading) => format!("<h2>{}</h2>\n", escaped(heading)),
        Block::Text(text) => format!("<p>{}</p>\n", escaped(text)),
        Block::Table(rows) => table(rows),
        Block::Plot(curves) => plot(curves),
        Block::Pictures(pictures) => {
            let figures: String = pictures.iter().map(picture).collect();
            format!("<div class=\"pictures\">\n{figures}</div>\n")
        }
    }
}

fn table(table: &Table) -> String {
    let heading = |column: &Column| {
        let (meaning, heading) = (escaped(column.meaning), escaped(column.heading));
        format!("<th title=\"{meaning}\">{heading}</th>")
    };
    let headings: String = table.columns.iter().map(heading).collect();
    let row = |row: &Vec<Cell>| {
        let cells: String = row.iter().map(cell).collect();
        format!("<tr>{cells}</tr>\n")
    };
    let rows: String = table.rows.iter().map(row).collect();
    format!(
        "<figure class=\"table\" id=\"{}\"><figcaption>{}</figcaption>\n<table>\n<thead><tr>{headings}</tr></thead>\n\
         <tbody>\n{rows}</tbody>\n</table></figure>\n",
        table.name,
        escaped(&table.caption)
    )
}

/// Numbers stand to the right; words that name a verdict can be told by their colour too.
fn cell(cell: &Cell) -> String {
    let shown = escaped(&cell.to_string());
    match cell {
        Cell::Text(text) if text == "FAILS" => format!("<td class=\"fails\">{shown}</td>"),
        Cell::Text(_) | Cell::Truth(_) => format!("<td>{shown}</td>"),
        Cell::Number(number) => format!("<td class=\"number\" title=\"{number:?}\">{shown}</td>"),
        Cell::Count(_) | Cell::Nothing => format!("<td class=\"number\">{shown}</td>"),
    }
}

fn plot(plot: &Plot) -> String {
    format!(
        "<figure class=\"plot\" id=\"{}\" aria-label=\"{}\">{}<figcaption>{}</figcaption></figure>\n",
        plot.name,
        escaped(&plot.title),
        svg::drawing(plot),
        escaped(&plot.caption)
    )
}

fn picture(picture: &Picture) -> String {
    let (width, height) = (picture.width * picture.zoom, picture.height * picture.zoom);
    let caption = escaped(&picture.caption);
    let data = STANDARD.encode(png::file(picture));
    format!(
        "<figure><img alt=\"{caption}\" width=\"{width}\" height=\"{height}\" \
         src=\"data:image/png;base64,{data}\"><figcaption>{caption}</figcaption></figure>\n"
    )
}
