//! `explain` from outside: what it says is what the picture is.

mod page;
mod pixel;
mod scene;

use serde_json::Value;

use crate::program::Folder;

/// A colour or a k, read back to its bits.
fn single(value: &Value) -> f32 {
    let digits = value.as_f64().unwrap_or_else(|| panic!("no number: {value}")).to_string();
    digits.parse().expect("a number")
}

/// Numbers of a list.
fn numbers(value: &Value) -> Vec<f32> {
    let list = value.as_array().unwrap_or_else(|| panic!("no list: {value}"));
    list.iter().map(single).collect()
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let folder = Folder::new();
    folder.write("bad.toml", "width = 3");
    let large =
        crate::program::SCENE.replace("width = 13\nheight = 7", "width = 65535\nheight = 65535");
    folder.write("large.toml", large);
    for (arguments, code, says) in [
        ("explain", 2, "SCENE"),
        ("explain scene.toml --pixel 13,0", 2, "X from 0 to 12 and Y from 0 to 6"),
        ("explain scene.toml --pixel 0,7", 2, "not in the image of 13x7"),
        ("explain scene.toml --pixel 1", 2, "two whole numbers"),
        ("explain scene.toml --pixel -1,2", 2, "two whole numbers"),
        ("explain scene.toml --pixel 1,2,3", 2, "two whole numbers"),
        ("explain scene.toml --html page.html", 2, "--pixel"),
        ("explain scene.toml --pixel 1,2 --json --html -", 2, "stdout"),
        ("explain scene.toml --pixel 1,2 --html scene.toml", 2, "the scene itself"),
        ("explain missing.toml", 3, "missing.toml"),
        ("explain bad.toml", 3, "width"),
        ("explain large.toml", 3, "image.width"),
        ("explain scene.toml --pixel 1,2 --html no/page.html", 4, "no/page.html"),
    ] {
        let before = folder.contents();
        let ran = folder.run(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {}", ran.stderr);
        assert!(ran.stderr.contains(says), "{arguments}: {}", ran.stderr);
        assert!(ran.stdout.is_empty(), "{arguments}");
        assert_eq!(folder.contents(), before, "{arguments}");
    }
    // One pixel of a picture that is too large for two films, and a page of it.
    folder.done("explain large.toml --pixel 65534,65534");
    folder.done("explain large.toml --pixel 65534,0 --html large.html");
}

#[test]
fn a_reader_that_goes_is_4() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 20000 -o deep.toml");
    let ran = folder.shell("catoptric explain deep.toml --pixel 0,0 | head -c 10; exit 0");
    assert!(ran.stderr.contains("cannot be written"), "{}", ran.stderr);
}
