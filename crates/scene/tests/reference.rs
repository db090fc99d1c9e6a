//! The format's reference in `scenes/README.md` says what the program does: every row of its
//! tables is tried, and every key that the program knows has a row.

use std::collections::BTreeMap;

use catoptric_scene::{Document, Draft, MOST_MATERIALS, SceneFormat};

use crate::toml;

const README: &str = include_str!("../../../scenes/README.md");

/// A row of the reference.
struct Row {
    key: &'static str,
    default: &'static str,
    allowed: &'static str,
}

/// The tables of the reference by their name, in its order.
fn tables() -> Vec<(&'static str, Vec<Row>)> {
    let (_, reference) = README.split_once("\n## The format\n").expect("a reference");
    let sections = reference.split("\n### `").skip(1);
    let table = |section: &'static str| {
        let (name, text) = section.split_once('`').expect("a name");
        let rows = text.lines().filter_map(|line| {
            let cells = line.strip_prefix("| `")?.strip_suffix(" |").expect("a row's end");
            let cells: Vec<_> = cells.split(" | ").collect();
            let [key, default, allowed, meaning] = cells[..] else { panic!("cells of {line}") };
            assert!(meaning.len() > 10, "{line}");
            let key = key.strip_suffix('`').expect("a key between ` and `");
            Some(Row { key, default, allowed })
        });
        (name, rows.collect())
    };
    sections.map(table).collect()
}

/// The start of a table, and its required keys with values that go together.
fn frame(table: &str) -> (&'static str, &'static [(&'static str, &'static str)]) {
    const COLOR: (&str, &str) = ("color", "[0.5, 0.25, 1]");
    match table {
        "image" => ("[image]\n", &[]),
        "camera" => ("[camera]\n", &[]),
        "render" => ("[render]\n", &[]),
        "lights" => ("[[lights]]\n", &[("position", "[3, 8, 5]")]),
        "materials" => ("[materials.m]\n", &[COLOR]),
        "spheres" => ("[[spheres]]\n", &[("center", "[0, 0, -9]"), ("radius", "2"), COLOR]),
        "planes" => ("[[planes]]\n", &[("point", "[0, -3, 0]"), ("normal", "[0, 1, 0]"), COLOR]),
        other => panic!("a table {other}"),
    }
}

/// A scene of one table, in which one key has that value, or is left out.
fn text(table: &str, key: &str, value: Option<&str>) -> String {
    let (start, required) = frame(table);
    let others = required.iter().filter(|(other, _)| *other != key);
    let mut text = start.to_owned();
    for (key, value) in others.copied().chain(value.map(|value| (key, value))) {
        text += &format!("{key} = {value}\n");
    }
    if table == "materials" {
        text += "[[spheres]]\ncenter = [0, 0, -9]\nradius = 2\nmaterial = \"m\"\n";
    }
    text
}

/// The draft of such a scene.
fn draft(table: &str, key: &str, value: Option<&str>) -> Draft {
    let text = text(table, key, value);
    toml(&text).unwrap_or_else(|error| panic!("{error}\n{text}")).into_draft()
}

/// Why such a scene is refused: the key's path, and what is said to be allowed.
fn refusal(table: &str, key: &str, value: Option<&str>) -> (String, String) {
    refused(&text(table, key, value))
}

fn refused(text: &str) -> (String, String) {
    let error = toml(text).expect_err(text);
    let message = error.to_string();
    let (_, allowed) = message.split_once("; allowed: ").expect("what is allowed");
    let allowed = allowed.lines().next().expect("a line").to_owned();
    (error.key().expect("a key"), allowed)
}

/// The range in a cell, of one number, with texts of numbers just outside it.
fn outside(allowed: &str) -> Vec<String> {
    let written = |x: f64| format!("{x:e}");
    match allowed {
        "a finite number" => vec!["inf".to_owned(), "-inf".to_owned(), "nan".to_owned()],
        _ if allowed.contains("between 0 and 180, both excluded") => {
            vec!["0".to_owned(), "180".to_owned()]
        }
        _ => {
            let (_, ends) = allowed.split_once(" from ").expect("a range");
            let word = |text: &str| text.split([' ', ',']).next().expect("a word").to_owned();
            let (least, rest) = ends.split_once(" to ").expect("two ends");
            // The last end that is named: `specular` has a nearer one for mirrors.
            let most = rest.split_once(" up to ").map_or(rest, |(_, most)| most);
            let (least, most): (f64, f64) =
                (least.parse().expect("an end"), word(most).parse().expect("an end"));
            if allowed.starts_with("an integer") {
                return vec![format!("{}", least - 1.0), format!("{}", most + 1.0)];
            }
            // The largest of f32 has eight digits in the text; the next number of eight digits
            // is above it.
            let of_f32 = (most as f32) == f32::MAX;
            let above = if of_f32 { 3.402_823_5e38 } else { most.next_up() };
            vec![written(least.next_down()), written(above), "nan".to_owned()]
        }
    }
}

#[test]
fn every_key_has_a_row_and_every_row_a_key() {
    let tables = tables();
    let known = |text: &str| {
        let (_, allowed) = refused(text);
        allowed.split(", ").map(str::to_owned).collect::<Vec<_>>()
    };
    let names: Vec<_> = tables.iter().map(|(name, _)| *name).collect();
    assert_eq!(known("zzzzzzzz = 1"), names);
    let keys: BTreeMap<_, Vec<_>> = tables
        .iter()
        .map(|(name, rows)| (*name, rows.iter().map(|row| row.key).collect()))
        .collect();
    for name in names {
        let mut expected = keys[name].clone();
        if ["spheres", "planes"].contains(&name) {
            expected.extend(&keys["materials"]);
        }
        assert_eq!(known(&text(name, "zzzzzzzz", Some("1"))), expected, "{name}");
    }
}

#[test]
fn ranges_are_those_of_the_rows_whatever_is_wrong() {
    for (table, rows) in tables() {
        for Row { key, allowed, .. } in rows {
            let cell = || format!("{table}.{key}");
            let (_, said) = refusal(table, key, Some("true"));
            let said = said.split(", and there are none").next().expect("words");
            assert_eq!(said, allowed, "{}: another type", cell());
            if allowed.starts_with('"') {
                let (first, second) = allowed.split_once(" or ").expect("two words");
                assert_ne!(draft(table, key, Some(first)), draft(table, key, Some(second)));
                assert_eq!(refusal(table, key, Some("\"zzz\"")).1, allowed);
                continue;
            }
            if key == "material" {
                continue;
            }
            let (vector, range) = match allowed.split_once(", each ") {
                Some((_, range)) => (true, range),
                None => (false, allowed),
            };
            for number in outside(range) {
                let value = if vector { format!("[1, 2, {number}]") } else { number };
                let (path, said) = refusal(table, key, Some(&value));
                assert_eq!(said, range, "{}: {value}", cell());
                let last = path.trim_end_matches("[2]").rsplit('.').next();
                assert_eq!(last, Some(key), "{}: {value}", cell());
            }
        }
    }
}

#[test]
fn defaults_are_those_of_the_rows() {
    for (table, rows) in tables() {
        for Row { key, default, .. } in rows {
            if key == "material" {
                assert_eq!(default, "none");
                // With neither it nor a material's keys the colour is what lacks.
                let bare = text(table, "color", None);
                assert!(refused(&bare).0.ends_with("].color"), "{table}");
                continue;
            }
            if default == "required" {
                let text = text(table, key, None);
                let message = toml(&text).expect_err("a key that is missing").to_string();
                assert!(message.contains(&format!("{key}: found nothing, and it is required")));
                continue;
            }
            if default == "as `specular`" {
                continue;
            }
            let value = default.trim_matches('`');
            assert_eq!(draft(table, key, Some(value)), draft(table, key, None), "{table}.{key}");
            assert!(is_read(table, key), "{table}.{key} changes nothing");
        }
    }
}

/// Whether the key's value reaches the draft: some other value gives another draft.
fn is_read(table: &str, key: &str) -> bool {
    let others = ["0.25", "7", "[2, 3, 4]", "\"srgb\"", "\"textbook\""];
    let scenes = others.iter().filter_map(|value| toml(&text(table, key, Some(value))).ok());
    let default = draft(table, key, None);
    scenes.into_iter().any(|scene| *scene != default)
}

#[test]
fn specular_alone_makes_a_mirror() {
    let mirror = |keys: &str| {
        let text =
            format!("[[spheres]]\ncenter = [0, 0, -9]\nradius = 2\ncolor = [1, 1, 1]\n{keys}");
        let draft = toml(&text).expect("a scene");
        draft.materials[draft.spheres[0].material].mirror()
    };
    assert_eq!(mirror("specular = 0.8"), 0.8);
    assert_eq!(mirror("specular = 0.8\nreflect = 0"), 0.0);
    assert_eq!(mirror("reflect = 0.25"), 0.25);
    let reflect = tables().into_iter().find(|(name, _)| *name == "materials").expect("materials").1;
    assert_eq!(
        reflect.last().map(|row| (row.key, row.default)),
        Some(("reflect", "as `specular`"))
    );
    assert!(README.contains("**`specular` alone makes a mirror.**"));
}

#[test]
fn rules_between_keys_have_the_words_of_the_messages() {
    let readme = README.split_whitespace().collect::<Vec<_>>().join(" ");
    let material = "[[spheres]]\ncenter = [0, 0, -9]\nradius = 2\ncolor = [1e30, 1, 1]\n";
    let cases = [
        ("[camera]\nlook_at = [0, 0, 0]", "camera.look_at"),
        ("[camera]\nup = [0, 0, 0]", "camera.up"),
        ("[camera]\nup = [0, 0, 2]", "camera.up"),
        ("[camera]\nfov = 1e-37", "camera.fov"),
        (material, "spheres[0].color"),
        (
            "[[planes]]\npoint = [0, 0, 0]\nnormal = [0, 0, 0]\ncolor = [1, 1, 1]",
            "planes[0].normal",
        ),
    ];
    for (text, key) in cases {
        let (found, allowed) = refused(text);
        assert_eq!(found, key);
        let rule = allowed.split("; ").next().expect("words");
        assert!(readme.contains(rule), "{key}: {rule:?} is not in the reference");
    }
    assert!(readme.contains(&format!("at most {MOST_MATERIALS} materials.")));
}

/// JSON says the same of the same scene.
#[test]
fn json_refuses_in_the_same_words() {
    let text = r#"{"render": {"background": true}}"#;
    let error = Document::parse("a", text.as_bytes(), SceneFormat::Json).expect_err("no colour");
    assert!(error.to_string().contains("from 0 to 1e20"), "{error}");
}
