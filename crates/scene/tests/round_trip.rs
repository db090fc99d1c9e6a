//! What is written reads back, bit by bit.

use catoptric_scene::{Document, Draft, Material, Plane, Scene, SceneFormat, Sphere};
use proptest::prelude::*;

use crate::drafts::draft;

fn read_back(scene: &Scene, format: SceneFormat) -> Scene {
    let text = scene.to_text(format);
    assert_eq!(SceneFormat::of_text(text.as_bytes()), format);
    let document = Document::parse("written", text.as_bytes(), format);
    match document.and_then(Document::into_scene) {
        Ok(scene) => scene,
        Err(error) => panic!("{error}\n{text}"),
    }
}

proptest! {
    #[test]
    fn both_formats_read_back_to_the_same_bits(draft in draft()) {
        let scene = Scene::new(draft).expect("generated valid");
        for format in [SceneFormat::Toml, SceneFormat::Json] {
            let again = read_back(&scene, format);
            // Debug writes every f64 so that it tells all bits, the sign of zero included.
            prop_assert_eq!(format!("{scene:?}"), format!("{again:?}"));
        }
    }
}

/// Two spheres and a plane of one material, one sphere of its own.
fn sharing() -> Scene {
    let shared = Material { specular: 0.5, ..Material::matt([1.0, 0.25, 0.0]) };
    let own = Material { reflect: Some(0.0), ..Material::matt([1e-7, 1e20, -0.0]) };
    let sphere = |x, material| Sphere { center: [x, 0.0, -20.0], radius: 4.0, material };
    let plane = Plane { point: [0.0, -4.0, 0.0], normal: [0.0, 1.0, 0.0], material: shared };
    let draft = Draft {
        spheres: vec![sphere(0.0, shared), sphere(5.5, own), sphere(1.0, shared)],
        planes: vec![plane],
        ..Draft::default()
    };
    Scene::new(draft).expect("valid")
}

#[test]
fn toml_is_written_for_people() {
    let text = "\
[image]
width = 640
height = 480

[camera]
position = [0, 0, 0]
look_at = [0, 0, -1]
up = [0, 1, 0]
fov = 30

[render]
max_depth = 5

[materials.m0]
color = [1, 0.25, 0]
specular = 0.5

[[spheres]]
center = [0, 0, -20]
radius = 4
material = \"m0\"

[[spheres]]
center = [5.5, 0, -20]
radius = 4
color = [1e-7, 1e20, -0.0]
reflect = 0

[[spheres]]
center = [1, 0, -20]
radius = 4
material = \"m0\"

[[planes]]
point = [0, -4, 0]
normal = [0, 1, 0]
material = \"m0\"
";
    assert_eq!(sharing().to_text(SceneFormat::Toml), text);
}

#[test]
fn json_has_a_line_for_each_table() {
    let text = r#"{
  "image": {"width": 640, "height": 480},
  "camera": {"position": [0, 0, 0], "look_at": [0, 0, -1], "up": [0, 1, 0], "fov": 30},
  "render": {"max_depth": 5},
  "materials": {
    "m0": {"color": [1, 0.25, 0], "specular": 0.5}
  },
  "spheres": [
    {"center": [0, 0, -20], "radius": 4, "material": "m0"},
    {"center": [5.5, 0, -20], "radius": 4, "color": [1e-7, 1e20, -0.0], "reflect": 0},
    {"center": [1, 0, -20], "radius": 4, "material": "m0"}
  ],
  "planes": [
    {"point": [0, -4, 0], "normal": [0, 1, 0], "material": "m0"}
  ]
}
"#;
    assert_eq!(sharing().to_text(SceneFormat::Json), text);
}

#[test]
fn zeros_keep_their_signs() {
    let mut draft = Draft::default();
    draft.render.background = [0.0, -0.0, 0.0];
    draft.render.ambient = [0.0, 0.0, -0.0];
    draft.render.min_weight = -0.0;
    let scene = Scene::new(draft).expect("a zero of either sign is at least 0");
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        assert_eq!(format!("{:?}", read_back(&scene, format)), format!("{scene:?}"));
    }
}
