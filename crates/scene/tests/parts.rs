//! Long TOML texts, which are read in parts: the same scene and the same errors as in one piece.

use std::fmt::Write;

use catoptric_scene::{Document, Draft, Material, Scene, SceneError, SceneFormat, Sphere};
use proptest::prelude::*;
use proptest::sample::Index;
use toml::de::DeTable;

use crate::toml;

const MANY: usize = 2_000;

fn read(text: &str) -> Result<Draft, SceneError> {
    Document::parse("a.toml", text.as_bytes(), SceneFormat::Toml)
        .map(|document| document.draft().clone())
}

/// Spheres one after another, each with its own material by name, and a light after each hundred.
fn tables() -> String {
    let mut text = String::from("[image]\nwidth = 9\n\n");
    for i in 0..MANY {
        if i % 100 == 0 {
            write!(text, "[[lights]]\nposition = [0, {i}, 0]\n").expect("a string takes all");
        }
        write!(
            text,
            "[[spheres]] # {i}\ncenter = [0, 0, -{i}.5]\nradius = 1\nmaterial = \"m{i}\"\n\
            [materials.m{i}]\ncolor = [0, 0, {i}]\n",
        )
        .expect("a string takes all");
        if i % 70 == 0 {
            text += "[[planes]]\npoint = [0, 0, 0]\nnormal = [0, 1, 0]\nmaterial = 'm7'\n";
        }
    }
    text + "[camera]\nfov = 40\n"
}

/// The same spheres in a list, and the materials in a table.
fn inline() -> String {
    let mut text = String::from("spheres = [ # all of them\n");
    for i in 0..MANY {
        writeln!(text, "  {{ center = [0, 0, -{i}.5], radius = 1, material = \"m{i}\" }},")
            .expect("a string takes all");
    }
    text += "]\n[materials]\n";
    for i in 0..MANY {
        writeln!(text, "m{i}.color = [0, 0, {i}]").expect("a string takes all");
    }
    text
}

/// Centre, radius and material of each sphere.
fn spheres(draft: &Draft) -> Vec<([f64; 3], f64, Material)> {
    let sphere = |s: &Sphere| (s.center, s.radius, draft.materials[s.material]);
    draft.spheres.iter().map(sphere).collect()
}

fn expected() -> Vec<([f64; 3], f64, Material)> {
    let sphere =
        |i: usize| ([0.0, 0.0, -(i as f64) - 0.5], 1.0, Material::matt([0.0, 0.0, i as f64]));
    (0..MANY).map(sphere).collect()
}

#[test]
fn all_parts_are_read_in_order() {
    let draft = read(&tables()).expect("legal");
    assert_eq!((draft.image.width, draft.camera.fov), (9, 40.0));
    assert_eq!(spheres(&draft), expected());
    let lights: Vec<f64> = draft.lights.iter().map(|light| light.position[1]).collect();
    assert_eq!(lights, (0..MANY).step_by(100).map(|i| i as f64).collect::<Vec<_>>());
    assert_eq!(draft.planes.len(), MANY.div_ceil(70));
    assert!(
        draft.planes.iter().all(|plane| draft.materials[plane.material].color == [0.0, 0.0, 7.0])
    );
    assert_eq!(spheres(&read(&inline()).expect("legal")), expected());
}

/// A key in quotes is the same key.
#[test]
fn headers_in_quotes_keep_their_order() {
    let quoted = tables().replace("[[spheres]] # 5\n", "[[ \"sph\\u0065res\" ]] # 5\n");
    let quoted = quoted.replace("[[spheres]] # 1500\n", "[[ 'spheres' ]] # 1500\n");
    let quoted = quoted.replace("[materials.m900]", "[\"materials\" . 'm900']");
    assert_eq!(spheres(&read(&quoted).expect("legal")), expected());
}

/// The place of `wrong` in a text, the first from a byte on.
fn place(text: &str, from: usize, wrong: &str) -> (usize, usize) {
    let at = from + text[from..].find(wrong).expect("it is there");
    let line_start = text[..at].rfind('\n').map_or(0, |newline| newline + 1);
    (text[..at].matches('\n').count() + 1, at - line_start + 1)
}

/// One change to the long scene, the words of the message, and what stands at its place.
type Change<'a> = (&'a str, &'a str, &'a str, &'a str);

#[test]
fn faults_in_late_parts_have_their_place() {
    let s1500 = "center = [0, 0, -1500.5]\nradius = 1";
    let of_tables: &[Change<'_>] = &[
        (s1500, "center = [0, 0, -1500.5]\nradius = -4", "spheres[1500].radius: found -4", "-4"),
        (
            s1500,
            "center = [0, 0, -1500.5]\nraduis = 1",
            "spheres[1500].raduis: found an unknown key",
            "raduis",
        ),
        (s1500, "center = [0, 0, 1e16]\nradius = 1", "spheres[1500].center[2]: found 1e16", "1e16"),
        (
            s1500,
            "center = [0, \"x\", 0]\nradius = 1",
            "spheres[1500].center[1]: found \"x\"",
            "\"x\"",
        ),
        (
            s1500,
            "center = [0, 0, -1500.5]",
            "spheres[1500].radius: found nothing",
            "[[spheres]] # 1500",
        ),
        (
            "\"m1500\"",
            "\"m15000\"",
            "spheres[1500].material: found \"m15000\"; allowed: the name of one of the materials: m0, m1, m10",
            "\"m15000\"",
        ),
        ("color = [0, 0, 1500]", "color = [0, 0, -2]", "materials.m1500.color[2]: found -2", "-2"),
        (
            "color = [0, 0, 1500]",
            "colour = 1",
            "materials.m1500.colour: found an unknown key",
            "colour",
        ),
        ("[materials.m1500]", "[materials.m3]", "duplicate key", "m3]\ncolor = [0, 0, 1500]"),
        ("[materials.m1500]", "[materials.m1499]", "duplicate key", "m1499]\ncolor = [0, 0, 1500]"),
        ("[materials.m1500]", "[image]", "duplicate key", "image]\ncolor"),
        ("[materials.m1500]", "[spheres]", "duplicate key", "spheres]\ncolor"),
        (
            "[materials.m1500]",
            "[materials.m1499.x]",
            "materials.m1499.x: found an unknown key",
            "x]\ncolor",
        ),
        ("[materials.m1500]", "[spheres.x]", "spheres[1500].x: found an unknown key", "x]\ncolor"),
        (s1500, "center = [0, 0 -1500.5]\nradius = 1", "", "-1500.5]"),
        (s1500, "center = [0, 0, -1500.5]\nradius = = 1", "", "= = 1"),
        ("position = [0, 1900, 0]", "position = [0, 1e16, 0]", "lights[19].position[1]", "1e16"),
        ("[image]\n", "spheres = []\n[image]\n", "duplicate key", "spheres]] # 0"),
        ("[image]\n", "materials = {}\n[image]\n", "", "materials.m0]"),
        ("fov = 40", "fov = 400", "camera.fov: found 400", "400"),
        ("fov = 40", "gravity = 4", "camera.gravity: found an unknown key", "gravity"),
    ];
    let of_inline: &[Change<'_>] = &[
        ("-1500.5], radius = 1", "-1500.5], radius = -4", "spheres[1500].radius: found -4", "-4"),
        (
            "-1500.5], radius = 1",
            "-1500.5], raduis = 1",
            "spheres[1500].raduis: found an unknown",
            "raduis",
        ),
        ("-1500.5], radius = 1", "-1500.5], radius = 1 2", "", "2, material"),
        ("-1500.5], radius = 1", "-1500.5, radius = 1", "", "= 1, material = \"m1500\""),
        (
            "spheres = [",
            "[[spheres]]\ncenter = [",
            "spheres[0].center: found an array of 2000",
            "[ # all",
        ),
        ("\"m1500\"", "5", "spheres[1500].material: found 5", "5 }"),
    ];
    let long = [(tables(), of_tables), (inline(), of_inline)];
    for (text, (from, to, words, at)) in
        long.iter().flat_map(|(text, c)| c.iter().map(move |c| (text, c)))
    {
        let changed = text.replacen(from, to, 1);
        assert_ne!(*text, changed, "{from}");
        let error = toml(&changed).map(|_| ()).expect_err(to);
        let message = error.to_string();
        assert!(message.contains(words), "{message}");
        let near = text.find(from).expect("it is there").saturating_sub(40);
        let expected = place(&changed, near, at);
        let found = error.position().expect("a place");
        assert_eq!(found.0, expected.0, "{to}: {message}");
        // A long line is cut at its ends.
        let line = changed.lines().nth(found.0 - 1).expect("a line");
        let numbered = format!("{} | ", found.0);
        let shown = message.lines().find_map(|l| l.split_once(&numbered)).expect(&message).1;
        let shown = shown.trim_matches(['.', ' ']);
        assert!(!shown.is_empty() && line.contains(shown), "{message}");
        if !words.is_empty() {
            assert_eq!(found.1, expected.1, "{to}: {message}");
        }
    }
}

/// A list without an end is told at the end of the text, wherever its parts are.
#[test]
fn a_long_list_without_its_end_is_told_at_the_end() {
    let text = inline();
    let text = &text[..text.find("]\n[materials]").expect("its end")];
    let whole = DeTable::parse(text).expect_err("no end").span().expect("a place");
    let error = read(text).expect_err("no end");
    assert_eq!(error.position().expect("a place").0, text[..whole.start].matches('\n').count() + 1);
}

proptest! {
    #![proptest_config(ProptestConfig::with_cases(48))]

    /// Broken syntax is what the parser finds in the whole text, at a place that it names.
    #[test]
    fn parts_are_as_right_or_wrong_as_the_whole(
        list in any::<bool>(),
        at in any::<Index>(),
        deleted in 0..3_usize,
        inserted in "[\\[\\]{}\"'=.,#a\n 1]{0,3}",
    ) {
        let mut text = if list { inline() } else { tables() };
        let start = at.index(text.len() - deleted);
        text.replace_range(start..start + deleted, &inserted);
        let (_, errors) = DeTable::parse_recoverable(&text);
        let found = read(&text).err().filter(|error| error.key().is_none());
        prop_assert_eq!(found.is_some(), !errors.is_empty(), "{:?} {:?}", found, errors.first());
        if let Some(found) = found {
            let line = |byte: usize| text[..byte].matches('\n').count() + 1;
            let lines: Vec<_> =
                errors.iter().filter_map(|error| Some(line(error.span()?.start))).collect();
            let at = found.position().expect("a place").0;
            prop_assert!(lines.contains(&at), "{found}\n{at} is not in {lines:?}");
        }
    }
}

/// What was read within a limit, and what was not.
#[test]
fn a_limit_on_memory_is_kept() {
    let scene = Scene::new(read(&tables()).expect("legal")).expect("valid");
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        let text = scene.to_text(format).into_bytes();
        let read = |limit| Document::parse_within("a", text.clone(), format, limit);
        // Their spheres alone are more.
        let error = read(MANY as u64 * size_of::<Sphere>() as u64).expect_err("too small");
        assert!(error.is_over_limit(), "{error}");
        assert!(error.to_string().contains("more than the 80000 bytes of memory"), "{error}");
        let read = read(16 << 20).expect("large enough");
        assert_eq!(read.draft(), &*scene);
    }
}
