//! Writing SVG.

use std::fmt::Write;

/// Adds to a drawing.
pub(super) fn push(text: &mut String, what: std::fmt::Arguments<'_>) {
    text.write_fmt(what).expect("a string takes all");
}

/// A linear colour as a browser takes it, brightened as for a screen.
pub(super) fn css(color: [f64; 3]) -> String {
    let level = |x: f64| if x < 1.0 { 255.0 * x.sqrt() } else { 255.0 };
    let [r, g, b] = color.map(level);
    format!("rgb({r:.0},{g:.0},{b:.0})")
}
