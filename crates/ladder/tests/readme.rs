//! What the README shows is so: code, log and bytes.

use std::fs;
use std::path::Path;
use std::process::Command;

use catoptric_ladder::{Event, FORWARD, RUNGS, Rung};
use catoptric_scene::{Compiled, Crop, Grid, View};
use catoptric_tests::scenes;
use catoptric_tests::source::Source;

use crate::comparison::{rungs, watched};
use crate::native_stack::bytes_a_mirror;

const README: &str = include_str!("../README.md");

/// A block starts with its crate, and the function or type that it shows whole, wherever that
/// stands. `CATOPTRIC_BLESS=1` writes the blocks anew.
#[test]
fn shows_the_code_as_it_is() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR"));
    let sources = ["ladder", "core"]
        .map(|name| (name, Source::new(&folder.join("..").join(name).join("src"))));
    let mut parts = README.split("```rust\n");
    let mut written = parts.next().expect("words come first").to_owned();
    let mut blocks = 0;
    for part in parts {
        let (block, words) = part.split_once("```").expect("a block ends");
        let head = block.lines().next().expect("a block starts with what it shows");
        let of = head.strip_prefix("// ").and_then(|shown| shown.split_once(": "));
        let (shown, name) = of.expect("a block starts with what it shows");
        let source =
            sources.iter().find(|(name, _)| *name == shown).expect("a crate that is shown");
        let code = source.1.text(name).unwrap_or_else(|why| panic!("{why}"));
        written += &format!("```rust\n{head}\n{code}```{words}");
        blocks += 1;
    }
    assert!(blocks > 10, "the README shows code");
    if std::env::var_os("CATOPTRIC_BLESS").is_some() {
        fs::write(folder.join("README.md"), &written).expect("the README can be written");
        return;
    }
    let differ = README.lines().zip(written.lines()).zip(1..).find(|((a, b), _)| a != b);
    assert_eq!(differ, None, "README.md shows other code; CATOPTRIC_BLESS=1 writes it anew");
    assert_eq!(README, written);
}

/// The cells of a rung's row, the first table's.
fn row(rung: &Rung) -> Vec<&'static str> {
    let name = if rung.name == FORWARD.name { "aside" } else { rung.name };
    let mut rows = README.lines().filter(|line| line.starts_with(&format!("| {name} |")));
    rows.next().expect("a row").split('|').map(str::trim).collect()
}

#[test]
fn shows_the_bytes_of_a_level() {
    for rung in RUNGS {
        let cells = row(&rung);
        let bytes = cells[cells.len() - 2].parse().unwrap_or(0);
        assert_eq!(bytes, rung.level_bytes, "{}", rung.name);
    }
}

/// A frame is the compiler's affair: the bytes that grow are those of the compiler that the
/// README names, in a release build for x86-64. That others do not grow is everybody's.
#[test]
fn shows_the_native_stack_as_it_is_measured() {
    let (_, named) = README.split_once("rustc ").expect("a compiler is named");
    let named = named.split_once(' ').expect("words follow").0;
    let asked = Command::new("rustc").arg("--version").output();
    let version = asked.map_or(String::new(), |told| String::from_utf8_lossy(&told.stdout).into());
    let same = version.starts_with(&format!("rustc {named}."))
        && !cfg!(debug_assertions)
        && cfg!(target_arch = "x86_64");
    if !same {
        println!("frames are not compared: the table is of rustc {named}, this is {version}");
    }
    for rung in RUNGS.iter().chain([&FORWARD]) {
        let cells = row(rung);
        let shown: usize = cells[cells.len() - 3].parse().expect("a number");
        assert_eq!(shown > 0, rung.grows_native_stack, "{}", rung.name);
        assert!(!same || shown == bytes_a_mirror(rung), "{}: {}", rung.name, bytes_a_mirror(rung));
    }
}

/// An event's line in the README: its kind and depth, and of colours the red channel.
fn line(event: &Event) -> String {
    match event {
        Event::Call { depth, .. } => format!("Call {depth}"),
        Event::Hit { depth, primitive, local, k, .. } => {
            format!("Hit {depth} primitive {primitive}, local {}, k {k}", local.x)
        }
        Event::Fold { depth, local, k, back, colour } => {
            format!("Fold {depth} {} + {k} · {} = {}", local.x, back.x, colour.x)
        }
        Event::Return { depth, colour } => format!("Return {depth} {}", colour.x),
    }
}

#[test]
fn shows_the_log_of_every_rung() {
    let (_, shown) = README.split_once("Pixel (494, 200) of\n").expect("the pixel is named");
    let (_, shown) = shown.split_once("```text\n").expect("a block starts");
    let shown: Vec<&str> = shown.split_once("```").expect("a block ends").0.lines().collect();
    let scene = scenes::named("workshop");
    let scene = catoptric_scene::Scene::new(scene).expect("the workshop's");
    let pixel = Crop { x: 494, y: 200, width: 1, height: 1 };
    let grid = Grid::new(&View::new(&scene, Some(pixel), 1).expect("a pixel of it"));
    for (rung, isa) in rungs() {
        let log = watched(&rung, isa, &Compiled::new(&scene), &grid, (0, 0));
        assert_eq!(log.len(), shown.len(), "{}", rung.name);
        for (event, shown) in log.iter().zip(&shown) {
            let indented = shown.len() - shown.trim_start().len();
            assert_eq!(indented, 2 * event.depth() as usize, "{shown}");
            let words = shown.split_whitespace().collect::<Vec<_>>().join(" ");
            // A remark may follow.
            let rest = words.strip_prefix(&line(event));
            let fits = rest.is_some_and(|rest| rest.is_empty() || rest.starts_with(' '));
            assert!(fits, "{}: {}, but {shown}", rung.name, line(event));
        }
    }
}
