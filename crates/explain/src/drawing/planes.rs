//! The scene's planes, as far as a view can show them.

use catoptric_scene::Plane;

use super::axes::Axes;
use super::path::Path;
use super::svg::{css, push};
use super::vector::{dot, unit};
use super::window::{Window, everywhere, half_plane};
use crate::life::Life;

/// Units to either side of a hit that a tangent takes.
const TANGENT: f64 = 18.0;

/// A plane in a view.
struct Shown {
    /// Colour of the plane's material.
    color: [f64; 3],
    /// Unit normal as the view has it: its length is 1 where the plane is seen edge on.
    normal: [f64; 2],
    /// Along the normal, relative to the eye.
    height: f64,
    met: bool,
}

/// All planes.
pub(super) struct Seen {
    all: Vec<Shown>,
    /// Spheres before them among what the scene states.
    spheres: usize,
    /// Planes of which nothing is drawn.
    pub(super) hidden: usize,
}

impl Shown {
    fn is_edge_on(&self) -> bool {
        self.slope() > 0.9999
    }

    /// 1 where it is seen edge on, 0 where it faces the view.
    fn slope(&self) -> f64 {
        self.normal[0].hypot(self.normal[1])
    }

    fn faces(&self) -> bool {
        self.slope() < 0.05
    }
}

impl Seen {
    pub(super) fn new(life: &Life, axes: &Axes, path: &Path) -> Self {
        let (eye, spheres) = (life.scene.camera.position, life.scene.spheres.len());
        let shown = |(i, plane): (usize, &Plane)| {
            let normal = unit(plane.normal);
            Shown {
                color: life.scene.materials[plane.material].color,
                normal: axes.project(normal),
                height: dot(normal, std::array::from_fn(|i| plane.point[i] - eye[i])),
                met: path.met.contains(&(spheres + i)),
            }
        };
        let all: Vec<_> = life.scene.planes.iter().enumerate().map(shown).collect();
        let hidden = all.iter().filter(|plane| !plane.met && !plane.is_edge_on()).count();
        Self { all, spheres, hidden }
    }

    /// Planes that were hit and face the view: they are behind all of it.
    pub(super) fn behind(&self, svg: &mut String) {
        for shown in self.all.iter().filter(|plane| plane.met && plane.faces()) {
            fill(&everywhere(), shown.color, svg);
        }
    }

    /// Planes that are seen edge on, as half planes.
    pub(super) fn edge_on(&self, window: &Window, svg: &mut String) {
        for shown in self.all.iter().filter(|plane| plane.is_edge_on()) {
            let Shown { color, normal: [x, y], height, .. } = *shown;
            // The solid side is the one that the eye is not on.
            let towards_eye = if height > 0.0 { -1.0 } else { 1.0 };
            let rim = window.place([x * height, y * height]);
            fill(&half_plane(rim, [x * towards_eye, -y * towards_eye]), color, svg);
        }
    }

    /// Pieces of all other planes, one at each hit.
    pub(super) fn tangents(
        &self,
        window: &Window,
        points: &[[f64; 2]],
        path: &Path,
        svg: &mut String,
    ) {
        for (depth, &stated) in path.met.iter().enumerate() {
            let Some(shown) = stated.checked_sub(self.spheres).map(|plane| &self.all[plane]) else {
                continue;
            };
            if shown.is_edge_on() || shown.faces() {
                continue;
            }
            let [x, y] = window.place(points[depth + 1]);
            // The normal turned by a right angle; the drawing's y goes down.
            let [right, up] = shown.normal.map(|n| n / shown.slope() * TANGENT);
            let (x1, y1, x2, y2) = (x + up, y + right, x - up, y - right);
            push(
                svg,
                format_args!(
                    "<line class=\"tangent\" data-depth=\"{depth}\" x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\"/>\n"
                ),
            );
        }
    }
}

fn fill(shape: &str, color: [f64; 3], svg: &mut String) {
    let color = css(color);
    push(svg, format_args!("{shape} class=\"sphere\" fill=\"{color}\"/>\n"));
}
