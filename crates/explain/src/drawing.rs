//! The path in an orthographic view of the scene, as SVG.
//!
//! The view is that of three (from above, from the side, along the camera's) in which the mirrored
//! rays are longest. All stand upright with the scene, however the camera is inclined, so that
//! floors and walls are seen edge on.

mod axes;
mod disc;
mod marks;
mod path;
mod planes;
mod svg;
mod vector;
mod window;

use std::fmt::Write;

use crate::life::Life;
use axes::{Axes, view};
use disc::{Disc, discs};
use path::{HITS, Path};
use window::{HEIGHT, WIDTH, Window};

/// Spheres that are drawn.
const SPHERES: usize = 400;

/// The path and what is about it.
pub(crate) struct Drawing {
    pub(crate) svg: String,
    /// What is seen, and what is left out.
    pub(crate) caption: String,
}

/// Draws the path. Each leg carries its ray's depth as `data-depth`.
pub(crate) fn draw(life: &Life) -> Drawing {
    // Choose the view and the part of it that the path needs.
    let path = Path::of(life);
    let axes = view(life, &path.points);
    let points: Vec<[f64; 2]> = path.points.iter().map(|p| axes.project(*p)).collect();
    let discs = discs(life.scene, &axes);
    let met: Vec<&Disc> = path.met.iter().filter_map(|stated| discs.get(*stated)).collect();
    let window = Window::around(&points[1..], points[0], &met);

    // Keep the spheres that are in sight, the ones that were met before all others.
    let mut shown: Vec<&Disc> = discs.iter().filter(|disc| window.shows(disc)).collect();
    let all = shown.len();
    shown.sort_by_key(|disc| !path.met.contains(&disc.stated));
    shown.truncate(SPHERES);
    // The larger behind the smaller.
    shown.sort_by(|a, b| b.radius.total_cmp(&a.radius));

    // Draw from the back to the front, marks last.
    let mut svg = format!(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" role=\"img\" \
         aria-label=\"The path, {}\">\n",
        axes.name
    );
    let planes = planes::Seen::new(life, &axes, &path);
    planes.behind(&mut svg);
    for disc in &shown {
        window.disc(disc, &mut svg);
    }
    planes.edge_on(&window, &mut svg);
    planes.tangents(&window, &points, &path, &mut svg);
    let names: Vec<String> = path.met.iter().map(|&stated| life.name_of(stated)).collect();
    marks::path(&window, &points, &path, &names, &mut svg);
    svg += "</svg>";
    // Say in the caption what the drawing leaves out.
    let mut caption = caption(&axes, &path, (shown.len(), all), planes.hidden);
    if !window.holds(points[0]) {
        caption += " The eye is outside the drawing.";
    }
    Drawing { svg, caption }
}

fn caption(axes: &Axes, path: &Path, spheres: (usize, usize), planes: usize) -> String {
    let mut words = format!(
        "The scene {}, in parallel: a ray may pass {} what it crosses. Hits carry their depth{}.",
        axes.name,
        axes.passes,
        if path.met.len() <= marks::NAMED { " and what was hit" } else { "" }
    );
    if path.hidden > 0 {
        let _ = write!(words, " The first {HITS} hits are drawn, {} more are not.", path.hidden);
    }
    if spheres.0 < spheres.1 {
        let more = spheres.1 - spheres.0;
        let _ = write!(words, " {} spheres are drawn, {more} more are not.", spheres.0);
    }
    if planes > 0 {
        let s = if planes == 1 { " is" } else { "s are" };
        let _ = write!(words, " {planes} plane{s} not drawn, neither hit nor seen edge on.");
    }
    words
}
