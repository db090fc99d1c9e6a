//! The part of the view that the drawing shows, and what is drawn there.

use super::disc::Disc;
use super::svg::push;

/// Units of the drawing.
pub(super) const WIDTH: f64 = 640.0;
pub(super) const HEIGHT: f64 = 480.0;

/// The part of the view that the drawing shows.
pub(super) struct Window {
    middle: [f64; 2],
    scale: f64,
}

impl Window {
    /// Shows the points, the discs that are not larger than these, and the eye if it is
    /// not much farther.
    pub(super) fn around(points: &[[f64; 2]], eye: [f64; 2], met: &[&Disc]) -> Self {
        let mut bounds = Bounds::of(points);
        // A single hit says nothing of what is large.
        if points.len() < 2 {
            bounds.add(eye, 0.0);
        }
        let path = bounds.size().max(1e-30);
        for disc in met.iter().filter(|disc| disc.radius < path) {
            bounds.add(disc.center, disc.radius);
        }
        let mut with_eye = bounds.clone();
        with_eye.add(eye, 0.0);
        if with_eye.size() < 4.0 * bounds.size() {
            bounds = with_eye;
        }
        let [width, height] = [0, 1].map(|i| (bounds.high[i] - bounds.low[i]).max(path * 1e-3));
        let (across, down) = (0.86 * WIDTH / width, 0.86 * HEIGHT / height);
        let scale = across.min(down);
        Self { middle: [0, 1].map(|i| (bounds.low[i] + bounds.high[i]) / 2.0), scale }
    }

    /// Converts a point to the drawing's units, y downwards.
    pub(super) fn place(&self, point: [f64; 2]) -> [f64; 2] {
        let [x, y] = [0, 1].map(|i| (point[i] - self.middle[i]) * self.scale);
        [WIDTH / 2.0 + x, HEIGHT / 2.0 - y]
    }

    /// Whether a disc's rim or inside is in the drawing, and larger than nothing.
    pub(super) fn shows(&self, disc: &Disc) -> bool {
        let [x, y] = self.place(disc.center);
        let radius = disc.radius * self.scale;
        let outside = |at: f64, size: f64| at + radius < 0.0 || at - radius > size;
        radius > 0.3 && !outside(x, WIDTH) && !outside(y, HEIGHT)
    }

    /// Whether a point is in the drawing.
    pub(super) fn holds(&self, point: [f64; 2]) -> bool {
        let [x, y] = self.place(point);
        (0.0..=WIDTH).contains(&x) && (0.0..=HEIGHT).contains(&y)
    }

    /// A circle; so large a one that its rim is straight in the drawing, as a half plane.
    pub(super) fn disc(&self, disc: &Disc, svg: &mut String) {
        let ([x, y], radius) = (self.place(disc.center), disc.radius * self.scale);
        let color = &disc.color;
        let shape = if radius < 1e5 {
            format!("<circle cx=\"{x:.2}\" cy=\"{y:.2}\" r=\"{radius:.2}\"")
        } else {
            let away = [WIDTH / 2.0 - x, HEIGHT / 2.0 - y];
            let far = away[0].hypot(away[1]);
            // In the middle of the disc any direction is outward.
            let normal = if far > 0.0 { away.map(|a| a / far) } else { [1.0, 0.0] };
            let rim = [
                WIDTH / 2.0 - normal[0] * (far - radius),
                HEIGHT / 2.0 - normal[1] * (far - radius),
            ];
            half_plane(rim, normal)
        };
        push(svg, format_args!("{shape} class=\"sphere\" fill=\"{color}\"/>\n"));
    }
}

/// A box around points.
#[derive(Clone)]
struct Bounds {
    low: [f64; 2],
    high: [f64; 2],
}

impl Bounds {
    fn of(points: &[[f64; 2]]) -> Self {
        let first = points.first().copied().unwrap_or([0.0; 2]);
        let mut bounds = Self { low: first, high: first };
        points.iter().for_each(|point| bounds.add(*point, 0.0));
        bounds
    }

    fn add(&mut self, point: [f64; 2], about: f64) {
        for (i, at) in point.into_iter().enumerate() {
            self.high[i] = self.high[i].max(at + about);
            self.low[i] = self.low[i].min(at - about);
        }
    }

    fn size(&self) -> f64 {
        (self.high[0] - self.low[0]).max(self.high[1] - self.low[1])
    }
}

/// What lies behind a straight rim, as far as the drawing goes; the tag is left open. All of the
/// drawing where no rim crosses it and `outward` points to where that is.
pub(super) fn half_plane(rim: [f64; 2], outward: [f64; 2]) -> String {
    // More than half the drawing's diagonal, and more than all of it.
    const HALF: f64 = 401.0;
    const FAR: f64 = 2e3;
    // The foot of the drawing's middle on the rim, and how far outside the middle is.
    let middle = [WIDTH / 2.0, HEIGHT / 2.0];
    let off = (0..2).map(|i| (middle[i] - rim[i]) * outward[i]).sum::<f64>();
    if off < -HALF {
        return everywhere();
    }
    let foot = [middle[0] - off * outward[0], middle[1] - off * outward[1]];
    let side = [-outward[1], outward[0]];
    let corner = |s: f64, o: f64| {
        let at = |i: usize| foot[i] + FAR * (s * side[i] + o * outward[i]);
        format!("{:.2},{:.2}", at(0), at(1))
    };
    let corners = [corner(-1.0, 0.0), corner(1.0, 0.0), corner(1.0, -1.0), corner(-1.0, -1.0)];
    format!("<polygon points=\"{}\"", corners.join(" "))
}

/// All of the drawing; the tag is left open.
pub(super) fn everywhere() -> String {
    format!("<rect x=\"0\" y=\"0\" width=\"{WIDTH}\" height=\"{HEIGHT}\"")
}
