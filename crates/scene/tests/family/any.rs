//! Any parameters in range make a valid scene.

use catoptric_scene::family::{
    Arrangement, Corridor, Kissing, Lattice, Placement, Random, Room, Sphereflake,
};
use catoptric_scene::{Draft, Scene};
use proptest::prelude::*;
use proptest::sample::select;

/// A real in a range over decades, often an end of it.
fn real(least: f64, most: f64) -> impl Strategy<Value = f64> {
    let exponent = least.log10()..most.log10();
    prop_oneof![
        6 => exponent.prop_map(move |e| 10f64.powf(e).clamp(least, most)),
        1 => Just(least),
        1 => Just(most),
    ]
}

fn reflect() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 0.0..=1.0_f64, 1 => select(vec![0.0, -0.0, 1.0])]
}

fn huge_radius() -> impl Strategy<Value = Option<f64>> {
    proptest::option::of(real(10.0, 1e12))
}

pub(super) fn corridor() -> impl Strategy<Value = Corridor> {
    (0..300_u32, reflect(), huge_radius(), any::<u64>()).prop_map(
        |(balls, reflect, mirror_radius, seed)| Corridor { balls, reflect, mirror_radius, seed },
    )
}

pub(super) fn room() -> impl Strategy<Value = Room> {
    (real(1e-3, 1e9), 0..300_u32, reflect(), any::<u64>())
        .prop_map(|(radius, balls, reflect, seed)| Room { radius, balls, reflect, seed })
}

pub(super) fn kissing() -> impl Strategy<Value = Kissing> {
    let group = prop_oneof![
        (2..=4_u32).prop_map(|n| (Arrangement::Cluster, n)),
        (3..300_u32).prop_map(|n| (Arrangement::Ring, n)),
        (2..300_u32).prop_map(|n| (Arrangement::Chain, n)),
    ];
    (group, real(1e-6, 1e6), reflect(), any::<u64>()).prop_map(
        |((arrangement, spheres), radius, reflect, seed)| Kissing {
            arrangement,
            spheres,
            radius,
            reflect,
            seed,
        },
    )
}

pub(super) fn random() -> impl Strategy<Value = Random> {
    let placement = select(vec![Placement::Apart, Placement::Anywhere]);
    let radii =
        (real(1e-9, 1e9), real(1e-9, 1e9)).prop_map(|(a, b)| if a <= b { (a, b) } else { (b, a) });
    (0..200_u32, radii, placement, reflect(), any::<u64>()).prop_map(
        |(balls, (min_radius, max_radius), placement, reflect, seed)| Random {
            balls,
            min_radius,
            max_radius,
            placement,
            reflect,
            seed,
        },
    )
}

fn lattice() -> impl Strategy<Value = Lattice> {
    (1..=9_u32, real(1e-6, 0.5), reflect(), any::<u64>())
        .prop_map(|(edge, radius, reflect, seed)| Lattice { edge, radius, reflect, seed })
}

fn sphereflake() -> impl Strategy<Value = Sphereflake> {
    (0..=3_u32, reflect(), huge_radius(), any::<u64>()).prop_map(
        |(levels, reflect, ground_radius, seed)| Sphereflake {
            levels,
            reflect,
            ground_radius,
            seed,
        },
    )
}

fn valid(draft: Draft) -> Result<(), TestCaseError> {
    let scene = Scene::new(draft);
    prop_assert!(scene.is_ok(), "{}", scene.unwrap_err());
    Ok(())
}

proptest! {
    #[test]
    fn any_corridor_is_a_scene(corridor in corridor()) {
        valid(corridor.draft().unwrap())?;
    }

    #[test]
    fn any_room_is_a_scene(room in room()) {
        valid(room.draft().unwrap())?;
    }

    #[test]
    fn any_kissing_is_a_scene(kissing in kissing()) {
        valid(kissing.draft().unwrap())?;
    }

    #[test]
    fn any_random_is_a_scene(random in random()) {
        valid(random.draft().unwrap())?;
    }

    #[test]
    fn any_lattice_is_a_scene(lattice in lattice()) {
        valid(lattice.draft().unwrap())?;
    }

    #[test]
    fn any_sphereflake_is_a_scene(flake in sphereflake()) {
        valid(flake.draft().unwrap())?;
    }
}
