//! The path in an orthographic view of the scene, as SVG.
//!
//! Of three views (from above, from the side, along the camera's) the one in which the mirrored
//! rays are longest. All stand upright with the scene, however the camera is inclined, so that
//! floors and walls are seen edge on.

mod marks;
mod path;
mod planes;
mod window;

use std::fmt::Write;

use catoptric_scene::Scene;

use super::life::Life;
use path::{HITS, Path, dot};
use window::{HEIGHT, WIDTH, Window};

/// Spheres that are drawn.
const SPHERES: usize = 400;

/// A view axis by axis: where the drawing's right and up point.
struct Axes {
    name: &'static str,
    /// Where a ray may pass what it crosses in the drawing.
    passes: &'static str,
    right: [f64; 3],
    up: [f64; 3],
}

/// The path and what is about it.
pub(super) struct Drawing {
    pub(super) svg: String,
    /// What is seen, and what is left out.
    pub(super) caption: String,
}

/// Draws the path. Each leg carries its ray's depth as `data-depth`.
pub(super) fn draw(life: &Life) -> Drawing {
    let path = Path::of(life);
    let axes = view(life, &path.points);
    let points: Vec<[f64; 2]> = path.points.iter().map(|p| axes.project(*p)).collect();
    let discs = discs(life.scene, &axes);
    let met: Vec<&Disc> = path.met.iter().filter_map(|stated| discs.get(*stated)).collect();
    let window = Window::around(&points[1..], points[0], &met);

    let mut shown: Vec<&Disc> = discs.iter().filter(|disc| window.shows(disc)).collect();
    let all = shown.len();
    shown.sort_by_key(|disc| !path.met.contains(&disc.stated));
    shown.truncate(SPHERES);
    // The larger behind the smaller.
    shown.sort_by(|a, b| b.radius.total_cmp(&a.radius));

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
    let mut caption = caption(&axes, &path, (shown.len(), all), planes.hidden);
    if !window.holds(points[0]) {
        caption += " The eye is outside the drawing.";
    }
    Drawing { svg, caption }
}

impl Axes {
    fn project(&self, point: [f64; 3]) -> [f64; 2] {
        [dot(point, self.right), dot(point, self.up)]
    }
}

fn view(life: &Life, points: &[[f64; 3]]) -> Axes {
    let scene = life.scene.camera;
    let up = unit(scene.up);
    let view = unit(std::array::from_fn(|i| scene.look_at[i] - scene.position[i]));
    // The view is not parallel to up: the scene's validation sees to that.
    let rise = dot(view, up);
    let forward = unit(std::array::from_fn(|i| view[i] - rise * up[i]));
    let right = std::array::from_fn(|i| {
        let (j, k) = ((i + 1) % 3, (i + 2) % 3);
        forward[j] * up[k] - forward[k] * up[j]
    });
    let (above, before) = ("above or below", "in front of or behind");
    let all = [
        Axes { name: "seen from above", passes: above, right, up: forward },
        Axes { name: "seen from the side", passes: before, right: forward, up },
        Axes { name: "seen as the eye looks, but level", passes: before, right, up },
    ];
    let length = |axes: &Axes| -> f64 {
        let flat: Vec<[f64; 2]> = points.iter().map(|p| axes.project(*p)).collect();
        let legs = flat.windows(2).skip(usize::from(points.len() > 2));
        legs.map(|leg| (leg[1][0] - leg[0][0]).hypot(leg[1][1] - leg[0][1])).sum()
    };
    // The first of equals.
    let longest = all.into_iter().reduce(|a, b| if length(&b) > length(&a) { b } else { a });
    longest.expect("three views")
}

/// A sphere as the view shows it.
struct Disc {
    stated: usize,
    center: [f64; 2],
    radius: f64,
    color: String,
}

fn discs(scene: &Scene, axes: &Axes) -> Vec<Disc> {
    let eye = scene.camera.position;
    let disc = |(stated, sphere): (usize, &catoptric_scene::Sphere)| Disc {
        stated,
        center: axes.project(std::array::from_fn(|i| sphere.center[i] - eye[i])),
        radius: sphere.radius,
        color: css(sphere.material.color),
    };
    scene.spheres.iter().enumerate().map(disc).collect()
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

/// Scaled first, so that no square is lost.
fn unit(v: [f64; 3]) -> [f64; 3] {
    let largest = v.into_iter().fold(0.0, |largest: f64, x| largest.max(x.abs()));
    let v = v.map(|x| x / largest);
    let length = dot(v, v).sqrt();
    v.map(|x| x / length)
}

/// A linear colour as a browser takes it, brightened as for a screen.
fn css(color: [f64; 3]) -> String {
    let level = |x: f64| if x < 1.0 { 255.0 * x.sqrt() } else { 255.0 };
    let [r, g, b] = color.map(level);
    format!("rgb({r:.0},{g:.0},{b:.0})")
}

fn push(text: &mut String, what: std::fmt::Arguments<'_>) {
    text.write_fmt(what).expect("a string takes all");
}
