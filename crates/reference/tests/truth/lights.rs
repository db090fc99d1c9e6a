//! What lights light, and what hides them.

use catoptric_scene::{Camera, Image, Material};

use super::scenes::{
    BOTH, DARK, GREEN, RED, ahead, assert_near, ball, night, plane, render, white_light,
};

#[test]
fn an_eye_inside_a_sphere_sees_its_far_side_lit_from_within() {
    // The eye off centre, a light at the centre: the wall ahead is met straight on.
    let mut scene = night([0.0, 0.0, 2.0]);
    scene.spheres = vec![ball(&mut scene, [0.0, 0.0, 2.0], 5.0, RED)];
    let mut outside = scene.clone();
    outside.lights = vec![white_light([0.0, 0.0, 8.0])];
    for precision in BOTH {
        assert_near(ahead(&scene, precision), RED, 1e-15);
        assert_eq!(ahead(&outside, precision), DARK, "the wall hides a light outside");
    }
}

#[test]
fn a_light_inside_a_sphere_lights_nothing_outside() {
    let mut scene = night([0.0, 3.0, -4.0]);
    scene.planes = vec![plane(&mut scene, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], GREEN)];
    let mut covered = scene.clone();
    covered.spheres = vec![ball(&mut covered, [0.0, 3.0, -4.0], 0.5, RED)];
    for precision in BOTH {
        assert!(ahead(&scene, precision)[1] > 0.3);
        assert_eq!(ahead(&covered, precision), DARK);
    }
}

#[test]
fn a_light_on_a_sphere_lights_its_own_side_only() {
    let mut scene = night([1.0, 2.0, -8.0]);
    scene.image = Image { width: 40, height: 40, ..scene.image };
    scene.camera.fov = 60.0;
    scene.planes = vec![
        plane(&mut scene, [0.0, 0.0, -20.0], [0.0, 0.0, 1.0], GREEN),
        plane(&mut scene, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], GREEN),
    ];
    scene.spheres = vec![ball(&mut scene, [0.0, 0.0, -10.0], 3.0, RED)];
    // What faces the light is decided by the tangent plane at it: x + 2y + 2(z + 10) = 9.
    for precision in BOTH {
        let film = render(&scene, precision);
        let half = 30.0_f64.to_radians().tan();
        for (index, pixel) in film.pixels.iter().enumerate() {
            let x = half * (((index % 40) as f64 + 0.5) / 20.0 - 1.0);
            let y = -half * (((index / 40) as f64 + 0.5) / 20.0 - 1.0);
            // The sphere's limb from the origin: tan = 3 / sqrt(91).
            if x * x + y * y < 9.0 / 91.0 {
                assert_eq!(*pixel, DARK, "the sphere is not lit by a light on it");
                continue;
            }
            let above = 20.0 * x + 40.0 * y - 20.0 > 9.0;
            assert_eq!(pixel[1] > 0.0, above, "{precision:?}: wall at {x},{y}: {pixel:?}");
        }
    }
}

#[test]
fn a_light_behind_a_plane_or_in_it_does_not_light_it() {
    let glossy = |material: &mut Material| {
        (material.specular, material.reflect) = (1.0, Some(0.0));
    };
    let heights = [([2.3, -0.3, -4.9], true), ([2.3, -0.3, -5.1], false)];
    for (light, lit) in heights {
        let mut scene = night(light);
        scene.planes = vec![plane(&mut scene, [0.3, 0.7, -5.0], [0.1, 0.2, 1.0], GREEN)];
        scene.remake_materials(glossy);
        for precision in BOTH {
            assert_eq!(ahead(&scene, precision)[1] > 0.0, lit, "{light:?} {precision:?}");
        }
    }
    // Exactly in the plane, seen in every direction: no highlight from rounding's n·l.
    let mut scene = night([2.0, -1.0, -5.0]);
    scene.image = Image { width: 30, height: 30, ..scene.image };
    scene.planes = vec![plane(&mut scene, [0.0, 0.0, -5.0], [1.0, 2.0, 7.0], GREEN)];
    scene.remake_materials(glossy);
    for precision in BOTH {
        let film = render(&scene, precision);
        assert!(film.pixels.iter().all(|&pixel| pixel == DARK), "{precision:?}");
        assert_eq!(film.counts.shadow(), 0);
    }
}

#[test]
fn a_light_in_one_plane_lights_another() {
    // The light is in the side wall x = 3; no ray to it passes the wall.
    let mut scene = night([3.0, 0.0, -4.0]);
    scene.planes = vec![
        plane(&mut scene, [0.0, 0.0, -5.0], [0.0, 0.0, 1.0], GREEN),
        plane(&mut scene, [3.0, 1.0, 1.0], [1.0, 0.0, 0.0], RED),
    ];
    for precision in BOTH {
        let cosine = 1.0 / 10.0_f64.sqrt();
        assert_near(ahead(&scene, precision), [0.0, cosine, 0.0], 1e-15);
        let mut beyond = scene.clone();
        beyond.lights = vec![white_light([3.5, 0.0, -4.0])];
        assert_eq!(ahead(&beyond, precision), DARK);
    }
}

#[test]
fn a_light_at_the_hit_lights_nothing() {
    let mut scene = night([0.0, 0.0, -3.0]);
    scene.spheres = vec![ball(&mut scene, [0.0, 0.0, -5.0], 2.0, RED)];
    for precision in BOTH {
        assert_eq!(ahead(&scene, precision), DARK);
    }
}

#[test]
fn a_shadow_falls_where_the_occluder_is_nearer_than_the_light() {
    // The wall's middle, the light straight off it at distance 4, a ball between or beyond.
    let mut scene = night([0.0, 4.0, -5.0]);
    scene.planes = vec![plane(&mut scene, [0.0, 0.0, -5.0], [0.0, 1.0, 1.0], GREEN)];
    for (height, hidden) in [(2.0, true), (5.5, false), (-2.0, false)] {
        scene.spheres = vec![ball(&mut scene, [0.0, height, -5.0], 1.0, RED)];
        for precision in BOTH {
            assert_eq!(ahead(&scene, precision) == DARK, hidden, "ball at {height}");
        }
    }
}

#[test]
fn a_contact_is_in_shadow() {
    // A ball that stands on the floor; the floor just at the contact, the light overhead.
    let mut scene = night([0.0, 9.0, -5.0]);
    scene.camera = Camera { position: [0.0, 1.0, 5.0], look_at: [0.0, -1.0, -5.0], ..scene.camera };
    scene.planes = vec![plane(&mut scene, [0.0, -1.0, 0.0], [0.0, 1.0, 0.0], GREEN)];
    scene.spheres = vec![ball(&mut scene, [0.0, 1e-3 - 1.0, -5.0], 1e-3, DARK)];
    for precision in BOTH {
        assert_eq!(ahead(&scene, precision), DARK);
        scene.spheres[0].center[0] = 1.0;
        assert!(ahead(&scene, precision)[1] > 0.9);
        scene.spheres[0].center[0] = 0.0;
    }
}

/// Along a generic line the highlight's cosine rounds to 1 or past it; an enormous power
/// must not make light of that.
#[test]
fn a_highlight_is_never_brighter_than_its_light() {
    let material =
        Material { specular: 1.0, shininess: 1e38, reflect: Some(0.0), ..Material::matt(DARK) };
    for step in 0..50 {
        let at = [0.1 * f64::from(step), 0.7, -3.1];
        let mut scene = night([0.0; 3]);
        scene.camera.look_at = at;
        scene.spheres = vec![ball(&mut scene, at, 1.3, DARK)];
        scene.remake_materials(|made| *made = material);
        for precision in BOTH {
            assert!(ahead(&scene, precision).iter().all(|&channel| (0.0..=1.0).contains(&channel)));
        }
    }
}
