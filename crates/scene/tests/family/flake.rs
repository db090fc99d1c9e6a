//! Sphereflake: counts, contact, directions.

use catoptric_scene::Sphere;
use catoptric_scene::family::Sphereflake;

use super::{distance, gap};

fn balls(levels: u32) -> Vec<Sphere> {
    Sphereflake { levels, ..Sphereflake::default() }.draft().unwrap().spheres
}

#[test]
fn counts_are_the_published_ones() {
    for (levels, count) in (0..).zip([1, 10, 91, 820, 7_381, 66_430, 597_871]) {
        assert_eq!(balls(levels).len(), count, "{levels} levels");
    }
}

#[test]
fn children_touch_their_parent_and_nobody_else() {
    let spheres = balls(3);
    for (index, child) in spheres.iter().enumerate().skip(1) {
        // A parent stands before its children: the last one before that is larger.
        let parent = spheres[..index].iter().rposition(|s| s.radius > 2.0 * child.radius).unwrap();
        assert!((child.radius - spheres[parent].radius / 3.0).abs() < 1e-16);
        assert!(gap(child, &spheres[parent]).abs() < 1e-15, "{index} of {parent}");
        // Siblings stand 60 degrees apart, 4/9 of the parent's radius and more between them.
        let siblings = spheres[parent..index].iter().filter(|s| s.radius >= child.radius * 0.99);
        for sibling in siblings.skip(1).filter(|s| s.radius < child.radius * 1.01) {
            assert!(gap(child, sibling) > 1.9 * child.radius, "{index}");
        }
    }
}

/// Angles to the axis that points away from the grandparent: six children at 90 degrees,
/// three at 90 less asin(2/sqrt 6).
#[test]
fn six_children_are_on_the_equator_and_three_above() {
    let spheres = balls(3);
    for (index, parent) in spheres.iter().enumerate() {
        let older = spheres[..index].iter().rfind(|s| s.radius > 2.0 * parent.radius);
        // The first ball's axis is z.
        let axis = older.map_or([0.0, 0.0, 1.0], |o| direction(o, parent));
        let descendants =
            spheres[index + 1..].iter().take_while(|s| s.radius < 0.9 * parent.radius);
        let children = descendants.filter(|s| s.radius > 0.3 * parent.radius);
        let mut heights: Vec<f64> = children
            .map(|child| {
                let away = direction(parent, child);
                (0..3).map(|i| away[i] * axis[i]).sum()
            })
            .collect();
        heights.sort_by(f64::total_cmp);
        if heights.is_empty() {
            continue;
        }
        let upper = 2.0 / 6.0_f64.sqrt();
        let expected = [0.0, 0.0, 0.0, 0.0, 0.0, 0.0, upper, upper, upper];
        assert_eq!(heights.len(), expected.len());
        for (height, expected) in heights.iter().zip(expected) {
            assert!((height - expected).abs() < 1e-12, "{index}: {heights:?}");
        }
    }
}

/// Twelve equal spheres around one, of which nine are there: every two 60, 90, 120 or 180
/// degrees apart, and each has the neighbours that the packing gives it.
#[test]
fn siblings_stand_as_in_the_cubic_packing() {
    let spheres = balls(1);
    let away: Vec<_> = spheres[1..].iter().map(|child| direction(&spheres[0], child)).collect();
    for (index, a) in away.iter().enumerate() {
        let mut angles: Vec<i64> = away
            .iter()
            .map(|b| {
                let cosine = 2.0 * (0..3).map(|i| a[i] * b[i]).sum::<f64>();
                assert!((cosine - cosine.round()).abs() < 1e-12);
                cosine.round() as i64
            })
            .collect();
        angles.sort_unstable();
        // Twice the cosines.
        let equator = [-2, -1, -1, -1, 0, 1, 1, 1, 2];
        let upper = [-1, -1, 0, 0, 1, 1, 1, 1, 2];
        assert_eq!(angles, if index < 6 { equator } else { upper });
    }
}

#[test]
fn the_ground_touches_the_first_ball() {
    let plane = Sphereflake::default().draft().unwrap();
    assert_eq!(
        (plane.planes[0].point, plane.planes[0].normal),
        ([0.0, 0.0, -0.5], [0.0, 0.0, 1.0])
    );
    let draft = Sphereflake { ground_radius: Some(1e4), ..Sphereflake::default() }.draft().unwrap();
    assert_eq!((draft.spheres.len(), draft.planes.len()), (7_382, 0));
    assert!(gap(&draft.spheres[0], &draft.spheres[1]).abs() < 1e-11);
}

fn direction(from: &Sphere, to: &Sphere) -> [f64; 3] {
    let length = distance(from.center, to.center);
    [0, 1, 2].map(|i| (to.center[i] - from.center[i]) / length)
}
