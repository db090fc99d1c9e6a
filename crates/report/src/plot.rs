//! Curves.

/// Curves over one pair of axes.
#[derive(Clone, Debug)]
pub struct Plot {
    /// A name for files: lower case, hyphens.
    pub name: String,
    /// One line above it.
    pub title: String,
    /// One sentence below it: what it shows.
    pub caption: String,
    /// Label of the horizontal axis, with its unit.
    pub x: String,
    /// Label of the vertical axis, with its unit.
    pub y: String,
    /// How the horizontal axis is divided.
    pub x_scale: Scale,
    /// How the vertical axis is divided.
    pub y_scale: Scale,
    /// Series in the order of the legend; at most eight, so that colours tell them apart.
    pub series: Vec<Series>,
}

/// How an axis is divided.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Scale {
    /// Evenly.
    Linear,
    /// Powers of ten stand equally far apart; points that are not positive are not drawn.
    Log,
    /// Doublings of x + 1 stand equally far apart, for depths: 0, 1, 3, 7, 15 ... For the
    /// horizontal axis alone; points below 0 are not drawn.
    Doublings,
}

/// One curve.
#[derive(Clone, Debug)]
pub struct Series {
    /// The name in the legend.
    pub name: String,
    /// Points in the order in which they are joined. Points that are not finite are not drawn.
    pub points: Vec<(f64, f64)>,
    /// A bound or a theory, not a measurement: drawn dashed, without marks.
    pub dashed: bool,
}
