//! Reports: rows, curves, pictures and words, written in every format that people and programs
//! read. Nothing here traces a ray.
//!
//! ```text
//! report.rs       what was found, before it takes any format
//!   table.rs        rows and what their columns mean
//!   plot.rs         curves
//!   picture.rs      8-bit pictures
//! occasion.rs     where, when and with what it was measured
//! files.rs        all files of a report
//!   sum.rs          their sums, by which they are known again
//!   html.rs         one page, its look in page.css
//!   json.rs         one document
//!   markdown.rs     the summary
//!   csv.rs svg.rs png.rs   a table, a plot, a picture
//! escape.rs       text within HTML and XML
//! ```

mod csv;
mod escape;
mod files;
mod html;
mod json;
mod markdown;
pub mod occasion;
mod picture;
mod plot;
mod png;
mod report;
mod sum;
mod svg;
mod table;

pub use escape::escaped;
pub use files::{File, files};
pub use json::{SCHEMA, document};
pub use markdown::summary;
pub use occasion::Occasion;
pub use picture::Picture;
pub use plot::{Plot, Scale, Series};
pub use report::{Block, Report};
pub use sum::Sum;
pub use table::{Cell, Column, Table};
