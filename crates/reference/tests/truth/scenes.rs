//! Scenes for the tests, and a way to look at one pixel.

use catoptric_reference::truth::{Precision, Truth, TruthFilm};
use catoptric_scene::{
    Camera, Draft, Image, Light, Material, Materials, Plane, Scene, Sphere, View,
};

/// Both arithmetics, for tests that hold in either.
pub(crate) const BOTH: [Precision; 2] = [Precision::F64, Precision::DoubleDouble];

pub(crate) fn render(draft: &Draft, precision: Precision) -> TruthFilm {
    let scene = Scene::new(draft.clone()).expect("a valid scene");
    Truth::new(&scene, precision).render(&View::whole(&scene)).expect("within the depth allowed")
}

/// The one pixel of a 1 x 1 picture: what is seen straight ahead.
pub(crate) fn ahead(draft: &Draft, precision: Precision) -> [f64; 3] {
    let mut draft = draft.clone();
    draft.image = Image { width: 1, height: 1, ..draft.image };
    render(&draft, precision).pixels[0]
}

/// Equal within `relative` of `expected` in every channel.
#[track_caller]
pub(crate) fn assert_near(found: [f64; 3], expected: [f64; 3], relative: f64) {
    for (f, e) in found.iter().zip(expected) {
        assert!((f - e).abs() <= relative * e.abs(), "found {found:?}, expected {expected:?}");
    }
}

/// The largest difference of any channel of any pixel.
pub(crate) fn largest_difference(a: &TruthFilm, b: &TruthFilm) -> f64 {
    assert_eq!((a.width, a.height), (b.width, b.height));
    let channels = a.pixels.as_flattened().iter().zip(b.pixels.as_flattened());
    channels.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max)
}

pub(crate) fn white_light(position: [f64; 3]) -> Light {
    Light { position, intensity: [1.0; 3] }
}

pub(crate) fn mirror(k: f64) -> Material {
    Material { reflect: Some(k), ..Material::matt([1.0; 3]) }
}

pub(crate) const RED: [f64; 3] = [1.0, 0.0, 0.0];
pub(crate) const GREEN: [f64; 3] = [0.0, 1.0, 0.0];
pub(crate) const DARK: [f64; 3] = [0.0; 3];

/// A matt sphere for that draft.
pub(crate) fn ball(draft: &mut Draft, center: [f64; 3], radius: f64, color: [f64; 3]) -> Sphere {
    Sphere { center, radius, material: draft.materials.add(Material::matt(color)) }
}

/// A matt plane for that draft.
pub(crate) fn plane(
    draft: &mut Draft,
    point: [f64; 3],
    normal: [f64; 3],
    color: [f64; 3],
) -> Plane {
    Plane { point, normal, material: draft.materials.add(Material::matt(color)) }
}

/// Ambient 1, so that a primitive shows its colour; looking along -z from the origin.
pub(crate) fn draft() -> Draft {
    let mut draft = Draft::default();
    draft.render.ambient = [1.0; 3];
    draft
}

/// Ambient 0, so that only lights show.
pub(crate) fn night(light: [f64; 3]) -> Draft {
    let mut draft = Draft { lights: vec![white_light(light)], ..Draft::default() };
    draft.render.ambient = DARK;
    draft
}

/// The workshop's five spheres, 30 degrees, a white light at (0, 20, 0); the ground's
/// mirror factor is a parameter (the workshop's own is 0).
pub(crate) fn workshop(width: u32, height: u32, max_depth: u32, ground: f64) -> Draft {
    let mut draft = Draft {
        image: Image { width, height, ..Image::default() },
        lights: vec![white_light([0.0, 20.0, 0.0])],
        ..Draft::default()
    };
    for (center, radius, color, shininess, specular, diffuse) in [
        ([0.0, -10004.0, -20.0], 10000.0, [0.4; 3], 0.0, 0.0, 1.0),
        ([0.0, 0.0, -20.0], 4.0, [1.0, 0.32, 0.36], 20.0, 0.8, 0.2),
        ([5.0, -1.0, -15.0], 2.0, [0.9, 0.76, 0.46], 20.0, 0.9, 0.1),
        ([5.0, 0.0, -25.0], 3.0, [0.65, 0.77, 0.97], 20.0, 0.5, 0.5),
        ([-5.5, 0.0, -15.0], 3.0, [0.9; 3], 20.0, 0.5, 0.5),
    ] {
        let material = Material { color, diffuse, specular, shininess, reflect: None };
        let material = draft.materials.add(material);
        draft.spheres.push(Sphere { center, radius, material });
    }
    draft.render.max_depth = max_depth;
    draft.materials[draft.spheres[0].material].reflect = Some(ground);
    draft
}

/// Three mirror spheres of radius 1 at the corners of a triangle of side 6: paths between
/// them amplify an error about twelvefold at each bounce.
pub(crate) fn scatterer(width: u32, height: u32) -> Draft {
    let mut materials = Materials::default();
    let material = materials.add(mirror(0.9));
    let at = |center| Sphere { center, radius: 1.0, material };
    let mut draft = Draft {
        materials,
        image: Image { width, height, ..Image::default() },
        camera: Camera {
            position: [0.1, -0.2, 0.3],
            look_at: [0.3, 3.1, 0.05],
            up: [0.0, 0.0, 1.0],
            fov: 40.0,
        },
        lights: vec![white_light([3.0, 2.0, 9.0]), white_light([-20.0, 1.0, -3.0])],
        spheres: vec![at([0.0, 3.46, 0.0]), at([-3.0, -1.73, 0.0]), at([3.0, -1.73, 0.0])],
        ..Draft::default()
    };
    draft.render.max_depth = 40;
    draft.render.background = [0.2, 0.3, 0.4];
    draft
}

/// A mirror ball of radius 10 around the eye with three balls, a tilted plane that cuts it
/// and five lights: two in the eye's cell, and one each inside a ball, beyond the plane and
/// outside the room.
pub(crate) fn closed_room(width: u32, height: u32, max_depth: u32) -> Draft {
    let mut materials = Materials::default();
    let material = materials.add(Material {
        color: [0.8, 0.5, 0.3],
        diffuse: 0.6,
        specular: 0.4,
        shininess: 7.0,
        reflect: Some(0.8),
    });
    let wall = materials.add(mirror(0.7));
    let ball = |center, radius| Sphere { center, radius, material };
    let mut draft = Draft {
        materials,
        image: Image { width, height, ..Image::default() },
        camera: Camera {
            position: [0.5, -0.3, 0.7],
            look_at: [-2.0, 1.0, -4.0],
            up: [0.1, 1.0, 0.2],
            fov: 70.0,
        },
        lights: [
            [1.0, 5.0, 1.0],
            [2.0, -4.0, -3.0],
            [-3.1, 1.0, -4.0],
            [1.0, -9.0, 1.0],
            [11.0, 9.0, -8.0],
        ]
        .map(white_light)
        .to_vec(),
        spheres: vec![
            ball([0.0, 0.0, 0.0], 10.0),
            ball([-3.0, 1.0, -4.0], 1.5),
            ball([4.0, -2.0, 1.0], 2.0),
            ball([0.0, 4.0, 5.0], 1.0),
        ],
        planes: vec![Plane { point: [0.0, -7.0, 0.0], normal: [0.2, 2.0, -0.1], material: wall }],
        ..Draft::default()
    };
    draft.render.max_depth = max_depth;
    draft
}
