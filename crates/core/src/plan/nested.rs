//! Nested spheres: spheres wholly inside another one, which no ray can meet.
//!
//! A ray from outside the outer sphere meets that one first, and a way to a light that the inner
//! sphere blocks is blocked by the outer one. Both hold in the reals. So that they hold as
//! computed, the gap between the two surfaces is above all rounding: with S as far as anything
//! stands from the eye, origins and centres are at most 2S apart, u = 6e-8 in f32, the foot of the
//! perpendicular is within 40u S and r^2 within 4u relative. That is as if the inner sphere were up
//! to 42u S larger and the outer one as much smaller; and distances are off by another 16u S each.
//! Together this is below 7e-6 S.
//!
//! A ray that leaves the outer sphere itself does not try it, but it goes outward, up to a few u,
//! and never comes closer to the inner one than the gap.
//!
//! On a plane points are as far away as one likes, and a distance there has no last places left to
//! tell the two apart: with one nothing is left out. Spheres around the eye hold what is seen.
//!
//! No pairs are gone through. Spheres are taken by falling radius, and only one that is inside no
//! other is kept as one that may hold others: what is inside an inner sphere is inside the outer
//! one too, by the gaps of both. Holders are found by place (`holders`), in a bounded number of
//! steps a sphere. Where places are so crowded that these do not suffice, a sphere may be found to
//! be inside none. It is then tested like any other.

use catoptric_scene::{Compiled, Numerics, Scalar};

use super::holders::{Bound, Holders};
use crate::shape::facts;

/// The least gap, in units of S.
const MARGIN: f64 = 2e-5;

/// The indices of all primitives, in ascending order.
pub(crate) fn all<S: Scalar>(scene: &Compiled<S>) -> Vec<u32> {
    (0..).zip(&scene.primitives).map(|(index, _)| index).collect()
}

/// The indices of all primitives but those nested ones, in ascending order as they are.
pub(crate) fn others<S: Scalar>(scene: &Compiled<S>, nested: &[u32]) -> Vec<u32> {
    let mut nested = nested.iter().peekable();
    let mut others = all(scene);
    others.retain(|index| nested.next_if_eq(&index).is_none());
    others
}

/// The indices of the primitives that no ray can meet, in ascending order.
pub(crate) fn nested<S: Scalar>(scene: &Compiled<S>) -> Vec<u32> {
    let Some(extent) = extent(scene) else { return Vec::new() };
    let shapes = (0..).zip(scene.primitives.iter().map(|p| facts(&p.shape)));
    let outside = shapes.filter(|(_, shape)| !shape.encloses_eye());
    let spheres = outside.filter_map(|(index, shape)| Some((index, shape.sphere()?)));
    inside(spheres.collect(), MARGIN * extent, &mut || ())
}

/// The spheres that are inside another one, in ascending order. `step` is told of every cell
/// that is looked up and of every pair that is compared.
fn inside(mut spheres: Vec<(u32, Bound)>, gap: f64, step: &mut impl FnMut()) -> Vec<u32> {
    let (mut smallest, mut largest) = (f64::INFINITY, 0.0);
    for &(_, (_, radius)) in &spheres {
        smallest = if radius < smallest { radius } else { smallest };
        largest = if radius > largest { radius } else { largest };
    }
    let may_hold = |radius| radius > smallest + gap;
    let may_be_held = |radius| radius + gap < largest;
    spheres.retain(|&(_, (_, radius))| may_hold(radius) || may_be_held(radius));
    spheres.sort_unstable_by(|(_, a), (_, b)| b.1.total_cmp(&a.1));
    let (indices, spheres): (Vec<u32>, Vec<Bound>) = spheres.into_iter().unzip();

    let mut holders = Holders::new(&spheres, gap);
    let mut inside = Vec::new();
    for ((number, index), &(center, radius)) in (0..).zip(indices).zip(&spheres) {
        let holds = |outer: Bound| outer.0.distance(center) + radius + gap < outer.1;
        if holders.any((center, radius), holds, step) {
            inside.push(index);
        } else if may_hold(radius) {
            holders.add(number);
        }
    }
    inside.sort_unstable();
    inside
}

/// The distance from the eye within which everything stands; `None` if there is no end.
fn extent<S: Scalar>(scene: &Compiled<S>) -> Option<f64> {
    if scene.numerics == Numerics::Textbook {
        return None;
    }
    let mut extent = 0.0;
    for primitive in &scene.primitives {
        let reach = facts(&primitive.shape).reach()?;
        extent = if reach > extent { reach } else { extent };
    }
    Some(extent)
}

#[cfg(test)]
mod tests {
    use glam::DVec3;

    use super::super::holders::{Bound, CELLS, MOST_COMPARED};
    use super::{MARGIN, inside};

    /// Octaves between the gap and the extent.
    const OCTAVES: usize = 17;

    /// A sequence of numbers in [0, 1), the same on every machine.
    struct Draws(u64);

    impl Draws {
        fn next(&mut self) -> f64 {
            self.0 = self.0.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (self.0 >> 11) as f64 / (1u64 << 53) as f64
        }

        /// A point in a cube of side 2.
        fn point(&mut self) -> DVec3 {
            DVec3::new(self.next(), self.next(), self.next()) * 2.0 - 1.0
        }
    }

    /// Spheres within 4 of the origin.
    fn layouts(count: u32) -> Vec<(&'static str, Vec<Bound>)> {
        let mut draws = Draws(7);
        let mut layout = |sphere: &mut dyn FnMut(f64, &mut Draws) -> Bound| {
            (0..count).map(|i| sphere(f64::from(i) / f64::from(count), &mut draws)).collect()
        };
        let up = DVec3::Y;
        vec![
            ("one size, apart", layout(&mut |_, draws| (draws.point(), 1e-3))),
            (
                "two sizes, apart",
                layout(&mut |i, draws| (draws.point(), 1e-2 + (1e-3 * i).round())),
            ),
            (
                "sizes of atoms on a shell",
                layout(&mut |i, draws| {
                    (draws.point().normalize() * 2.0, 1.5e-2 * (1.0 + (i * 4.0).floor() / 20.0))
                }),
            ),
            ("one centre", layout(&mut |i, _| (up, 1e-3 + i))),
            ("one centre and one radius", layout(&mut |_, _| (up, 0.5))),
            (
                "shells whose centres wander",
                layout(&mut |i, draws| (up + 1e-3 * draws.point(), 1e-3 + i)),
            ),
            (
                "a giant over all",
                layout(&mut |i, draws| {
                    if i == 0.0 { (DVec3::ZERO, 2.0) } else { (draws.point(), 1e-3 * draws.next()) }
                }),
            ),
            (
                "a giant over none",
                layout(&mut |i, draws| {
                    if i == 0.0 { (up * -3.0, 0.5) } else { (draws.point(), 1e-3 * draws.next()) }
                }),
            ),
            (
                "a long row",
                layout(&mut |i, _| (up * (2.0 * i - 1.0), 1e-3 * (1.0 + (i * 97.0).fract()))),
            ),
            (
                "radii over all octaves",
                layout(&mut |_, draws| (draws.point(), 10f64.powf(-9.0 * draws.next()))),
            ),
            (
                "radii over all octaves, none inside",
                layout(&mut |_, draws| {
                    let radius = 10f64.powf(-9.0 * draws.next());
                    (draws.point().normalize() * (2.0 - radius), radius)
                }),
            ),
            // As many as there are, a hair apart, hold what is around none of them.
            (
                "a crowd that all but holds",
                layout(&mut |i, draws| {
                    let size = if i < 0.5 { 1.0 } else { 1e-2 };
                    let at = if i < 0.5 { draws.point() * 1e-3 } else { draws.point().normalize() };
                    (at, size + 1e-6 * draws.next())
                }),
            ),
            (
                "crowds of every octave",
                layout(&mut |i, draws| {
                    let radius = (-(i * 14.0).floor()).exp2();
                    (
                        draws.point() * radius * 1e-2 + up * radius,
                        radius * (1.0 + 1e-3 * draws.next()),
                    )
                }),
            ),
        ]
    }

    fn numbered(spheres: &[Bound]) -> Vec<(u32, Bound)> {
        (0..).zip(spheres.iter().copied()).collect()
    }

    /// A million spheres take a bounded number of steps each, wherever they stand.
    #[test]
    fn steps_grow_with_balls_and_not_with_pairs() {
        for count in [1_000, 1_000_000] {
            for (name, spheres) in layouts(count) {
                let mut steps = 0usize;
                inside(numbered(&spheres), MARGIN * 4.0, &mut || steps += 1);
                let most = (OCTAVES * CELLS + MOST_COMPARED) * spheres.len();
                assert!(steps <= most, "{name}: {steps} steps for {count} spheres");
            }
        }
    }

    /// Usual scenes take a few steps a sphere.
    #[test]
    fn atoms_take_few_steps() {
        for (name, spheres) in layouts(50_000).into_iter().take(3) {
            let mut steps = 0usize;
            inside(numbered(&spheres), MARGIN * 4.0, &mut || steps += 1);
            assert!(steps <= 20 * spheres.len(), "{name}: {steps} steps");
        }
    }

    /// What all pairs say, but for crowds, where some are left out.
    #[test]
    fn what_is_found_is_what_pairs_say() {
        let gap = MARGIN * 4.0;
        for (name, spheres) in layouts(1_500) {
            let found = inside(numbered(&spheres), gap, &mut || ());
            let is_inside = |a: &Bound| spheres.iter().any(|b| b.0.distance(a.0) + a.1 + gap < b.1);
            let pairs: Vec<u32> =
                numbered(&spheres).iter().filter(|(_, a)| is_inside(a)).map(|(i, _)| *i).collect();
            if name.contains("crowd") {
                assert!(found.iter().all(|i| pairs.binary_search(i).is_ok()), "{name}");
            } else {
                assert_eq!(found, pairs, "{name}");
            }
        }
    }
}
