//! Files that are no scenes, and scenes whose keys do not fit together.

use std::fs::{self, File, Permissions};
use std::os::unix::fs::PermissionsExt;

use crate::program::{Folder, JSON_SCENE, SCENE};
use crate::refusals::refused;

fn utf_16(text: &str) -> Vec<u8> {
    format!("\u{feff}{text}").encode_utf16().flat_map(u16::to_le_bytes).collect()
}

#[test]
fn files_that_are_no_scenes_are_3() {
    let folder = Folder::new();
    let picture = b"\x89PNG\r\n\x1a\n\0\0\0\rIHDR".to_vec();
    let cases: &[(&str, Vec<u8>, &[&str])] = &[
        ("empty.toml", Vec::new(), &["the file is empty", "[image]"]),
        ("empty.json", Vec::new(), &["the file is empty"]),
        ("blank.toml", b" \n\t\r\n".to_vec(), &["the file is empty"]),
        ("picture.toml", picture.clone(), &["byte 0", "UTF-8"]),
        ("picture.json", picture, &["byte 0", "UTF-8"]),
        ("zeros.toml", vec![0; 4096], &["byte 0", "UTF-8"]),
        ("zeros.json", vec![0; 4096], &["byte 0", "UTF-8"]),
        ("wide.toml", utf_16(SCENE), &["UTF-16", "save it as UTF-8"]),
        ("wide.json", utf_16(JSON_SCENE), &["UTF-16", "save it as UTF-8"]),
        ("words.toml", b"Hello, world\n".to_vec(), &["words.toml:1:", "Hello, world"]),
        ("words.json", b"Hello, world\n".to_vec(), &["at line 1 column 1", "starts with {"]),
        ("page.toml", b"<!doctype html>\n".to_vec(), &["page.toml:1:"]),
        ("named.json", SCENE.into(), &["a scene in JSON starts with {", ".json"]),
        ("named.toml", JSON_SCENE.into(), &["looks like JSON", ".json"]),
        ("list.json", b"[]".to_vec(), &["top level: found []", "image, camera"]),
        ("deep.json", vec![b'['; 1 << 20], &["deep.json"]),
        ("deep.toml", [b"a = ".to_vec(), vec![b'['; 1 << 20]].concat(), &["deep.toml"]),
    ];
    for (name, bytes, parts) in cases {
        folder.write(name, bytes);
        refused(&folder, &format!("render {name} -o out.png"), 3, &[&[*name], *parts].concat());
        refused(&folder, &format!("render {name}"), 3, parts);
    }
}

#[test]
fn a_scene_cut_short_is_3_or_the_scene_that_it_states() {
    let folder = Folder::new();
    for end in (0..JSON_SCENE.trim_end().len()).step_by(11) {
        folder.write("cut.json", &JSON_SCENE[..end]);
        refused(&folder, "render cut.json -o out.png", 3, &["cut.json"]);
    }
    // A TOML text may end after any line.
    for end in (0..SCENE.len()).step_by(31) {
        folder.write("cut.toml", &SCENE[..end]);
        let before = folder.contents();
        let ran = folder.run("render cut.toml -o out.png");
        match ran.code {
            Some(0) => fs::remove_file(folder.path("out.png")).expect("a picture"),
            Some(3) => assert!(ran.stderr.contains("cut.toml: "), "{}", ran.stderr),
            _ => panic!("{end}: {:?} {}", ran.code, ran.stderr),
        }
        assert_eq!(folder.contents(), before);
    }
}

#[test]
fn a_scene_that_may_not_be_read_is_3() {
    let folder = Folder::new();
    let secret = folder.path("secret.toml");
    folder.write("secret.toml", SCENE);
    fs::set_permissions(&secret, Permissions::from_mode(0o000)).expect("permissions");
    if File::open(&secret).is_ok() {
        println!("skipped: permissions do not keep this user (root?) from reading");
        return;
    }
    let ran = folder.run("render secret.toml -o out.png");
    assert_eq!(ran.code, Some(3), "{}", ran.stderr);
    assert!(ran.stderr.contains("secret.toml cannot be read: Permission denied"), "{}", ran.stderr);
    assert!(!folder.path("out.png").exists());
}

#[test]
fn keys_that_do_not_fit_are_3() {
    let sphere = "[[spheres]]\ncenter = [0, 0, -9]\nradius = 2\n";
    let red = "[materials.red]\ncolor = [1, 0, 0]\n";
    let cases: &[(String, &[&str])] = &[
        (format!("{sphere}color = [1, 1, 1]\nmirror = 1"), &["spheres[0].mirror", "unknown key"]),
        (format!("{sphere}colour = [1, 1, 1]"), &["spheres[0].colour", "did you mean color?"]),
        ("[render]\ndepth = 3".into(), &["render.depth", "did you mean max_depth?"]),
        ("[film]\nwidth = 3".into(), &["film", "image, camera, render"]),
        (format!("{red}{sphere}material = \"rot\""), &["spheres[0].material", "\"rot\"", "red"]),
        (format!("{sphere}material = \"red\""), &["\"red\"", "and there are none"]),
        (format!("{red}{sphere}material = \"red\"\nreflect = 1"), &["both `reflect`", "either"]),
        (
            format!("{sphere}material = {{ color = [1, 0, 0] }}"),
            &["found a table", "color, diffuse, specular, shininess, reflect stand beside"],
        ),
        (sphere.into(), &["spheres[0].color", "found nothing", "or `material`"]),
        (format!("{sphere}radius = 2"), &["duplicate key"]),
        ("[image]\nwidth = 0\nheight = 0".into(), &["image.width", "found 0", "1 to 65535"]),
        ("[image]\nwidth = 65536".into(), &["image.width", "65536", "1 to 65535"]),
        ("[image]\nwidth = 64.0".into(), &["64 written with a fraction", "an integer"]),
        ("[camera]\nlook_at = [0, 0, 0]".into(), &["camera.look_at", "apart from"]),
        ("[camera]\nup = [0, 0, 1]".into(), &["camera.up", "not parallel"]),
    ];
    let folder = Folder::new();
    for (text, parts) in cases {
        folder.write("bad.toml", text);
        refused(&folder, "render bad.toml -o out.png", 3, &[&["bad.toml:"], *parts].concat());
    }
}

/// Whatever fuzzing found worth keeping ends with 0 or 3, and scenes with one picture.
#[test]
fn the_fuzzer_s_corpus_has_one_picture_or_none() {
    let corpus = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/fuzz/corpus/scene");
    let folder = Folder::new();
    let mut scenes = 0;
    for file in fs::read_dir(corpus).expect("the corpus") {
        let path = file.expect("an entry").path();
        for name in ["a.toml", "a.json"] {
            folder.write(name, fs::read(&path).expect("a file"));
            let render = format!("render {name} --width 67 --height 9 --max-depth 8");
            let ran = folder.run(&format!("{render} -o packet.pfm"));
            if ran.code != Some(0) {
                assert_eq!(ran.code, Some(3), "{}: {}", path.display(), ran.stderr);
                continue;
            }
            scenes += 1;
            folder.done(&format!("{render} -o recursive.pfm --engine recursive"));
            let compared = folder.run("compare packet.pfm recursive.pfm");
            assert_eq!(compared.code, Some(0), "{}: {}", path.display(), compared.text());
        }
    }
    assert!(scenes >= 10, "{scenes} of them are scenes");
}
