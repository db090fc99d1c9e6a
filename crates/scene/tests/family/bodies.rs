//! Corridor, room, random, lattice: where the bodies are.

use catoptric_scene::Sphere;
use catoptric_scene::family::{Lattice, Placement, Random};
use proptest::prelude::*;

use super::any::{corridor, random, room};
use super::{distance, gap};

fn all_apart(spheres: &[Sphere]) -> Result<(), TestCaseError> {
    for (index, a) in spheres.iter().enumerate() {
        for b in &spheres[..index] {
            prop_assert!(gap(a, b) > 0.0, "{a:?} and {b:?}");
        }
    }
    Ok(())
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(64))]

    #[test]
    fn corridors_keep_their_balls_apart_and_off_the_mirrors(corridor in corridor()) {
        let draft = corridor.draft().unwrap();
        let mirrors = if corridor.mirror_radius.is_some() { 2 } else { 0 };
        prop_assert_eq!((draft.spheres.len() - mirrors, draft.planes.len()), (corridor.balls as usize, 3 - mirrors));
        all_apart(&draft.spheres)?;
        for ball in &draft.spheres[mirrors..] {
            // On the floor at -1, to the rounding of the sum.
            prop_assert!((ball.center[1] - ball.radius + 1.0).abs() < 1e-15);
            prop_assert!(ball.center[2].abs() + ball.radius < 4.0);
            prop_assert!(distance(ball.center, draft.camera.position) > ball.radius);
        }
    }

    #[test]
    fn rooms_hold_balls_eye_and_light(room in room()) {
        let draft = room.draft().unwrap();
        let (wall, balls) = draft.spheres.split_first().unwrap();
        prop_assert_eq!((wall.radius, balls.len()), (room.radius, room.balls as usize));
        all_apart(balls)?;
        for ball in balls {
            prop_assert!(distance(ball.center, wall.center) + ball.radius < wall.radius);
        }
        for point in [draft.camera.position, draft.lights[0].position] {
            prop_assert!(distance(point, wall.center) < wall.radius);
            prop_assert!(balls.iter().all(|ball| distance(point, ball.center) > ball.radius));
        }
    }

    #[test]
    fn random_balls_are_in_their_ranges(random in random()) {
        let draft = random.draft().unwrap();
        prop_assert_eq!(draft.spheres.len(), random.balls as usize);
        let radii = random.min_radius..=random.max_radius;
        prop_assert!(draft.spheres.iter().all(|ball| radii.contains(&ball.radius)));
        if random.placement == Placement::Apart {
            all_apart(&draft.spheres)?;
        }
        for ball in &draft.spheres {
            let floor = draft.planes[0].point[1];
            prop_assert!(ball.center[1] - ball.radius > floor);
            prop_assert!(distance(ball.center, draft.camera.position) > ball.radius);
        }
    }
}

#[test]
fn random_radii_are_as_many_in_each_decade() {
    let random = Random { balls: 40_000, min_radius: 1e-4, max_radius: 1.0, ..Random::default() };
    let draft = random.draft().unwrap();
    let mut decades = [0; 4];
    for ball in &draft.spheres {
        decades[3 - (-ball.radius.log10()).floor().clamp(0.0, 3.0) as usize] += 1;
    }
    // Expected 10 000 each with a standard deviation of 87.
    assert!(decades.iter().all(|count| (9_600..10_400).contains(count)), "{decades:?}");
}

#[test]
fn random_balls_of_one_size_have_it_to_the_bit_and_keep_apart() {
    for radius in [0.1, 0.7, 1.0, 3.3, 1e-9, 1e9] {
        let random =
            Random { balls: 200, min_radius: radius, max_radius: radius, ..Random::default() };
        let spheres = random.draft().unwrap().spheres;
        assert!(spheres.iter().all(|ball| ball.radius.to_bits() == radius.to_bits()), "{radius}");
        all_apart(&spheres).unwrap();
    }
}

#[test]
fn random_balls_fill_their_cube() {
    for placement in [Placement::Apart, Placement::Anywhere] {
        // One more than 13 cubed: a fifth of the 14 cubed cells stays empty.
        let random = Random { balls: 2_198, placement, ..Random::default() };
        let draft = random.draft().unwrap();
        let mut octants = [0; 8];
        for ball in &draft.spheres {
            let [x, y, z] = ball.center.map(|x| usize::from(x > 0.0));
            octants[4 * z + 2 * y + x] += 1;
        }
        // Expected 275 each with a standard deviation of 16.
        assert!(octants.iter().all(|count| (215..335).contains(count)), "{octants:?}");
    }
}

#[test]
fn a_lattice_is_a_grid_of_step_one() {
    let draft = Lattice { edge: 3, radius: 0.5, ..Lattice::default() }.draft().unwrap();
    let at = [-1.0, 0.0, 1.0];
    let grid = at.iter().flat_map(|&z| at.iter().flat_map(move |&y| at.map(|x| [x, y, z])));
    assert!(draft.spheres.iter().map(|ball| ball.center).eq(grid));
    assert!(draft.spheres.iter().all(|ball| ball.radius.to_bits() == 0.5_f64.to_bits()));

    let largest = Lattice { edge: 100, ..Lattice::default() }.draft().unwrap();
    assert_eq!(largest.spheres.len(), 1_000_000);
    assert_eq!(largest.spheres[999_999].center, [49.5; 3]);
}
