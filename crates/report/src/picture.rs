//! Pictures in a report.

/// An 8-bit picture with its caption.
#[derive(Clone, Debug)]
pub struct Picture {
    /// A name for files: lower case, hyphens.
    pub name: String,
    /// What the picture shows, in a few words.
    pub caption: String,
    /// Columns.
    pub width: u32,
    /// Rows.
    pub height: u32,
    /// RGB, row by row from the top left; `width * height` of them.
    pub pixels: Vec<[u8; 3]>,
    /// How many times each pixel is enlarged on the page; 1 shows it as it is.
    pub zoom: u32,
}
