//! The path in an orthographic view of the scene, as SVG.
//!
//! Of the views along the camera's axes (from above, from the side, from the eye) the one in
//! which the mirrored rays are longest.

mod path;
mod window;

use std::fmt::Write;

use catoptric_scene::Scene;

use super::life::Life;
use path::{HITS, Path, dot};
use window::{HEIGHT, WIDTH, Window, half_plane};

/// Spheres that are drawn.
const SPHERES: usize = 400;

/// A view axis by axis: where the drawing's right and up point.
struct Axes {
    name: &'static str,
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
    for disc in &shown {
        window.disc(disc, &mut svg);
    }
    let hidden = planes(life, &axes, &window, &mut svg);
    window.path(&points, &path, &mut svg);
    svg += "</svg>";
    Drawing { svg, caption: caption(&axes, &path, (shown.len(), all), hidden) }
}

impl Axes {
    fn project(&self, point: [f64; 3]) -> [f64; 2] {
        [dot(point, self.right), dot(point, self.up)]
    }
}

fn view(life: &Life, points: &[[f64; 3]]) -> Axes {
    let eye = &life.compiled.eye;
    let unit = |v: [f32; 3]| {
        let v = v.map(f64::from);
        let length = dot(v, v).sqrt();
        v.map(|x| x / length)
    };
    let [right, up, forward] = [eye.right, eye.up, eye.forward].map(|v| unit(v.to_array()));
    let all = [
        Axes { name: "seen from above", right, up: forward },
        Axes { name: "seen from the side", right: forward, up },
        Axes { name: "seen from the eye", right, up },
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

/// Draws the planes that are seen edge on; how many are not.
fn planes(life: &Life, axes: &Axes, window: &Window, svg: &mut String) -> usize {
    let scene = life.scene;
    let mut hidden = 0;
    for plane in &scene.planes {
        let length = dot(plane.normal, plane.normal).sqrt();
        let normal = plane.normal.map(|x| x / length);
        let seen = axes.project(normal);
        if seen[0].hypot(seen[1]) < 0.999 {
            hidden += 1;
            continue;
        }
        let eye = scene.camera.position;
        let height = dot(normal, std::array::from_fn(|i| plane.point[i] - eye[i]));
        // The solid side is the one that the eye is not on.
        let towards_eye = if height > 0.0 { -1.0 } else { 1.0 };
        let rim = window.place([seen[0] * height, seen[1] * height]);
        let outward = [seen[0] * towards_eye, -seen[1] * towards_eye];
        let color = css(plane.material.color);
        let shape = half_plane(rim, outward);
        push(svg, format_args!("{shape} class=\"sphere\" fill=\"{color}\"/>\n"));
    }
    hidden
}

fn caption(axes: &Axes, path: &Path, spheres: (usize, usize), planes: usize) -> String {
    let mut words = format!("The scene {}, parallel. Numbers are depths of hits.", axes.name);
    if path.hidden > 0 {
        let _ = write!(words, " The first {HITS} hits are drawn, {} more are not.", path.hidden);
    }
    if spheres.0 < spheres.1 {
        let more = spheres.1 - spheres.0;
        let _ = write!(words, " {} spheres are drawn, {more} more are not.", spheres.0);
    }
    if planes > 0 {
        let _ = write!(words, " {planes} planes, not seen edge on, are not drawn.");
    }
    words
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
