//! Views of the scene, and which of them shows a path best.

use super::vector::{dot, unit};
use crate::life::Life;

/// A view axis by axis: where the drawing's right and up point.
pub(super) struct Axes {
    pub(super) name: &'static str,
    /// How a ray may pass what it crosses in the drawing, in words.
    pub(super) passes: &'static str,
    right: [f64; 3],
    up: [f64; 3],
}

impl Axes {
    pub(super) fn project(&self, point: [f64; 3]) -> [f64; 2] {
        [dot(point, self.right), dot(point, self.up)]
    }
}

/// The view of the scene in which the mirrored rays of a path are longest.
pub(super) fn view(life: &Life, points: &[[f64; 3]]) -> Axes {
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
