//! Pictures that a formula gives.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::{Camera, Draft, Material, Materials, Plane, Scene, Sphere, View};

use super::scenes::{BOTH, ahead, assert_near, mirror, white_light};

fn sphere_ahead(material: Material) -> Draft {
    let mut draft = Draft::default();
    let material = draft.materials.add(material);
    draft.spheres.push(Sphere { center: [0.0, 0.0, -5.0], radius: 2.0, material });
    draft
}

/// Two mirrors z = -1 and z = 1, the eye between them looking across.
fn corridor(k: f64, max_depth: u32) -> Draft {
    let mut draft = Draft::default();
    let material = draft.materials.add(mirror(k));
    let at = |z| Plane { point: [0.0, 0.0, z], normal: [0.0, 0.0, 1.0], material };
    draft.planes = vec![at(-1.0), at(1.0)];
    draft.render.max_depth = max_depth;
    draft
}

#[test]
fn a_matt_sphere_without_lights_shows_ambient_times_color() {
    let mut draft = sphere_ahead(Material::matt([0.5, 0.25, 3.0]));
    draft.render.ambient = [0.1, 0.2, 0.4];
    draft.render.background = [7.0, 8.0, 9.0];
    for precision in BOTH {
        assert_near(ahead(&draft, precision), [0.05, 0.05, 1.2], 3e-16);
        let mut away = draft.clone();
        away.camera.look_at = [0.0, 0.0, 1.0];
        assert_eq!(ahead(&away, precision), [7.0, 8.0, 9.0]);
    }
}

#[test]
fn a_light_at_the_eye_lights_the_pole_in_full() {
    let material = Material {
        color: [0.5; 3],
        diffuse: 0.6,
        specular: 0.3,
        shininess: 9.0,
        reflect: Some(0.0),
    };
    let mut draft = sphere_ahead(material);
    draft.lights = vec![white_light([0.0; 3])];
    draft.lights[0].intensity = [1.0, 2.0, 4.0];
    for precision in BOTH {
        // 0.1 · 0.5 + I (0.6 · 0.5 · 1 + 0.3 · 1)
        assert_near(ahead(&draft, precision), [0.65, 1.25, 2.45], 1e-15);
    }
}

#[test]
fn the_highlight_falls_with_its_power() {
    // Straight down on z = 0 from a height of 4, a light at (3, 0, 4): n·l = r·(-d) = 4/5.
    let exact = [
        (0.0, 1.0),
        (1.0, 0.8),
        (0.5, 0.894_427_190_999_915_9),
        (2.5, 0.572_433_402_239_946_2),
        (20.0, 0.011_529_215_046_068_47),
        (0.1, 0.977_932_768_542_928_5),
        (3.75, 0.433_099_269_505_255_06),
        (1e30, 0.0),
    ];
    for (shininess, power) in exact {
        let mut materials = Materials::default();
        let material = materials.add(Material {
            color: [0.0; 3],
            diffuse: 1.0,
            specular: 1.0,
            shininess,
            reflect: Some(0.0),
        });
        let plane = Plane { point: [0.0; 3], normal: [0.0, 0.0, 2.0], material };
        let draft = Draft {
            camera: Camera { position: [0.0, 0.0, 4.0], look_at: [0.0; 3], ..Camera::default() },
            lights: vec![white_light([3.0, 0.0, 4.0])],
            materials,
            planes: vec![plane],
            ..Draft::default()
        };
        for precision in BOTH {
            let relative = if precision == Precision::F64 { 5e-15 } else { 2.3e-16 };
            assert_near(ahead(&draft, precision), [power; 3], relative);
        }
    }
}

#[test]
fn a_corridor_of_perfect_mirrors_adds_its_light_once_a_depth() {
    for precision in BOTH {
        for depth in [0, 1, 2, 7, 1000] {
            let expected = 0.1 * f64::from(depth + 1);
            // f64 adds 0.1 a thousand times.
            assert_near(ahead(&corridor(1.0, depth), precision), [expected; 3], 1e-13);
        }
    }
}

#[test]
fn a_corridor_of_imperfect_mirrors_adds_a_geometric_series() {
    // (1 - k^1001) / (1 - k) for k = 0.999, with the f64 nearest to 0.999.
    let series = 632.672_270_653_806_7;
    for precision in BOTH {
        assert_near(ahead(&corridor(0.999, 1000), precision), [0.1 * series; 3], 1e-7);
    }
    let short = 0.1 * (1.0 + 0.5 + 0.25 + 0.125);
    assert_near(ahead(&corridor(0.5, 3), Precision::DoubleDouble), [short; 3], 2e-16);
}

#[test]
fn a_closed_mirror_ball_adds_its_light_once_a_depth() {
    let mut draft = Draft {
        camera: Camera {
            position: [3.0, -2.0, 4.0],
            look_at: [3.3, 1.0, -4.0],
            ..Camera::default()
        },
        ..Draft::default()
    };
    let material = draft.materials.add(mirror(1.0));
    draft.spheres.push(Sphere { center: [0.0; 3], radius: 10.0, material });
    draft.render.background = [1e9; 3];
    draft.render.max_depth = 1000;
    for precision in BOTH {
        assert_near(ahead(&draft, precision), [100.1; 3], 1e-13);
    }
    // Every hit of the path is on the ball.
    draft.image.width = 1;
    draft.image.height = 1;
    let scene = Scene::new(draft).expect("valid");
    let path = Truth::new(&scene, Precision::DoubleDouble).path(&View::whole(&scene), 0, 0);
    assert_eq!(path.len(), 1001);
    for vertex in path {
        let [x, y, z] = vertex.point;
        assert!(((x * x + y * y + z * z) / 100.0 - 1.0).abs() < 1e-15, "{vertex:?}");
    }
}

/// Without scaling each reflected direction back to length 1, the error of the length grows
/// from bounce to bounce and the path leaves the ball.
#[test]
fn a_path_in_a_mirror_ball_stays_on_it() {
    let mut draft = sphere_ahead(mirror(1.0));
    draft.camera.position = [0.3, -0.4, -4.1];
    draft.camera.look_at = [1.0, 2.0, -5.0];
    draft.render.max_depth = 100_000;
    let scene = Scene::new(draft).expect("valid");
    let path = Truth::new(&scene, Precision::F64).path(&View::whole(&scene), 100, 200);
    assert_eq!(path.len(), 100_001);
    let [x, y, z] = path[100_000].point;
    let off = (x.hypot(y).hypot(z + 5.0) / 2.0 - 1.0).abs();
    assert!(off < 1e-9, "after 100 000 bounces the path is {off:e} off");
}
