//! Kissing: the spheres touch to the rounding of f64.

use catoptric_scene::family::{Arrangement, Kissing};
use proptest::prelude::*;

use super::any::kissing;
use super::gap;

/// Of the largest coordinate.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

proptest! {
    #[test]
    fn neighbours_touch_and_others_do_not(kissing in kissing()) {
        let spheres = kissing.draft().unwrap().spheres;
        let n = spheres.len();
        prop_assert_eq!(n, kissing.spheres as usize);
        let largest = spheres.iter().flat_map(|s| s.center).map(f64::abs).fold(0.0, f64::max);
        let rounding = largest * ROUNDING;
        for (i, a) in spheres.iter().enumerate() {
            for (j, b) in spheres[..i].iter().enumerate() {
                let touch = match kissing.arrangement {
                    Arrangement::Cluster => true,
                    Arrangement::Ring => i - j == 1 || i - j == n - 1,
                    Arrangement::Chain => i - j == 1,
                };
                let gap = gap(a, b);
                if touch {
                    prop_assert!(gap.abs() <= rounding, "{i} and {j}: {gap:e}, rounding {rounding:e}");
                } else {
                    prop_assert!(gap > 0.1 * kissing.radius, "{i} and {j}: {gap:e}");
                }
            }
        }
    }
}

/// The ring's own cosine and sine, held against the system's, which are good to an ulp.
#[test]
fn rings_are_round() {
    for n in (3..=200).chain([1_000, 65_536, 999_999, 1_000_000]) {
        let ring = Kissing { arrangement: Arrangement::Ring, spheres: n, ..Kissing::default() };
        let spheres = ring.draft().unwrap().spheres;
        let circle = 1.0 / (std::f64::consts::PI / f64::from(n)).sin();
        for (k, sphere) in (0..n).zip(&spheres).step_by(1 + n as usize / 1_000) {
            let angle = std::f64::consts::TAU * (f64::from(k) / f64::from(n));
            let [x, y, z] = sphere.center;
            // Near a whole turn the angle itself is rounded by 2^-51.
            let error = ((x / circle - angle.cos()).abs(), (y / circle - angle.sin()).abs());
            assert!(error.0 < 2e-15 && error.1 < 2e-15, "{k} of {n}: {error:?}");
            assert_eq!(z.to_bits(), 0);
        }
        let (first, last) = (&spheres[0], &spheres[n as usize - 1]);
        assert!(super::gap(first, last).abs() <= circle * ROUNDING, "{n}");
    }
}
