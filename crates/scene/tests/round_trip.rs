//! What is written reads back, bit by bit.

use catoptric_scene::{
    Compiled, Document, Draft, Material, MaterialId, Plane, Scene, SceneFormat, Sphere,
};
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

/// All that a draft states, with every bit: Debug writes every f64 so that it tells all bits, the
/// sign of zero included. A material that its bodies share without a name gets one in a file, and
/// materials are numbered anew, so here stand those that were named, and each body's own.
fn stated(draft: &Draft) -> String {
    let Draft { image, camera, render, lights, materials, spheres, planes } = draft;
    let mut shared = vec![0; materials.len()];
    draft.bodies().for_each(|body| shared[body.material().index()] += 1);
    let made = |id: MaterialId| {
        let own = shared[id.index()] == 1;
        let name = if own { materials.name(id) } else { materials.name(id).or(Some("m?")) };
        // A free name is as good as another.
        (name.map(|name| if is_free(name) { "m?" } else { name }), materials[id])
    };
    let named = materials.named().filter(|(name, _)| !is_free(name)).collect::<Vec<_>>();
    let spheres = spheres.iter().map(|s| (s.center, s.radius, made(s.material)));
    let planes = planes.iter().map(|p| (p.point, p.normal, made(p.material)));
    let (spheres, planes) = (spheres.collect::<Vec<_>>(), planes.collect::<Vec<_>>());
    format!("{:?}", (image, camera, render, lights, named, spheres, planes))
}

/// Whether a name is of those that writing gives.
fn is_free(name: &str) -> bool {
    name.strip_prefix('m').is_some_and(|number| number.parse::<u32>().is_ok())
}

proptest! {
    #[test]
    fn both_formats_read_back_to_the_same_bits(draft in draft()) {
        let scene = Scene::new(draft).expect("generated valid");
        for format in [SceneFormat::Toml, SceneFormat::Json] {
            let again = read_back(&scene, format);
            prop_assert_eq!(stated(&scene), stated(&again));
            // What was read is written as it was, and is then the same to its last number.
            prop_assert_eq!(scene.to_text(format), again.to_text(format));
            let third = read_back(&again, format);
            prop_assert_eq!(format!("{again:?}"), format!("{third:?}"));
        }
    }
}

/// Names in the order of the file, two of them of one material and one of no body; inline
/// materials that are equal; and a name that is taken when another is looked for.
#[test]
fn names_are_kept_and_inline_stays_inline() {
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

[materials.red]
color = [1, 0, 0]

[materials.\"a \\\"b\\\" \\u000Aü\"]
color = [1, 0, 0]

[materials.m0]
color = [0, 1, 0]

[materials.blue]
color = [0, 0, 1]

[[spheres]]
center = [0, 0, -20]
radius = 4
material = \"a \\\"b\\\" \\u000Aü\"

[[spheres]]
center = [1, 0, -20]
radius = 4
material = \"red\"

[[spheres]]
center = [2, 0, -20]
radius = 4
color = [0.5, 0.5, 0.5]

[[spheres]]
center = [3, 0, -20]
radius = 4
color = [0.5, 0.5, 0.5]

[[planes]]
point = [0, -4, 0]
normal = [0, 1, 0]
material = \"m0\"
";
    let read = |text: &str, format| {
        let document = Document::parse("a", text.as_bytes(), format);
        document.and_then(Document::into_scene).expect("legal")
    };
    let scene = read(text, SceneFormat::Toml);
    assert_eq!(scene.to_text(SceneFormat::Toml), text);
    let json = scene.to_text(SceneFormat::Json);
    assert_eq!(read(&json, SceneFormat::Json).to_text(SceneFormat::Toml), text);
    assert_eq!(read(&json, SceneFormat::Json), scene);
    // The two names are one material to the engines, and so are the two inline ones.
    assert_eq!((scene.materials.len(), Compiled::new(&scene).materials.len()), (6, 3));

    let mut draft = scene.into_draft();
    let material = draft.spheres[3].material;
    draft.spheres[2].material = material;
    let text = Scene::new(draft).expect("valid").to_text(SceneFormat::Toml);
    assert_eq!(text.matches("material = \"m1\"").count(), 2, "{text}");
    assert!(text.contains("[materials.m1]\ncolor = [0.5, 0.5, 0.5]\n\n[[spheres]]"), "{text}");
}

/// A body may name a material before the file states it, in any order of the keys.
#[test]
fn materials_may_come_last() {
    let text = r#"{"planes": [{"point": [0, 0, 0], "normal": [0, 1, 0], "color": [1, 1, 1]}],
        "spheres": [{"center": [0, 0, -9], "radius": 1, "material": "b"}],
        "materials": {"a": {"color": [0, 0, 1]}, "b": {"color": [1, 0, 0]}}}"#;
    let document = Document::parse("a", text.as_bytes(), SceneFormat::Json);
    let scene = document.and_then(Document::into_scene).expect("legal");
    assert_eq!(scene.materials[scene.spheres[0].material], Material::matt([1.0, 0.0, 0.0]));
    assert_eq!(scene.materials.named().map(|(name, _)| name).collect::<Vec<_>>(), ["b", "a"]);
    assert_eq!(stated(&read_back(&scene, SceneFormat::Toml)), stated(&scene));
}

/// Two spheres and a plane of one material, one sphere of its own.
fn sharing() -> Scene {
    let mut draft = Draft::default();
    let shared = Material { specular: 0.5, ..Material::matt([1.0, 0.25, 0.0]) };
    let shared = draft.materials.add(shared);
    let own = Material { reflect: Some(0.0), ..Material::matt([1e-7, 1e20, -0.0]) };
    let own = draft.materials.add(own);
    let sphere = |x, material| Sphere { center: [x, 0.0, -20.0], radius: 4.0, material };
    draft.spheres = vec![sphere(0.0, shared), sphere(5.5, own), sphere(1.0, shared)];
    draft.planes =
        vec![Plane { point: [0.0, -4.0, 0.0], normal: [0.0, 1.0, 0.0], material: shared }];
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
