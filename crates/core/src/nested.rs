//! Which primitives no ray can meet: balls wholly inside another ball.
//!
//! A ray from outside the outer ball meets that one first, and a way to a lamp that the inner ball
//! blocks is blocked by the outer one. Both hold in the reals. So that they hold as computed, the
//! gap between the two surfaces is above all rounding: with S as far as anything stands from the
//! eye, origins and centres are at most 2S apart, u = 6e-8 in f32, the foot of the perpendicular is
//! within 40u S and r^2 within 4u relative. That is as if the inner ball were up to 42u S larger
//! and the outer one as much smaller; and distances are off by another 16u S each. Together this
//! is below 7e-6 S.
//!
//! A ray that leaves the outer ball itself does not try it, but it goes outward, up to a few u, and
//! never comes closer to the inner one than the gap.
//!
//! On a plane points are as far away as one likes, and a distance there has no last places left to
//! tell the two apart: with one nothing is left out. Balls around the eye hold what is seen.

use catoptric_scene::{Compiled, Numerics, Scalar, Shape};

use crate::sight::in_f64;

/// The least gap, in units of S.
const MARGIN: f64 = 2e-5;

/// The indices of all primitives, in ascending order.
pub(crate) fn all<S: Scalar>(scene: &Compiled<S>) -> Vec<u32> {
    (0..).zip(&scene.primitives).map(|(index, _)| index).collect()
}

/// The indices of all primitives but those, in ascending order.
pub(crate) fn reachable<S: Scalar>(scene: &Compiled<S>) -> Vec<u32> {
    let mut reachable = all(scene);
    let Some(extent) = extent(scene) else { return reachable };
    let gap = MARGIN * extent;
    let ball = |shape: &Shape<S>| match shape {
        Shape::Ball(ball) if !ball.is_around() => {
            Some((in_f64::<S>(ball.center), ball.radius.to_f64()))
        }
        _ => None,
    };
    let mut outer: Vec<_> = scene.primitives.iter().filter_map(|p| ball(&p.shape)).collect();
    outer.sort_unstable_by(|a, b| b.1.total_cmp(&a.1));
    let is_inside = |shape: &Shape<S>| {
        ball(shape).is_some_and(|(center, radius)| {
            let larger = outer.iter().take_while(|outer| outer.1 > radius + gap);
            larger.into_iter().any(|outer| outer.0.distance(center) + radius + gap < outer.1)
        })
    };
    reachable.retain(|&index| !is_inside(&scene.primitives[index as usize].shape));
    reachable
}

/// As far as anything stands from the eye; `None` if there is no end.
fn extent<S: Scalar>(scene: &Compiled<S>) -> Option<f64> {
    if scene.numerics == Numerics::Textbook {
        return None;
    }
    let mut extent = 0.0;
    for primitive in &scene.primitives {
        let reach = match &primitive.shape {
            Shape::Ball(ball) => in_f64::<S>(ball.center).length() + ball.radius.to_f64(),
            Shape::Flat(flat) if flat.curvature != S::ZERO => {
                (in_f64::<S>(flat.lean).length() + 1.0) / flat.curvature.to_f64().abs()
            }
            _ => return None,
        };
        extent = if reach > extent { reach } else { extent };
    }
    Some(extent)
}
