//! Edges of the model, each in both arithmetics.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::{Draft, Image, Material, Numerics, Plane, Scene, Sphere, View};

use super::scenes::{
    BOTH, DARK, GREEN, RED, ahead, assert_near, ball, closed_room, draft, mirror, night, plane,
    render, white_light,
};

#[test]
fn depth_counts_reflections() {
    // A mirror ahead shows the background behind the eye, from depth 1 on.
    let mut scene = draft();
    scene.planes = vec![plane(&mut scene, [0.0, 0.0, -1.0], [0.0, 0.0, 1.0], DARK)];
    scene.remake_materials(|material| *material = mirror(0.5));
    scene.render.background = [8.0; 3];
    for precision in BOTH {
        for (max_depth, expected) in [(0, 1.0), (1, 5.0), (2, 5.0), (u32::MAX, 5.0)] {
            scene.render.max_depth = max_depth;
            assert_eq!(ahead(&scene, precision), [expected; 3]);
        }
    }
}

#[test]
fn rays_are_counted_by_kind_and_depth() {
    // Mirrors at z = -1 and z = 1; two lights between them and one behind.
    let mut scene = draft();
    scene.image = Image { width: 1, height: 1, ..scene.image };
    scene.planes = vec![
        plane(&mut scene, [0.0, 0.0, -1.0], [0.0, 0.0, 1.0], RED),
        plane(&mut scene, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], RED),
    ];
    scene.remake_materials(|material| *material = mirror(1.0));
    scene.lights = [[1.0, 0.0, 0.0], [0.0, 2.0, 0.5], [0.0, 0.0, 3.0]].map(white_light).to_vec();
    scene.render.max_depth = 2;
    for precision in BOTH {
        let counts = render(&scene, precision).counts;
        assert_eq!((counts.primary(), counts.reflection()), (1, 2));
        // The light at z = 3 is in front of the mirror at z = -1, though hidden from it.
        let by_depth: Vec<_> = counts.depths.iter().map(|d| (d.rays, d.hits, d.shadow)).collect();
        assert_eq!(by_depth, [(1, 1, 3), (1, 1, 2), (1, 1, 3)]);
    }
}

#[test]
fn a_ray_below_the_least_weight_adds_black() {
    let mut scene = draft();
    scene.planes = vec![
        plane(&mut scene, [0.0, 0.0, -1.0], [0.0, 0.0, 1.0], RED),
        plane(&mut scene, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0], RED),
    ];
    scene.remake_materials(|material| *material = mirror(0.5));
    scene.render.max_depth = 60;
    // Weights 1, 1/2, 1/4: one that equals the least is still traced.
    for (least, expected) in [(1.5, 1.0), (0.6, 1.0), (0.5, 1.5), (0.25, 1.75), (0.2, 1.75)] {
        scene.render.min_weight = least;
        for precision in BOTH {
            assert_eq!(ahead(&scene, precision), [expected; 3], "least weight {least}");
        }
    }
}

#[test]
fn the_lowest_index_is_seen_of_equal_distances() {
    let mut draft = draft();
    let [red, green] = [RED, GREEN].map(|color| ball(&mut draft, [0.0, 0.0, -5.0], 2.0, color));
    // Touches the poles of both spheres.
    let wall = plane(&mut draft, [0.0, 0.0, -3.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let nearer = plane(&mut draft, [1.0, 2.0, -3.0], [0.0, 0.0, -7.0], RED);
    for precision in BOTH {
        let with = |spheres: Vec<Sphere>| Draft { spheres, planes: vec![wall], ..draft.clone() };
        assert_eq!(ahead(&with(vec![red, green]), precision), RED);
        assert_eq!(ahead(&with(vec![green, red]), precision), GREEN);
        let two = Draft { planes: vec![nearer, wall], ..draft.clone() };
        assert_eq!(ahead(&two, precision), RED);
    }
}

/// In exact arithmetic the twin ties with the surface just left; it is never seen, although
/// rounding would prefer it now and then.
#[test]
fn a_coincident_sphere_is_never_seen_from_inside_or_outside() {
    let once = closed_room(12, 9, 9);
    let mut twice = once.clone();
    for sphere in &once.spheres {
        twice
            .spheres
            .push(Sphere { material: twice.materials.add(Material::matt([50.0; 3])), ..*sphere });
    }
    twice
        .planes
        .push(Plane { material: twice.materials.add(Material::matt([50.0; 3])), ..once.planes[0] });
    for precision in BOTH {
        assert_eq!(render(&once, precision), render(&twice, precision));
    }
    // Indices stay those of the scene: the plane comes after all spheres, twins included.
    let mut floor = draft();
    floor.image = Image { width: 1, height: 1, ..floor.image };
    floor.spheres = vec![
        ball(&mut floor, [50.0, 0.0, 0.0], 1.0, RED),
        ball(&mut floor, [50.0, 0.0, 0.0], 1.0, RED),
    ];
    floor.planes = vec![plane(&mut floor, [0.0, 0.0, -1.0], [0.0, 0.0, 1.0], RED)];
    let scene = Scene::new(floor).expect("valid");
    let path = Truth::new(&scene, Precision::F64).path(&View::whole(&scene), 0, 0);
    assert_eq!((path.len(), path[0].primitive, path[0].point), (1, 2, [0.0, 0.0, -1.0]));
}

#[test]
fn an_eye_on_a_surface_counts_as_outside() {
    // On the sphere x² + y² + z² = 25 about (0, -4, -3): outward it sees past it ...
    let mut scene = draft();
    scene.spheres = vec![ball(&mut scene, [0.0, -4.0, -3.0], 5.0, RED)];
    scene.camera.look_at = [0.0, 4.0, 3.0];
    scene.camera.up = [1.0, 0.0, 0.0];
    // ... and inward it meets it at once.
    let mut inward = scene.clone();
    inward.camera.look_at = [0.0, -4.0, -3.0];
    // On a plane it is on the side that the stated normal points to.
    let mut floor = draft();
    floor.planes = vec![plane(&mut floor, [0.0; 3], [0.0, 0.0, 1.0], GREEN)];
    let mut ceiling = draft();
    ceiling.planes = vec![plane(&mut ceiling, [0.0; 3], [0.0, 0.0, -1.0], GREEN)];
    for precision in BOTH {
        assert_eq!(ahead(&scene, precision), DARK);
        assert_eq!(ahead(&inward, precision), RED);
        assert_eq!(ahead(&floor, precision), GREEN);
        assert_eq!(ahead(&ceiling, precision), DARK);
    }
}

/// Sphere of radius 3 about (0, 0, -10) in front of a wall at z = -20, light at (1, 2, -8),
/// which is on the sphere since 1 + 4 + 4 = 9.
#[test]
fn a_plane_is_seen_from_both_sides() {
    for normal in [[0.0, 0.0, 1.0], [0.0, 0.0, -1.0], [0.0, 0.0, 1e-200], [0.0, 0.0, -1e15]] {
        // A light at 45 degrees on the eye's side.
        let mut scene = night([3.0, 0.0, -2.0]);
        scene.planes = vec![plane(&mut scene, [7.0, 9.0, -5.0], normal, GREEN)];
        for precision in BOTH {
            assert_near(ahead(&scene, precision), [0.0, 0.5_f64.sqrt(), 0.0], 1e-15);
        }
    }
}

#[test]
fn an_empty_scene_is_background() {
    let mut scene = Draft { image: Image { width: 3, height: 2, ..Image::default() }, ..draft() };
    scene.render.background = [0.1, 0.2, 0.3];
    for precision in BOTH {
        let film = render(&scene, precision);
        assert_eq!(film.pixels, [[0.1, 0.2, 0.3]; 6]);
        assert_eq!(film.to_film().pixels(), [[0.1, 0.2, 0.3]; 6]);
        let counts = film.counts;
        assert_eq!((counts.primary(), counts.reflection(), counts.shadow()), (6, 0, 0));
        assert_eq!(counts.depths[0].hits, 0);
    }
}

#[test]
fn the_scenes_numerics_do_not_matter() {
    let robust = closed_room(9, 7, 5);
    let mut textbook = robust.clone();
    textbook.render.numerics = Numerics::Textbook;
    for precision in BOTH {
        assert_eq!(render(&robust, precision), render(&textbook, precision));
    }
}

/// Where f64 loses the radius altogether, it stays finite.
#[test]
fn a_sphere_below_the_rounding_of_its_place_gives_numbers() {
    let mut scene = night([0.0, 20.0, 0.0]);
    scene.spheres = vec![ball(&mut scene, [0.0, 0.0, -1e12], 1e-6, RED)];
    scene.remake_materials(|material| *material = mirror(0.5));
    for precision in BOTH {
        assert!(ahead(&scene, precision).iter().all(|channel| channel.is_finite()));
    }
}

/// The eye an ulp or so inside a huge sphere, looking along the wall: in f64 the
/// discriminant is nothing but rounding, and the wall is seen all the same.
#[test]
fn an_eye_inside_the_skin_of_a_huge_sphere_sees_the_wall() {
    for step in 0..60 {
        let (sin, cos) = (0.1 * f64::from(step)).sin_cos();
        let center = [5e11 * cos, 5e11 * sin, 5.99e11];
        let radius = center[0].hypot(center[1]).hypot(center[2]).next_up();
        let mut scene = draft();
        scene.spheres = vec![ball(&mut scene, center, radius, RED)];
        scene.camera.look_at = [-sin, cos, 0.0];
        scene.camera.up = [0.0, 0.0, 1.0];
        for precision in BOTH {
            assert_eq!(ahead(&scene, precision), RED, "{precision:?} {step}");
        }
        // A NaN distance would show the wall as well, nowhere.
        scene.image = Image { width: 1, height: 1, ..scene.image };
        let scene = Scene::new(scene).expect("valid");
        for precision in BOTH {
            let path = Truth::new(&scene, precision).path(&View::whole(&scene), 0, 0);
            assert!(path[0].point.iter().all(|x| x.is_finite()), "{precision:?} {step}");
        }
    }
}
