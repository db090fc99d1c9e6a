//! Messages about files: what they name, and where they point.

use catoptric_scene::{Document, SceneFormat};

use crate::{json, toml};

/// A sphere that lacks its material.
const SPHERE: &str = "[[spheres]]\ncenter = [0, 0, -20]\nradius = 4\n";

#[test]
fn a_toml_message_shows_the_line() {
    let text = "[[spheres]]\ncenter = [0, 0, -20]\nradius = -4\ncolor = [1, 1, 1]\n";
    let message = "\
a.toml: spheres[0].radius: found -4; allowed: a number from 1e-12 to 1e12
 --> a.toml:3:10
  |
3 | radius = -4
  |          ^^";
    assert_eq!(toml(text).unwrap_err().to_string(), message);
}

#[test]
fn a_json_message_gives_line_and_column() {
    let text = "{\n  \"render\": {\n    \"ambient\": [0, 1, -0.5]\n  }\n}";
    let message = "a.json: render.ambient[2]: found -0.5; allowed: a number from 0 to \
        3.4028234e38, the largest of f32; at line 3 column 23";
    assert_eq!(json(text).unwrap_err().to_string(), message);
}

/// Text, key, line and column, what was found, part of what is allowed.
type Case<'a> = (&'a str, &'a str, (usize, usize), &'a str, &'a str);

/// Every kind of fault that has a key.
const TOML: &[Case<'_>] = &[
    // Wrong types.
    ("[image]\nwidth = -1", "image.width", (2, 9), "-1", "an integer from 1 to 65535"),
    ("[image]\nwidth = \"9\"", "image.width", (2, 9), "\"9\"", "an integer from 1 to 65535"),
    ("[image]\nheight = 0", "image.height", (2, 10), "0", "an integer from 1 to 65535"),
    (
        "[image]\ntransfer = \"gamma\"",
        "image.transfer",
        (2, 12),
        "\"gamma\"",
        "\"linear\" or \"srgb\"",
    ),
    ("[render]\nnumerics = 1", "render.numerics", (2, 12), "1", "\"robust\" or \"textbook\""),
    ("[render]\nmax_depth = -1", "render.max_depth", (2, 13), "-1", "0 to 4294967295"),
    ("[render]\nmax_depth = 1.5", "render.max_depth", (2, 13), "1.5", "0 to 4294967295"),
    (
        "[render]\nmax_depth = 4294967296",
        "render.max_depth",
        (2, 13),
        "4294967296",
        "0 to 4294967295",
    ),
    (
        "[image]\nwidth = 640.0",
        "image.width",
        (2, 9),
        "640 written with a fraction or an exponent",
        "an integer from 1",
    ),
    ("[render]\nmax_depth = 1e400", "render.max_depth", (2, 13), "inf", "0 to 4294967295"),
    ("[camera]\nfov = true", "camera.fov", (2, 7), "true", "between 0 and 180"),
    (
        "[camera]\nfov = 1979-05-27",
        "camera.fov",
        (2, 7),
        "the date 1979-05-27",
        "between 0 and 180",
    ),
    ("[camera]\nup = [0, 1]", "camera.up", (2, 6), "[0, 1]", "[x, y, z], each a finite number"),
    ("[camera]\nup = [0, 1, \"\"]", "camera.up[2]", (2, 13), "\"\"", "a finite number"),
    ("[camera]\nup = [0, 1, 2, 3, 4]", "camera.up", (2, 6), "an array of 5", "[x, y, z]"),
    ("[render]\nambient = [1]", "render.ambient", (2, 11), "[1]", "one number or [r, g, b], each"),
    ("image = 3", "image", (1, 9), "3", "a table with the keys width, height, transfer"),
    ("[spheres]", "spheres", (1, 1), "a table", "[[spheres]] before each"),
    ("spheres = [1]", "spheres[0]", (1, 12), "1", "a table with the keys center, radius"),
    ("[[materials]]", "materials", (1, 1), "an array of 1", "by name, such as [materials.red]"),
    (
        "[materials]\nred = 3",
        "materials.red",
        (2, 7),
        "3",
        "color, diffuse, specular, shininess, reflect",
    ),
    // Numbers that are not numbers, or too large.
    ("[render]\nambient = nan", "render.ambient", (2, 11), "nan", "from 0 to 3.4028234e38"),
    ("[render]\nambient = [0, -inf, 0]", "render.ambient[1]", (2, 15), "-inf", "from 0 to"),
    ("[camera]\nposition = [1e400, 0, 0]", "camera.position[0]", (2, 13), "inf", "-1e15 to 1e15"),
    ("[render]\nambient = 0xffffffffffffffffffff", "render.ambient", (2, 11), "inf", "from 0"),
    // Keys that should not be there.
    (
        "[image]\nwidht = 3",
        "image.widht",
        (2, 1),
        "an unknown key",
        "width, height, transfer (did you mean width?)",
    ),
    ("[render]\ndepth = 3", "render.depth", (2, 1), "an unknown key", "(did you mean max_depth?)"),
    (
        "gravity = 9.81",
        "gravity",
        (1, 1),
        "an unknown key",
        "image, camera, render, lights, materials, spheres, planes",
    ),
    (
        "[materials.red]\ncolour = 1",
        "materials.red.colour",
        (2, 1),
        "an unknown key",
        "(did you mean color?)",
    ),
    ("\"\\u001b[31m\" = 1", "\"\\u{1b}[31m\"", (1, 1), "an unknown key", "image, camera"),
    // Keys that are missing, shown at the table that lacks them.
    (
        "[[lights]]\nintensity = 1",
        "lights[0].position",
        (1, 1),
        "nothing, and it is required",
        "[x, y, z]",
    ),
    (
        "[[spheres]]\nradius = 1",
        "spheres[0].center",
        (1, 1),
        "nothing, and it is required",
        "[x, y, z]",
    ),
    (
        "[[spheres]]\ncenter = [0, 0, 0]",
        "spheres[0].radius",
        (1, 1),
        "nothing, and it is required",
        "1e-12 to 1e12",
    ),
    (
        "[[planes]]\npoint = [0, 0, 0]",
        "planes[0].normal",
        (1, 1),
        "nothing, and it is required",
        "[x, y, z]",
    ),
    (
        "[materials.\"a b\"]",
        "materials.\"a b\".color",
        (1, 1),
        "nothing, and it is required",
        "[r, g, b]",
    ),
    // Ranges of materials that nothing uses.
    ("[materials.red]\ncolor = [1, -1, 1]", "materials.red.color[1]", (2, 13), "-1", "from 0 to"),
    (
        "[materials.red]\ncolor = [1, 1, 1]\nspecular = 2",
        "materials.red.specular",
        (3, 12),
        "2",
        "from 0 to 1, or more where `reflect`",
    ),
    (
        "[materials.red]\ncolor = [1e30, 1, 1]\ndiffuse = 1e30",
        "materials.red.color",
        (2, 9),
        "[1e30, 1, 1]",
        "at most 1e20",
    ),
    // Settings that do not go together.
    (
        "[camera]\nlook_at = [0, 0, 0]",
        "camera.look_at",
        (2, 11),
        "[0, 0, 0]",
        "apart from the camera's `position`",
    ),
    ("[camera]\nup = [0, 0, 2]", "camera.up", (2, 6), "[0, 0, 2]", "not parallel to the view"),
];

#[test]
fn faults_name_key_place_found_and_allowed() {
    for (text, key, place, found, allowed) in TOML {
        let error = toml(text).expect_err(text);
        let message = error.to_string();
        assert_eq!(error.key().as_deref(), Some(*key), "{message}");
        assert_eq!(error.position(), Some(*place), "{message}");
        let (line, column) = *place;
        assert!(
            message.starts_with(&format!("a.toml: {key}: found {found}; allowed: ")),
            "{message}"
        );
        assert!(message.contains(allowed), "{message}");
        assert!(message.contains(&format!("\n --> a.toml:{line}:{column}\n")), "{message}");
        let shown = text.lines().nth(line - 1).expect("a line of the text");
        assert!(message.contains(&format!("\n{line} | {shown}\n")), "{message}");
    }
}

#[test]
fn materials_are_named_or_inline() {
    let red = "[materials.red]\ncolor = [1, 0, 0]\n";
    let cases = [
        (
            "material = \"rad\"\n",
            (6, 12),
            "spheres[0].material: found \"rad\"; allowed: the name of one of the materials: red (did you mean red?)",
        ),
        (
            "material = \"red\"\ndiffuse = 1\n",
            (7, 1),
            "spheres[0].diffuse: found both `diffuse` and `material`; allowed: either",
        ),
        (
            "",
            (3, 1),
            "spheres[0].color: found nothing, and it is required; allowed: [r, g, b] here, or `material`",
        ),
        ("material = 3\n", (6, 12), "spheres[0].material: found 3; allowed: the name of one"),
        (
            "material = { color = [1, 0, 0] }\n",
            (6, 12),
            "spheres[0].material: found a table; allowed: the name of one of the materials; without one, color, diffuse, specular, shininess, reflect stand beside the body's own keys",
        ),
        ("[spheres.material]\ncolor = [1, 0, 0]\n", (6, 1), "found a table; allowed: the name"),
    ];
    for (keys, place, text) in cases {
        let error = toml(&format!("{red}{SPHERE}{keys}")).expect_err(keys);
        assert_eq!(error.position(), Some(place), "{error}");
        assert!(error.to_string().contains(text), "{error}");
    }
    let error = toml(&format!("{SPHERE}material = \"red\"")).unwrap_err();
    assert!(error.to_string().contains("and there are none"), "{error}");
}

#[test]
fn long_lists_of_materials_are_shortened() {
    let materials: String =
        (0..50).map(|i| format!("[materials.paint{i}]\ncolor = [1, 1, 1]\n")).collect();
    let error = toml(&format!("{materials}{SPHERE}material = \"pain7\"")).unwrap_err();
    assert!(error.to_string().contains(" and 30 more (did you mean paint7?)"), "{error}");
}

/// A suggestion takes time with the square of the word, so words that no one would compare by eye
/// get none: two names of 200 000 letters once took 12 seconds.
#[test]
fn very_long_words_get_no_suggestion() {
    let error = |letters: usize| {
        let known = "a".repeat(letters);
        let text =
            format!("[materials.{known}]\ncolor = [1, 1, 1]\n{SPHERE}material = \"{known}b\"");
        toml(&text).unwrap_err().to_string()
    };
    assert!(error(60).contains("did you mean"), "{}", error(60));
    assert!(!error(5_000).contains("did you mean"), "{} bytes", error(5_000).len());
}

#[test]
fn long_lines_are_cut_around_the_place() {
    let lights = "{ position = [0, 0, 0] }, ".repeat(10_000);
    let error = toml(&format!("lights = [{lights}{{ position = [1e16, 0, 0] }}]")).unwrap_err();
    assert_eq!(error.key().as_deref(), Some("lights[10000].position[0]"));
    let message = error.to_string();
    assert!(message.contains("1e16, 0, 0] }]") && message.len() < 1000, "{message}");
}

#[test]
fn json_faults_have_the_same_words() {
    let cases = [
        (
            "{\n\"render\": {\"max_depth\": 1.5}}",
            "render.max_depth: found 1.5; allowed: an integer from 0 to 4294967295; at line 2 column 25",
        ),
        (
            "{\"render\": {\"ambient\": null}}",
            "render.ambient: found null; allowed: one number or [r, g, b], each",
        ),
        (
            "{\"render\":\n{\"ambient\": -1}}",
            "render.ambient: found -1; allowed: a number from 0 to",
        ),
        ("{\"speres\": []}", "speres: found an unknown key; allowed: image, camera"),
        (
            "{\"spheres\": [{}]}",
            "spheres[0].center: found nothing, and it is required; allowed: [x, y, z]; at line 1 column 14",
        ),
        ("[]", "top level: found []; allowed: a table with the keys image"),
        (
            "{\"materials\": {\"\\u0072ed\": {\"color\": [0, 0, -1]}}}",
            "materials.red.color[2]: found -1; allowed: a number from 0",
        ),
    ];
    for (text, expected) in cases {
        let error = json(text).expect_err(text);
        let message = error.to_string();
        assert!(message.starts_with(&format!("a.json: {expected}")), "{message}");
        assert!(error.position().is_some(), "{message}");
        assert_eq!(message.lines().count(), 1, "{message}");
    }
    assert_eq!(json("[]").unwrap_err().key(), None);
}

#[test]
fn broken_syntax_has_a_place_and_no_key() {
    let cases = [
        ("[image", (1, 7)),
        ("[image]\nwidth = ", (2, 9)),
        ("[image]\nwidth = 1\nwidth = 2", (3, 1)),
        ("[image]\n[camera]\n[image]", (3, 2)),
        ("spheres = [\n", (1, 12)),
        ("é = 1", (1, 1)),
        ("{\"image\": {}}", (1, 1)),
    ];
    for (text, place) in cases {
        let error = toml(text).expect_err(text);
        assert_eq!((error.key(), error.position()), (None, Some(place)), "{error}");
        assert!(
            error.to_string().contains(&format!("\n --> a.toml:{}:{}\n", place.0, place.1)),
            "{error}"
        );
    }
    let cases = [
        ("{", (1, 1), "the text ends while parsing an object"),
        ("{\"image\": {\"width\": 3,}}", (1, 23), "trailing comma"),
        (
            "{\"image\": {\n\"width\": 3, \"width\": 3}}",
            (2, 19),
            "the key \"width\" is there twice",
        ),
        ("{} x", (1, 4), "trailing characters"),
        (
            "{\"render\": {\"ambient\": 1e400}}",
            (1, 28),
            "number out of range; allowed: at most 1.797",
        ),
        ("{\"render\": {\"ambient\": NaN}}", (1, 24), "found NaN; allowed: finite numbers"),
        ("{\"a\": -Infinity}", (1, 8), "found Infinity; allowed: finite numbers"),
        ("[image]", (1, 2), "expected value; a scene in JSON starts with {, one in TOML needs"),
        // A line that ends inside a string: at its end, not before the next one.
        ("{\n\"color: 1,\n\"a\": 2}", (2, 11), "control character"),
        // Columns are characters: the letters before have two bytes each.
        ("{\"éé\": x}", (1, 8), "expected value"),
    ];
    for (text, place, words) in cases {
        let error = json(text).expect_err(text);
        assert_eq!((error.key(), error.position()), (None, Some(place)), "{error}");
        let end = format!("; at line {} column {}", place.0, place.1);
        let message = error.to_string();
        assert!(message.contains(words) && message.ends_with(&end), "{message}");
    }
}

#[test]
fn a_file_without_text_is_refused() {
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        for text in ["", " \n\t\r\n", "\u{feff}"] {
            let error = Document::parse("a", text.as_bytes(), format).unwrap_err();
            let message = "a: the file is empty; a scene needs at least one table, such as [image]";
            assert_eq!(error.to_string(), message);
        }
    }
}

#[test]
fn a_file_that_is_not_utf_8_is_refused() {
    let utf_16 = |text: &str, big: bool| -> Vec<u8> {
        let unit = |unit: u16| if big { unit.to_be_bytes() } else { unit.to_le_bytes() };
        text.encode_utf16().flat_map(unit).collect()
    };
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        for text in ["\u{feff}[image]", "[image]", "{}"] {
            for big in [false, true] {
                let error = Document::parse("a", &utf_16(text, big), format).unwrap_err();
                assert_eq!(error.to_string(), "a: the file is UTF-16 text; save it as UTF-8");
            }
        }
        for bytes in [b"[image]\n\xff", b"[image]\n\0"] {
            let error = Document::parse("a", bytes, format).unwrap_err();
            let message =
                "a: byte 8 (counted from 0) is not UTF-8 text; a scene is TOML or JSON in UTF-8";
            assert_eq!(error.to_string(), message);
        }
        // Neither is UTF-16 a file of zeros, nor one of a single byte.
        for bytes in [&[0; 100][..], &[0xff]] {
            let error = Document::parse("a", bytes, format).unwrap_err();
            assert!(error.to_string().contains("byte 0 (counted from 0)"), "{error}");
        }
    }
}

/// Characters that a terminal obeys or hides: ESC, DEL, C1, bidi marks, joiners, tags, fillers.
const UNSEEN: &str = "\u{1b}\u{7}\r\u{7f}\u{9b}\u{9d}\u{ad}\u{61c}\u{200b}\u{200d}\u{200e}\u{200f}\
    \u{202e}\u{2028}\u{2066}\u{2069}\u{feff}\u{fe0f}\u{3164}\u{e000}\u{e0041}\u{e0100}";

/// How the message is read off a terminal of 80 columns: its rows.
fn rows(message: &str) -> usize {
    message.lines().map(|line| line.chars().count().div_ceil(80).max(1)).sum()
}

/// Whether a terminal shows all of a message and obeys none of it.
fn is_plain(message: &str) -> bool {
    message.chars().all(|c| c == '\n' || !(c.is_ascii_control() || UNSEEN.contains(c)))
}

#[test]
fn messages_hold_nothing_that_a_terminal_obeys() {
    // TOML's text may hold these raw; the others are faults of syntax, and shown for that.
    let above: String = UNSEEN.chars().filter(|c| !c.is_ascii()).collect();
    let file = format!("a\n{UNSEEN}.toml");
    let texts = [
        format!("camera.\t'{above}' = 1 # {above}"),
        format!("image.transfer = '{above}' # {above}"),
        format!("[materials.'{above}']\ncolor = [1, 1, 1]\n[[spheres]]\nmaterial = 'x'"),
        format!("{UNSEEN} = "),
        format!("a = '{UNSEEN}'"),
        format!("'{above}' = 1\n'{above}' = 2"),
        "a = \u{1b}[31m".to_owned(),
        "[image]\r\nwidth = 0\r\n".to_owned(),
    ];
    for text in texts {
        let error = Document::parse(&file, text.as_bytes(), SceneFormat::Toml)
            .and_then(Document::into_scene)
            .expect_err(&text);
        let message = error.to_string();
        assert!(is_plain(&message), "{message:?}");
        assert!(message.starts_with("a\\n\\u{1b}\\u{7}\\r\\u{7f}\\u{9b}"), "{message}");
    }
    for text in [format!("{{\"{above}\": 1}}"), format!("{{\"a\" {UNSEEN}: 1}}")] {
        let message = json(&text).expect_err(&text).to_string();
        assert!(is_plain(&message), "{message:?}");
    }
}

#[test]
fn letters_of_all_languages_stand_as_they_are() {
    let name = "Σκηνή-сцена-シーン-e\u{301}-हिन्दी '\"\\.toml";
    assert_eq!(catoptric_scene::shown(name, 240), name);
    let error = Document::parse(name, b"", SceneFormat::Toml).expect_err("no text");
    assert!(error.to_string().starts_with(&format!("{name}: the file is empty")), "{error}");
}

/// What is underlined stays so where the characters before it are shown as escapes.
#[test]
fn the_place_is_underlined_behind_escapes() {
    let message = toml("\u{feff}\tcamera.'\u{202e}' = 1").unwrap_err().to_string();
    let lines: Vec<&str> = message.lines().collect();
    assert_eq!(lines[1], " --> a.toml:1:9", "{message}");
    assert_eq!(lines[3], r"1 |     camera.'\u{202e}' = 1", "{message}");
    assert_eq!(lines[4], "  |            ^^^^^^^^^^", "{message}");
}

#[test]
fn a_message_is_a_screenful_at_most() {
    let long = "x".repeat(300_000);
    let wide = "シ".repeat(300_000);
    let unseen = "\u{202e}".repeat(300_000);
    let names = |name: &str| -> String {
        (0..300).map(|i| format!("[materials.'{name}{i}']\ncolor = [1, 1, 1]\n")).collect()
    };
    for part in [&long, &wide, &unseen] {
        let texts = [
            format!("'{part}' = 1"),
            format!("camera.'{part}' = 1 # {part}"),
            format!("image.transfer = '{part}'"),
            format!("image.width = [{}1]", "[1, 1], ".repeat(100_000)),
            format!("{part} {part}"),
            format!("a.'{part}' = 1\na.'{part}' = 2"),
            format!("{}[[spheres]]\nmaterial = '{part}'", names(&part[..600])),
            format!("[materials.'{part}'.'{part}'.'{part}'.'{part}']\na = 1"),
        ];
        for text in texts {
            let error = Document::parse(part, text.as_bytes(), SceneFormat::Toml)
                .and_then(Document::into_scene)
                .expect_err("no scene");
            let message = error.to_string();
            assert!(rows(&message) <= 24, "{}: {message}", rows(&message));
            assert!(message.contains("bytes ...]"), "{message}");
        }
    }
}

#[test]
fn a_long_text_keeps_its_ends() {
    let shown = catoptric_scene::shown;
    assert_eq!(shown("", 10), "");
    assert_eq!(shown("0123456789", 10), "0123456789");
    assert_eq!(shown("0123456789a", 10), "01234[... 1 bytes ...]6789a");
    assert_eq!(shown(&"\0".repeat(9), 26), r"\u{0}\u{0}[... 5 bytes ...]\u{0}\u{0}");
    assert_eq!(shown("éééé", 5), "é[... 4 bytes ...]é");
}
