//! No text, however broken, makes reading panic or overflow the stack.

use std::fmt::Write;
use std::fs;
use std::ops::Range;

use catoptric_scene::{Compiled, Document, Scene, SceneError, SceneFormat};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use crate::drafts::draft;

/// Reads a text as both formats. What is refused has a message, whose place is a place of
/// the text; what is accepted compiles, and reads back to its bits once written.
fn read(text: &[u8]) {
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        match Document::parse("broken", text, format).and_then(Document::into_scene) {
            Ok(scene) => accepted(&scene),
            Err(error) => refused(&error, text),
        }
    }
}

fn refused(error: &SceneError, text: &[u8]) {
    let mut message = String::new();
    write!(message, "{error}").expect("a string takes all");
    assert!(message.starts_with("broken: "), "{message}");
    if let Some((line, column)) = error.position() {
        let text = std::str::from_utf8(text).expect("a place in text");
        let shown = text.split('\n').nth(line - 1).expect("a line of the text");
        assert!((1..=shown.chars().count() + 1).contains(&column), "{message}");
    }
}

fn accepted(scene: &Scene) {
    let _ = Compiled::new(scene);
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        let text = scene.to_text(format);
        let again = Document::parse("written", text.as_bytes(), format);
        let again = again.and_then(Document::into_scene).expect("what is written is valid");
        assert_eq!(format!("{again:?}"), format!("{scene:?}"), "{text}");
    }
}

/// What fuzzing found worth keeping (`tests/fuzz`).
#[test]
fn the_fuzzer_s_corpus() {
    let corpus = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/fuzz/corpus/scene");
    let files: Vec<_> = fs::read_dir(corpus).expect("the corpus").collect();
    assert!(files.len() >= 10, "{} files", files.len());
    for file in files {
        read(&fs::read(file.expect("an entry").path()).expect("a file"));
    }
}

#[derive(Clone, Debug)]
enum Mutation {
    Replace(Index, u8),
    Insert(Index, Vec<u8>),
    Delete(Index, usize),
    Truncate(Index),
}

fn mutation() -> impl Strategy<Value = Mutation> {
    let byte = prop_oneof![any::<u8>(), select(b"[]{}\"'=.,-+:#\\ \n\t\r\0e0159ni".to_vec())];
    let index = any::<Index>;
    prop_oneof![
        (index(), byte.clone()).prop_map(|(at, byte)| Mutation::Replace(at, byte)),
        (index(), vec(byte, 1..6)).prop_map(|(at, bytes)| Mutation::Insert(at, bytes)),
        (index(), 1..30_usize).prop_map(|(at, count)| Mutation::Delete(at, count)),
        index().prop_map(Mutation::Truncate),
    ]
}

fn mutate(text: &mut Vec<u8>, mutation: Mutation) {
    if text.is_empty() {
        return;
    }
    match mutation {
        Mutation::Replace(at, byte) => *at.get_mut(text) = byte,
        Mutation::Insert(at, bytes) => {
            let at = at.index(text.len());
            text.splice(at..at, bytes);
        }
        Mutation::Delete(at, count) => {
            let start = at.index(text.len());
            let end = text.len().min(start + count);
            text.drain(start..end);
        }
        Mutation::Truncate(at) => text.truncate(at.index(text.len())),
    }
}

proptest! {
    #[test]
    fn arbitrary_bytes(bytes in vec(any::<u8>(), 0..200)) {
        read(&bytes);
    }

    #[test]
    fn arbitrary_tokens(tokens in vec(select(TOKENS.to_vec()), 0..40)) {
        read(tokens.concat().as_bytes());
    }

    #[test]
    fn mutated_scenes(draft in draft(), mutations in vec(mutation(), 1..6)) {
        let scene = Scene::new(draft).expect("generated valid");
        for format in [SceneFormat::Toml, SceneFormat::Json] {
            let mut text = scene.to_text(format).into_bytes();
            for mutation in &mutations {
                mutate(&mut text, mutation.clone());
            }
            read(&text);
        }
    }
}

/// Numbers at the ends of f64, f32 and the integers, and what is only nearly a number.
const EXTREMES: [&str; 30] = [
    "nan",
    "-nan",
    "inf",
    "-inf",
    "+inf",
    "NaN",
    "Infinity",
    "0",
    "-0",
    "-0.0",
    "1e400",
    "-1e400",
    "1e-400",
    "1.7976931348623157e308",
    "5e-324",
    "3.4028235e38",
    "1e-45",
    "1e15",
    "-1e15",
    "1e12",
    "1e-12",
    "65536",
    "4294967295",
    "4294967296",
    "9223372036854775807",
    "9223372036854775808",
    "-9223372036854775809",
    "0xffffffffffffffff",
    "1_000",
    "00",
];

/// The places of all numbers in a text.
fn numbers(text: &str) -> Vec<Range<usize>> {
    let digit = |c: char| c.is_ascii_digit() || "+-.".contains(c);
    let mut found = Vec::new();
    let mut rest = 0;
    while let Some(start) = text[rest..].find(|c: char| c.is_ascii_digit() || c == '-') {
        let start = rest + start;
        let end = text[start..].find(|c: char| !digit(c) && c != 'e');
        rest = end.map_or(text.len(), |end| start + end);
        found.push(start..rest);
    }
    found
}

proptest! {
    #[test]
    fn numbers_at_their_extremes(
        draft in draft(),
        changes in vec((any::<Index>(), select(EXTREMES.to_vec())), 1..4),
    ) {
        let scene = Scene::new(draft).expect("generated valid");
        for format in [SceneFormat::Toml, SceneFormat::Json] {
            let mut text = scene.to_text(format);
            for (at, number) in &changes {
                let places = numbers(&text);
                text.replace_range(places[at.index(places.len())].clone(), number);
            }
            read(text.as_bytes());
        }
    }
}

const TOKENS: [&str; 30] = [
    "[",
    "]",
    "{",
    "}",
    "[[",
    "]]",
    "\n",
    " ",
    ",",
    ":",
    "=",
    ".",
    "\"",
    "\"\"\"",
    "'",
    "#",
    "-1",
    "1e400",
    "nan",
    "0xff",
    "image",
    "\"camera\"",
    "spheres",
    "materials",
    "material",
    "width",
    "color",
    "\"é\"",
    "1979-05-27",
    "true",
];

#[test]
fn deep_nesting_is_refused() {
    // Far more than a thread's stack has room for frames.
    let deep = 50_000;
    for (open, close) in [("[", "]"), ("{a=", "}"), ("{\"a\":", "}"), ("a.", "a=1"), ("[a.", "]")] {
        for start in ["", "a = "] {
            read(format!("{start}{}", open.repeat(deep)).as_bytes());
            read(format!("{start}{}{}", open.repeat(deep), close.repeat(deep)).as_bytes());
        }
    }
}
