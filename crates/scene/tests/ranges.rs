//! Every range, at its ends and just past them.

use catoptric_scene::{
    Camera, Draft, Image, Light, MOST_MATERIALS, Material, Materials, Plane, Scene, Sphere,
};

/// A number of a draft.
type Number = fn(&mut Draft) -> &mut f64;

/// A scene with one of everything.
fn draft() -> Draft {
    let made = Material { specular: 0.5, reflect: Some(0.5), ..Material::matt([0.5; 3]) };
    let mut draft = Draft::default();
    draft.lights.push(Light { position: [0.0, 20.0, 0.0], intensity: [1.0; 3] });
    let material = draft.materials.add(made);
    draft.spheres.push(Sphere { center: [0.0, 0.0, -20.0], radius: 4.0, material });
    let material = draft.materials.add(made);
    draft.planes.push(Plane { point: [0.0; 3], normal: [0.0, 1.0, 0.0], material });
    draft
}

fn refused(draft: Draft) -> Option<(String, String)> {
    let error = Scene::new(draft).err()?;
    Some((error.key().expect("a range is a key's"), error.to_string()))
}

/// Key, how to reach it, what is allowed at the ends, what is not, and part of the message.
type Range<'a> = (&'a str, Number, [f64; 2], [f64; 2], &'a str);

const RANGES: &[Range<'_>] = &[
    ("camera.position[0]", |d| &mut d.camera.position[0], [-1e15, 1e15], OUT, "1e15"),
    ("camera.look_at[0]", |d| &mut d.camera.look_at[0], [-1e15, 1e15], OUT, "1e15"),
    ("camera.up[0]", |d| &mut d.camera.up[0], [f64::MIN, f64::MAX], INFINITE, "finite"),
    (
        "camera.fov",
        |d| &mut d.camera.fov,
        [1e-35, 180.0_f64.next_down()],
        [0.0, 180.0],
        "0 and 180",
    ),
    ("render.min_weight", |d| &mut d.render.min_weight, AMOUNT, TOO_MUCH, "f32"),
    ("render.background[2]", |d| &mut d.render.background[2], [0.0, 1e20], BRIGHT, "1e20"),
    ("render.ambient[0]", |d| &mut d.render.ambient[0], [0.0, 1e20], TOO_MUCH, "f32"),
    ("lights[0].position[2]", |d| &mut d.lights[0].position[2], [-1e15, 1e15], OUT, "1e15"),
    ("lights[0].intensity[1]", |d| &mut d.lights[0].intensity[1], [0.0, 9e19], TOO_MUCH, "f32"),
    ("spheres[0].center[0]", |d| &mut d.spheres[0].center[0], [-1e15, 1e15], OUT, "1e15"),
    (
        "spheres[0].radius",
        |d| &mut d.spheres[0].radius,
        [1e-12, 1e12],
        [1e-12_f64.next_down(), 1e12_f64.next_up()],
        "from 1e-12 to 1e12",
    ),
    (
        "spheres[0].color[0]",
        |d| &mut d.materials[d.spheres[0].material].color[0],
        [0.0, 9e19],
        TOO_MUCH,
        "f32",
    ),
    (
        "spheres[0].diffuse",
        |d| &mut d.materials[d.spheres[0].material].diffuse,
        [0.0, 1e20],
        TOO_MUCH,
        "f32",
    ),
    (
        "spheres[0].specular",
        |d| &mut d.materials[d.spheres[0].material].specular,
        [0.0, 9e19],
        TOO_MUCH,
        "f32",
    ),
    (
        "spheres[0].shininess",
        |d| &mut d.materials[d.spheres[0].material].shininess,
        AMOUNT,
        TOO_MUCH,
        "f32",
    ),
    ("planes[0].point[0]", |d| &mut d.planes[0].point[0], [-1e15, 1e15], OUT, "1e15"),
    ("planes[0].normal[0]", |d| &mut d.planes[0].normal[0], [-1e300, f64::MAX], INFINITE, "finite"),
    (
        "planes[0].diffuse",
        |d| &mut d.materials[d.planes[0].material].diffuse,
        [0.0, 1e20],
        TOO_MUCH,
        "f32",
    ),
];

const OUT: [f64; 2] = [(-1e15_f64).next_down(), 1e15_f64.next_up()];
const INFINITE: [f64; 2] = [f64::NEG_INFINITY, f64::INFINITY];
const AMOUNT: [f64; 2] = [0.0, f32::MAX as f64];
const TOO_MUCH: [f64; 2] = [-1e-300, 3.4028235e38];
const BRIGHT: [f64; 2] = [-1e-300, 1e20_f64.next_up()];

#[test]
fn ranges_include_their_ends_and_nothing_more() {
    for (key, number, allowed, not_allowed, text) in RANGES {
        for value in allowed {
            let mut draft = draft();
            *number(&mut draft) = *value;
            assert_eq!(refused(draft), None, "{key} = {value:e}");
        }
        for value in not_allowed.iter().chain(&[f64::NAN, f64::INFINITY, f64::NEG_INFINITY]) {
            let mut draft = draft();
            *number(&mut draft) = *value;
            let (found, message) = refused(draft).expect("not allowed");
            assert_eq!(found, *key, "{value:e}: {message}");
            assert!(message.starts_with(&format!("{key}: found ")), "{message}");
            assert!(message.contains(text), "{message}");
        }
    }
}

#[test]
fn sizes_are_1_to_65535() {
    for (width, height, key) in [
        (1, 65_535, None),
        (65_535, 1, None),
        (0, 1, Some("image.width")),
        (65_536, 1, Some("image.width")),
        (1, 0, Some("image.height")),
        (1, u32::MAX, Some("image.height")),
    ] {
        let image = Image { width, height, ..Image::default() };
        let found = refused(Draft { image, ..draft() });
        assert_eq!(found.as_ref().map(|(key, _)| key.as_str()), key, "{width}x{height}");
        assert!(found.is_none_or(|(_, message)| message.contains("1 to 65535")));
    }
}

#[test]
fn mirrors_send_back_at_most_all() {
    let with = |specular, reflect| {
        let mut draft = draft();
        let material = Material { specular, reflect, ..Material::matt([0.5; 3]) };
        draft.materials[draft.spheres[0].material] = material;
        refused(draft)
    };
    for (specular, reflect) in [(0.0, None), (1.0, None), (9.0, Some(0.0)), (9.0, Some(1.0))] {
        assert_eq!(with(specular, reflect), None);
    }
    let (key, message) = with(1.0_f64.next_up(), None).expect("a mirror that gains light");
    assert_eq!(key, "spheres[0].specular");
    assert!(message.contains("where `reflect` is stated"), "{message}");
    for reflect in [-0.1, 1.0_f64.next_up(), f64::NAN] {
        let (key, message) = with(0.5, Some(reflect)).expect("outside [0, 1]");
        assert_eq!(key, "spheres[0].reflect");
        assert!(message.contains("from 0 to 1"), "{message}");
    }
}

#[test]
fn light_sent_back_stays_within_f32() {
    let with = |ambient: f64, intensity: f64, material: Material| {
        let light = Light { position: [0.0, 20.0, 0.0], intensity: [intensity; 3] };
        let mut draft = draft();
        draft.render.ambient = [ambient; 3];
        draft.lights = vec![light; 4];
        draft.planes.clear();
        draft.materials = Materials::default();
        draft.spheres[0].material = draft.materials.add(material);
        refused(draft)
    };
    let matt = |color| Material::matt([0.0, color, 0.0]);
    assert_eq!(with(1e10, 0.0, matt(1e10)), None);
    assert_eq!(with(0.0, 0.2e10, matt(1e10)), None);
    assert_eq!(with(0.0, 0.0, matt(1e20)), None);
    let bright = Material { diffuse: 1e11, ..matt(1e11) };
    let glossy = Material { specular: 1e11, reflect: Some(0.0), ..matt(0.0) };
    for (what, refused) in [
        ("ambient", with(1e10, 0.0, matt(1.1e10))),
        ("the sum of lights", with(0.0, 1e10, matt(1e10))),
        ("the highlight", with(0.0, 1e10, glossy)),
        ("the factor, without any light", with(0.0, 0.0, bright)),
    ] {
        let (key, message) = refused.unwrap_or_else(|| panic!("{what} overflows"));
        assert_eq!(key, "spheres[0].color", "{what}");
        assert!(message.contains("overflows f32; in channel"), "{message}");
    }
}

fn camera(camera: Camera) -> Option<(String, String)> {
    refused(Draft { camera, ..draft() })
}

#[test]
fn the_camera_looks_at_another_point() {
    for at in [[0.0; 3], [1e15, -1e15, 3.0], [-0.0, 0.0, 0.0]] {
        let (key, message) =
            camera(Camera { position: at, look_at: at, ..Camera::default() }).expect("no view");
        assert_eq!(key, "camera.look_at");
        assert!(message.contains("a point apart from"), "{message}");
    }
    // As near as f64 can state, and as far as the format allows.
    let near = Camera { look_at: [0.0, 0.0, -f64::from_bits(1)], ..Camera::default() };
    let far = Camera { position: [1e15; 3], look_at: [-1e15; 3], ..Camera::default() };
    assert_eq!(camera(near), None);
    assert_eq!(camera(far), None);
}

#[test]
fn up_is_not_along_the_view_whatever_its_length() {
    let up = |up| camera(Camera { up, ..Camera::default() });
    for length in [f64::from_bits(1), 1e-200, 1.0, 1e200, f64::MAX] {
        assert_eq!(up([0.0, length, 0.0]), None);
        for along in [[0.0, 0.0, length], [0.0, 0.0, -length]] {
            let (key, message) = up(along).expect("along the view");
            assert_eq!(key, "camera.up");
            assert!(message.contains("not parallel to the view"), "{message}");
        }
    }
    assert!(up([0.0, 0.9e-8, -1.0]).is_some());
    assert_eq!(up([0.0, 1.1e-8, -1.0]), None);
    let (key, message) = up([0.0, -0.0, 0.0]).expect("zero");
    assert_eq!(key, "camera.up");
    assert!(message.contains("not zero"), "{message}");
}

#[test]
fn normals_have_any_length_but_zero() {
    let normal = |normal| {
        let plane = Plane { normal, ..draft().planes[0] };
        refused(Draft { planes: vec![plane], ..draft() })
    };
    for length in [f64::from_bits(1), 1e-200, 1e200, f64::MAX] {
        assert_eq!(normal([length, -length, 0.0]), None);
    }
    let (key, message) = normal([0.0; 3]).expect("zero");
    assert_eq!(key, "planes[0].normal");
    assert!(message.contains("not zero"), "{message}");
}

#[test]
fn fields_of_view_that_f32_cannot_hold_are_refused() {
    let with = |fov, width, height| {
        let image = Image { width, height, ..Image::default() };
        refused(Draft { image, camera: Camera { fov, ..Camera::default() }, ..draft() })
    };
    assert_eq!(with(1e-35, 640, 480), None);
    assert_eq!(with(180.0_f64.next_down(), 65_535, 1), None);
    for refused in [with(1e-37, 640, 480), with(1e-34, 1, 65_535)] {
        let (key, message) = refused.expect("too narrow");
        assert_eq!(key, "camera.fov");
        assert!(message.contains("f32 can hold tan(fov/2)"), "{message}");
    }
}

#[test]
fn the_first_wrong_key_in_the_order_of_the_format_is_named() {
    let mut draft = draft();
    draft.planes[0].normal = [0.0; 3];
    assert_eq!(refused(draft.clone()).expect("wrong").0, "planes[0].normal");
    draft.materials[draft.spheres[0].material].color[1] = -1.0;
    assert_eq!(refused(draft.clone()).expect("wrong").0, "spheres[0].color[1]");
    draft.lights[0].intensity[0] = f64::NAN;
    assert_eq!(refused(draft.clone()).expect("wrong").0, "lights[0].intensity[0]");
    draft.image.height = 0;
    assert_eq!(refused(draft).expect("wrong").0, "image.height");
}

#[test]
fn so_many_materials_and_no_more() {
    let mut draft = draft();
    let matt = Material::matt([0.5; 3]);
    (draft.materials.len()..MOST_MATERIALS).for_each(|_| _ = draft.materials.add(matt));
    assert_eq!(refused(draft.clone()), None);
    draft.materials.add(matt);
    let (key, message) = refused(draft).expect("one too many");
    assert_eq!(key, "materials");
    assert!(message.contains("4000001 materials"), "{message}");
    assert!(message.contains("at most 4000000; bodies that name the same"), "{message}");
}

/// Their number is not that of materials.
#[test]
fn more_bodies_than_materials_are_a_scene() {
    let mut draft = draft();
    draft.spheres = vec![draft.spheres[0]; MOST_MATERIALS + 1];
    assert_eq!(refused(draft), None);
}

#[test]
fn a_material_of_another_draft_is_refused() {
    let mut other = Materials::default();
    let ids = [0; 3].map(|_| other.add(Material::matt([0.5; 3])));
    let refused = |change: &dyn Fn(&mut Draft)| {
        let mut draft = draft();
        change(&mut draft);
        refused(draft)
    };
    assert_eq!(refused(&|d| d.spheres[0].material = ids[1]), None);
    let (key, message) = refused(&|d| d.spheres[0].material = ids[2]).expect("not there");
    assert_eq!(key, "spheres[0].material");
    assert!(message.contains("the id of one of this draft's 2 materials"), "{message}");
    let (key, _) = refused(&|d| d.planes[0].material = ids[2]).expect("not there");
    assert_eq!(key, "planes[0].material");
}

/// A material is named in a message as a file would name it.
#[test]
fn materials_are_named_by_name_or_by_their_first_body() {
    let wrong = Material { diffuse: -1.0, ..Material::matt([0.5; 3]) };
    let key = |change: &dyn Fn(&mut Draft)| {
        let mut draft = draft();
        change(&mut draft);
        refused(draft).expect("wrong").0
    };
    let second = |d: &mut Draft, id| d.spheres.push(Sphere { material: id, ..d.spheres[0] });
    let unnamed = |d: &mut Draft| {
        let id = d.materials.add(wrong);
        second(d, id);
        second(d, id);
    };
    assert_eq!(key(&unnamed), "spheres[1].diffuse");
    let named = |d: &mut Draft| {
        let id = d.materials.add_named("a b", wrong);
        second(d, id);
    };
    assert_eq!(key(&named), "materials.\"a b\".diffuse");
    assert_eq!(key(&|d| _ = d.materials.add_named("unused", wrong)), "materials.unused.diffuse");
    assert_eq!(key(&|d| _ = d.materials.add(wrong)), "materials[2].diffuse");
    let twice = |d: &mut Draft| {
        d.materials.add_named("red", Material::matt([0.5; 3]));
        d.materials.add_named("red", Material::matt([0.5; 3]));
    };
    assert_eq!(key(&twice), "materials.red");
}
