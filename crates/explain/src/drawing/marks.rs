//! What is drawn of the path: legs, hits and their names.

use super::path::Path;
use super::svg::push;
use super::window::{HEIGHT, WIDTH, Window};

/// Hits that carry their number.
const NUMBERED: usize = 40;

/// Hits up to which each is told with what was hit; where there are more, there is no room.
pub(super) const NAMED: usize = 12;

/// Units that a letter of a name takes, and a line.
const LETTER: f64 = 7.2;
const LINE: f64 = 15.0;

/// Draws legs and hits; `names` are of what was hit.
pub(super) fn path(
    window: &Window,
    points: &[[f64; 2]],
    path: &Path,
    names: &[String],
    svg: &mut String,
) {
    // A line for each leg, told apart where the ray leaves the scene.
    let placed: Vec<[f64; 2]> = points.iter().map(|p| window.place(*p)).collect();
    for (depth, leg) in placed.windows(2).enumerate() {
        let ([x1, y1], [x2, y2]) = (leg[0], leg[1]);
        let leaving = if path.leaves && depth + 2 == placed.len() { " leaving" } else { "" };
        push(
            svg,
            format_args!(
                "<line class=\"leg{leaving}\" data-depth=\"{depth}\" x1=\"{x1:.2}\" y1=\"{y1:.2}\" x2=\"{x2:.2}\" y2=\"{y2:.2}\"/>\n"
            ),
        );
    }
    // The eye is named first, so that no other name takes its place.
    let mut labels = Labels::default();
    let [x, y] = placed[0];
    push(svg, format_args!("<circle class=\"hit\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"4\"/>\n"));
    labels.name([x, y], "eye", svg);
    // A mark for each hit, and names as long as there is room for them.
    for (depth, &[x, y]) in placed.iter().skip(1).take(path.met.len()).enumerate() {
        push(
            svg,
            format_args!(
                "<circle class=\"hit\" data-depth=\"{depth}\" cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"3\"/>\n"
            ),
        );
        if depth < NUMBERED {
            let name = if names.len() <= NAMED { &names[depth] } else { "" };
            labels.name([x, y], format!("{depth} {name}").trim_end(), svg);
        }
    }
}

/// Boxes of names, none over another.
#[derive(Default)]
struct Labels(Vec<[f64; 4]>);

impl Labels {
    /// Writes a name beside a point: above it or below, to the right or to the left; not at all
    /// where there is no room.
    fn name(&mut self, [x, y]: [f64; 2], name: &str, svg: &mut String) {
        let width = LETTER * name.len() as f64;
        let places =
            [(6.0, -LINE - 3.0), (6.0, 3.0), (-6.0 - width, -LINE - 3.0), (-6.0 - width, 3.0)];
        let boxes =
            places.map(|(right, down)| [x + right, y + down, x + right + width, y + down + LINE]);
        let Some(room) = boxes.into_iter().find(|at| self.has_room(at)) else { return };
        let [left, top, ..] = room;
        let base = top + 0.8 * LINE;
        push(svg, format_args!("<text x=\"{left:.2}\" y=\"{base:.2}\">{name}</text>\n"));
        self.0.push(room);
    }

    fn has_room(&self, [left, top, right, bottom]: &[f64; 4]) -> bool {
        let inside = *left >= 0.0 && *top >= 0.0 && *right <= WIDTH && *bottom <= HEIGHT;
        let apart = |[l, t, r, b]: &[f64; 4]| right <= l || left >= r || bottom <= t || top >= b;
        inside && self.0.iter().all(apart)
    }
}
