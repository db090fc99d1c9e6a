//! Path agreement.

use catoptric_reference::truth::Vertex;
use catoptric_scene::{Numerics, View};
use catoptric_study::stability::agreement::{COMPARED, agreement, plot, table};
use catoptric_study::stability::paths::{Arithmetic, Paths, parting};

use super::scenes::{matt, scene, seen, workshop};

#[test]
fn robust_paths_of_the_workshop_are_truths_and_textbook_ones_are_not() {
    let scene = workshop(160, 120, Numerics::Robust);
    let found = agreement(&scene, &View::whole(&scene), &COMPARED);
    assert_eq!(found.paths, 160 * 120);
    assert!(found.reaching.is_sorted_by(|a, b| a >= b) && found.reaching.len() == 9);
    for (arithmetic, parted) in &found.parted {
        assert!(parted.is_sorted(), "{arithmetic:?}: what has parted stays so");
        let last = parted[parted.len() - 1];
        // The textbook's offset starts mirrored rays 1.0 above the ground.
        assert_eq!(last > 1000, *arithmetic == Arithmetic::Textbook, "{arithmetic:?}: {last}");
        assert!(last == 0 || *arithmetic == Arithmetic::Textbook, "{arithmetic:?}: {last}");
    }
    let (_, textbook) = &found.parted[0];
    assert_eq!(found.share(textbook, 2), textbook[2] as f64 / 19_200.0);
    assert_eq!(table(&[("workshop".into(), found.clone())]).rows.len(), 4 * 8);
    assert_eq!(plot("workshop", &found).series.len(), 4);
}

#[test]
fn truth_agrees_with_itself() {
    let scene = workshop(40, 30, Numerics::Robust);
    let found = agreement(&scene, &View::whole(&scene), &[Arithmetic::DoubleDouble]);
    assert!(found.parted[0].1.iter().all(|parted| *parted == 0));
}

/// The robust form drops the twin, so every later sphere moves up by one place.
#[test]
fn a_surface_stated_twice_does_not_shift_the_others() {
    let spheres = [[-1.2, 0.1], [-1.2, 0.1], [1.3, -0.2]].map(|[x, y]| matt([x, y, -7.31], 1.07));
    let scene = scene(seen([24, 18], 40.0, [3.0, 9.0, 1.0], &spheres));
    let view = View::whole(&scene);
    let all = [Arithmetic::Robust, Arithmetic::RobustF64, Arithmetic::Textbook];
    for (arithmetic, parted) in agreement(&scene, &view, &all).parted {
        assert!(parted.iter().all(|parted| *parted == 0), "{arithmetic:?}: {parted:?}");
    }
    let right = Paths::new(&scene, &view, Arithmetic::Robust).path(16, 9);
    assert_eq!(right[0].primitive, 2);
}

#[test]
fn paths_part_where_primitives_differ_or_one_ends() {
    let path = |primitives: &[usize]| {
        let hit = |&primitive: &usize| {
            let (point, rest) = ([0.0; 3], [0.0; 3]);
            Vertex { primitive, point, rest, lit: Vec::new(), followed: true }
        };
        primitives.iter().map(hit).collect::<Vec<_>>()
    };
    let all = path(&[3, 1, 4]);
    let cases = [(&[3, 1, 4][..], None), (&[3, 2, 4], Some(1)), (&[3, 1], Some(2)), (&[], Some(0))];
    for (other, expected) in cases {
        assert_eq!(parting(&all, &path(other)), expected);
        assert_eq!(parting(&path(other), &all), expected);
    }
    assert_eq!(parting(&[], &[]), None);
}

/// Recentring is undone: a point of a recursion's path is truth's, up to its rounding, far from
/// the origin too.
#[test]
fn points_are_in_the_scenes_coordinates() {
    let place = [1.25e6, -3.5e6, 2.75e6];
    let mut draft = seen([16, 12], 20.0, [3.0, 9.0, 1.0], &[matt([0.21, 0.13, -7.31], 2.07)]);
    let moved = |at: &mut [f64; 3]| *at = std::array::from_fn(|i| at[i] + place[i]);
    moved(&mut draft.camera.position);
    moved(&mut draft.camera.look_at);
    moved(&mut draft.lights[0].position);
    moved(&mut draft.spheres[0].center);
    let scene = scene(draft);
    let view = View::whole(&scene);
    let truth = Paths::new(&scene, &view, Arithmetic::DoubleDouble);
    for (arithmetic, bound) in [(Arithmetic::Robust, 2e-6), (Arithmetic::RobustF64, 4e-15)] {
        let paths = Paths::new(&scene, &view, arithmetic);
        let mut hits = 0;
        for (x, y) in (0..12).flat_map(|y| (0..16).map(move |x| (x, y))) {
            let (found, truth) = (paths.path(x, y), truth.path(x, y));
            assert_eq!(parting(&found, &truth), None);
            for (found, truth) in found.iter().zip(&truth) {
                for c in 0..3 {
                    let error = found.point[c] - truth.point[c] + (found.rest[c] - truth.rest[c]);
                    assert!(error.abs() < bound, "{arithmetic:?} {x},{y}: {error}");
                }
                hits += 1;
            }
        }
        assert!(hits > 150, "{hits}");
    }
}
