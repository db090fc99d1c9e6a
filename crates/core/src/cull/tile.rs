//! Tile culling: the primitives that the eye rays of a tile can meet.
//!
//! The directions of a tile lie in a cone; a sphere is seen in another one. Where the cones are
//! apart no eye ray of the tile meets the sphere, and it need not be tested. Nothing else depends
//! on it: the candidates are tested in the order of their index, as all primitives would be.
//!
//! The bounds are formed in f64 and widened by far more than the f32 rays can be off. With u =
//! 6e-8, an eye ray's direction is within 8u of the exact one, for each of its components is
//! rounded for itself. The vector from a sphere's centre to the foot of the perpendicular is within
//! 10u |c|, and its square and r^2 within 4u relative; a large sphere's slope is within 4u
//! |scaled_center|. In f64 they are off by 2^-29 of that: the same bounds hold all the more.

use catoptric_scene::{Compiled, EyeRays, Scalar, Shape};
use glam::DVec3;

use crate::shape::{View, facts};

/// What bounds are widened by: 2e-6 is above 30u.
const MARGIN: f64 = 2e-6;

/// The directions in which a primitive may be seen from the eye.
enum ViewCone {
    /// All directions: it is around the eye, close to it, or not bounded.
    Everywhere,
    /// Directions within an angle of the axis.
    Cone { axis: DVec3, cos: f64, sin: f64 },
    /// Directions within a right angle of the axis: they fall towards it.
    Half { axis: DVec3 },
}

/// Primitives, and for each from where it may be seen.
pub(crate) struct TileCuller {
    cones: Vec<ViewCone>,
    all: Vec<u32>,
}

impl TileCuller {
    /// Prepares the primitives of some indices, in ascending order.
    pub(crate) fn new<S: Scalar>(scene: &Compiled<S>, candidates: Vec<u32>) -> Self {
        let cone = |&index: &u32| view_cone(&scene.primitives[index as usize].shape);
        Self { cones: candidates.iter().map(cone).collect(), all: candidates }
    }

    /// The indices of all of them.
    pub(crate) fn all(&self) -> &[u32] {
        &self.all
    }

    /// Puts the indices of the primitives that a tile's eye rays can meet into `candidates`.
    ///
    /// The tile is given by the positions of its columns and rows on the image plane.
    pub(crate) fn candidates<S: Scalar>(
        &self,
        eye: &EyeRays<S>,
        columns: &[S],
        rows: &[S],
        candidates: &mut Vec<u32>,
    ) {
        candidates.clear();
        let cone = TileCone::new(eye, columns, rows);
        let seen = |view: &&ViewCone| cone.as_ref().is_none_or(|cone| cone.meets(view));
        let all = self.all.iter().zip(&self.cones);
        candidates.extend(all.filter(|(_, view)| seen(view)).map(|(index, _)| index));
    }
}

/// A cone that holds the directions of a tile; its half angle is below a right angle.
struct TileCone {
    axis: DVec3,
    cos: f64,
    sin: f64,
}

impl TileCone {
    /// `None` where the tile spans more than such a cone.
    ///
    /// A cone cuts a convex figure out of the image plane, so one that holds the tile's
    /// corners holds the tile.
    fn new<S: Scalar>(eye: &EyeRays<S>, columns: &[S], rows: &[S]) -> Option<Self> {
        let ends = |line: &[S]| Some([*line.first()?, *line.last()?].map(S::to_f64));
        let (columns, rows) = (ends(columns)?, ends(rows)?);
        let [width, height, distance] =
            [eye.half_width, eye.half_height, eye.distance].map(S::to_f64);
        let direction = |x: f64, y: f64| DVec3::new(x * width, y * height, -distance).normalize();
        let axis = direction((columns[0] + columns[1]) / 2.0, (rows[0] + rows[1]) / 2.0);
        let mut cos = 1.0;
        for x in columns {
            for y in rows {
                let corner = axis.dot(direction(x, y));
                cos = if corner < cos { corner } else { cos };
            }
        }
        (cos > 0.0).then(|| Self { axis, cos, sin: (1.0 - cos * cos).sqrt() })
    }

    /// Whether the two cones have a direction in common, up to the margin: the angle of the
    /// axes is not above the sum of the half angles. Both are below a right angle, so the
    /// cosine of the sum falls with it.
    fn meets(&self, view: &ViewCone) -> bool {
        match view {
            ViewCone::Everywhere => true,
            ViewCone::Cone { axis, cos, sin } => {
                self.axis.dot(*axis) >= self.cos * cos - self.sin * sin - MARGIN
            }
            ViewCone::Half { axis } => self.axis.dot(*axis) >= -self.sin - MARGIN,
        }
    }
}

/// The directions in which a shape may be seen.
fn view_cone<S: Scalar>(shape: &Shape<S>) -> ViewCone {
    let shape = facts(shape);
    match (shape.view(), shape.sphere()) {
        (View::Disc, Some((center, radius))) => {
            let distance = center.length();
            let sin = radius * (1.0 + MARGIN) / distance + MARGIN;
            if sin < 1.0 {
                ViewCone::Cone { axis: center / distance, cos: (1.0 - sin * sin).sqrt(), sin }
            } else {
                ViewCone::Everywhere
            }
        }
        (View::Half { axis }, _) => {
            axis.try_normalize().map_or(ViewCone::Everywhere, |axis| ViewCone::Half { axis })
        }
        _ => ViewCone::Everywhere,
    }
}

#[cfg(test)]
mod tests;
