//! What the format means: defaults, the workshop's scene, names of formats.

use std::path::Path;

use catoptric_scene::{
    Camera, Document, Draft, Image, Light, Material, Materials, Numerics, Plane, Render, Scene,
    SceneFormat, Sphere, Transfer,
};

use crate::{json, toml};

#[test]
fn absent_keys_take_their_defaults() {
    let stated = toml(
        r#"
        [image]
        width = 640
        height = 480
        transfer = "linear"
        [camera]
        position = [0, 0, 0]
        look_at = [0, 0, -1]
        up = [0, 1, 0]
        fov = 30
        [render]
        max_depth = 5
        min_weight = 0
        background = [0, 0, 0]
        ambient = 0.1
        numerics = "robust"
        "#,
    );
    let stated = stated.expect("the defaults are valid");
    assert_eq!(*stated, Draft::default());
    let empty_tables = ["[image]", "[camera]", "[render]", "# only a comment", "[materials]"];
    for text in empty_tables {
        assert_eq!(toml(text).expect("all keys have defaults"), stated, "{text}");
    }
    for text in ["{}", r#"{"image": {}, "lights": [], "spheres": [], "materials": {}}"#] {
        assert_eq!(json(text).expect("all keys have defaults"), stated, "{text}");
    }
}

#[test]
fn lights_and_materials_have_defaults_too() {
    let scene = toml(
        "lights = [{ position = [1, 2, 3] }]
        spheres = [{ center = [0, 0, -5], radius = 1, color = [0.5, 0.5, 0.5] }]",
    )
    .expect("valid");
    assert_eq!(scene.lights, [Light { position: [1.0, 2.0, 3.0], intensity: [1.0; 3] }]);
    let material = scene.materials[scene.spheres[0].material];
    assert_eq!(material, Material::matt([0.5; 3]));
    assert_eq!((material.diffuse, material.specular, material.shininess), (1.0, 0.0, 0.0));
    assert_eq!(material.reflect, None);
}

/// The workshop's picture, most of whose settings are the defaults.
const WORKSHOP: &str = r#"
[[lights]]
position = [0, 20, 0]
intensity = 1

[materials.ground]
color = [0.4, 0.4, 0.4]

[materials.red]
color = [1.00, 0.32, 0.36]
diffuse = 0.2
specular = 0.8
shininess = 20

[[spheres]]
center = [0, -10004, -20]
radius = 10000
material = "ground"

[[spheres]]
center = [0, 0, -20]
radius = 4
material = "red"

[[spheres]]
center = [5, -1, -15]
radius = 2
color = [0.90, 0.76, 0.46]
diffuse = 0.1
specular = 0.9
shininess = 20

[[spheres]]
center = [5, 0, -25]
radius = 3
color = [0.65, 0.77, 0.97]
diffuse = 0.5
specular = 0.5
shininess = 20

[[spheres]]
center = [-5.5, 0, -15]
radius = 3
color = [0.90, 0.90, 0.90]
diffuse = 0.5
specular = 0.5
shininess = 20
"#;

#[test]
fn the_workshop_is_read() {
    let glossy = |color, diffuse, specular| Material {
        diffuse,
        specular,
        shininess: 20.0,
        ..Material::matt(color)
    };
    let mut expected = Draft::default();
    expected.lights.push(Light { position: [0.0, 20.0, 0.0], intensity: [1.0; 3] });
    let ground = expected.materials.add_named("ground", Material::matt([0.4; 3]));
    let red = expected.materials.add_named("red", glossy([1.0, 0.32, 0.36], 0.2, 0.8));
    expected.spheres = vec![
        Sphere { center: [0.0, -10_004.0, -20.0], radius: 10_000.0, material: ground },
        Sphere { center: [0.0, 0.0, -20.0], radius: 4.0, material: red },
    ];
    for (center, radius, material) in [
        ([5.0, -1.0, -15.0], 2.0, glossy([0.9, 0.76, 0.46], 0.1, 0.9)),
        ([5.0, 0.0, -25.0], 3.0, glossy([0.65, 0.77, 0.97], 0.5, 0.5)),
        ([-5.5, 0.0, -15.0], 3.0, glossy([0.9; 3], 0.5, 0.5)),
    ] {
        let material = expected.materials.add(material);
        expected.spheres.push(Sphere { center, radius, material });
    }
    assert_eq!(*toml(WORKSHOP).expect("valid"), expected);
}

/// No setting is its default.
const ALL_KEYS: &str = r#"
[image]
width = 320
height = 240
transfer = "srgb"

[render]
numerics = "textbook"
background = [0, 0.5, 1]
ambient = [0.1, 0.2, 0.3]
min_weight = 1e-3
max_depth = 4294967295

[camera]
position = [0, 1, 0]
look_at = [0, 0, -20]
up = [1, 1, 0]
fov = 30.5

[[lights]]
position = [0, 20, 0]
intensity = 1

[[lights]]
position = [5, 20, 0]
intensity = [0.5, 0.25, 0]

[materials.red]
color = [1.00, 0.32, 0.36]
diffuse = 0.2
specular = 0.8
shininess = 20
reflect = 0.75

[[spheres]]
center = [0, 0, -20]
radius = 4
material = "red"

[[spheres]]
center = [0, -10004, -20]
radius = 10_000
color = [0.4, 0.4, 0.4]

[[planes]]
point = [0, -4, 0]
normal = [0, 1, 0]
material = "red"
"#;

fn all_keys() -> Draft {
    let mut materials = Materials::default();
    let red = materials.add_named(
        "red",
        Material {
            color: [1.0, 0.32, 0.36],
            diffuse: 0.2,
            specular: 0.8,
            shininess: 20.0,
            reflect: Some(0.75),
        },
    );
    let ground = materials.add(Material::matt([0.4; 3]));
    Draft {
        image: Image { width: 320, height: 240, transfer: Transfer::Srgb },
        camera: Camera {
            position: [0.0, 1.0, 0.0],
            look_at: [0.0, 0.0, -20.0],
            up: [1.0, 1.0, 0.0],
            fov: 30.5,
        },
        render: Render {
            max_depth: u32::MAX,
            min_weight: 1e-3,
            background: [0.0, 0.5, 1.0],
            ambient: [0.1, 0.2, 0.3],
            numerics: Numerics::Textbook,
        },
        lights: vec![
            Light { position: [0.0, 20.0, 0.0], intensity: [1.0; 3] },
            Light { position: [5.0, 20.0, 0.0], intensity: [0.5, 0.25, 0.0] },
        ],
        materials,
        spheres: vec![
            Sphere { center: [0.0, 0.0, -20.0], radius: 4.0, material: red },
            Sphere { center: [0.0, -10_004.0, -20.0], radius: 10_000.0, material: ground },
        ],
        planes: vec![Plane { point: [0.0, -4.0, 0.0], normal: [0.0, 1.0, 0.0], material: red }],
    }
}

#[test]
fn every_key_is_read() {
    assert_eq!(*toml(ALL_KEYS).expect("valid"), all_keys());
}

#[test]
fn json_has_the_same_keys() {
    let text = r#"{
        "image": {"width": 320, "height": 240, "transfer": "srgb"},
        "camera": {"position": [0, 1, 0], "look_at": [0, 0, -20], "up": [1, 1, 0], "fov": 30.5},
        "render": {
            "numerics": "textbook", "background": [0, 0.5, 1], "ambient": [0.1, 0.2, 0.3],
            "min_weight": 1e-3, "max_depth": 4294967295
        },
        "lights": [
            {"position": [0, 20, 0], "intensity": 1},
            {"position": [5, 20, 0], "intensity": [0.5, 0.25, 0]}
        ],
        "materials": {"red": {
            "color": [1.00, 0.32, 0.36], "diffuse": 0.2, "specular": 0.8, "shininess": 20,
            "reflect": 0.75
        }},
        "spheres": [
            {"center": [0, 0, -20], "radius": 4, "material": "red"},
            {"center": [0, -10004, -20], "radius": 1e4, "color": [0.4, 0.4, 0.4]}
        ],
        "planes": [{"point": [0, -4, 0], "normal": [0, 1, 0], "material": "red"}]
    }"#;
    assert_eq!(*json(text).expect("valid"), all_keys());
}

#[test]
fn integers_are_numbers_and_may_be_long() {
    let point = |text: &str| toml(&format!("[camera]\nlook_at = [{text}, 0, -1]"));
    for (text, value) in [
        ("4", 4.0),
        ("+4", 4.0),
        ("-0", 0.0),
        ("-0.0", -0.0),
        ("0x1F", 31.0),
        ("0o17", 15.0),
        ("0b11", 3.0),
        ("1_000", 1000.0),
        ("999999999999999", 999_999_999_999_999.0),
        ("1e-320", 1e-320),
    ] {
        let read = point(text).unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(read.camera.look_at[0].to_bits(), f64::to_bits(value), "{text}");
    }
    // Longer than any integer type, and still a number.
    let light = toml("[render]\nambient = 100000000000000000000000000000");
    assert_eq!(light.expect("valid").render.ambient, [1e29; 3]);
    let light = json(r#"{"render": {"ambient": 100000000000000000000000000000}}"#);
    assert_eq!(light.expect("valid").render.ambient, [1e29; 3]);
    let light = json(r#"{"render": {"ambient": 18446744073709551615}}"#);
    assert_eq!(light.expect("valid").render.ambient, [18_446_744_073_709_551_615.0; 3]);
}

#[test]
fn a_byte_order_mark_is_skipped() {
    let marked = |text: &str| format!("\u{feff}{text}").into_bytes();
    let (toml, json) = (marked("[image]\nwidth = 9"), marked(r#" {"image": {"width": 9}}"#));
    for (text, format) in [(toml, SceneFormat::Toml), (json, SceneFormat::Json)] {
        assert_eq!(SceneFormat::of_text(&text), format);
        let document = Document::parse("marked", &text, format).expect("legal");
        assert_eq!(document.draft().image.width, 9);
    }
}

#[test]
fn formats_by_name_and_by_text() {
    for (name, format) in [
        ("a.json", SceneFormat::Json),
        ("a.JSON", SceneFormat::Json),
        ("a.toml", SceneFormat::Toml),
        ("json", SceneFormat::Toml),
        ("a.json.txt", SceneFormat::Toml),
    ] {
        assert_eq!(SceneFormat::of_path(Path::new(name)), format, "{name}");
    }
    for (text, format) in [
        ("{}", SceneFormat::Json),
        (" \r\n\t{", SceneFormat::Json),
        ("", SceneFormat::Toml),
        ("a = {}", SceneFormat::Toml),
        ("[", SceneFormat::Toml),
    ] {
        assert_eq!(SceneFormat::of_text(text.as_bytes()), format, "{text:?}");
    }
}

#[test]
fn a_scene_gives_its_draft_back() {
    let scene = Scene::new(all_keys()).expect("valid");
    assert_eq!(scene.into_draft(), all_keys());
}
