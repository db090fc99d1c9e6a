//! No text, however broken, makes reading panic or overflow the stack.

use std::fmt::Write;

use catoptric_scene::{Document, Scene, SceneFormat};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::{Index, select};

use crate::drafts::draft;

/// Reads a text as both formats, and writes out the message if it is refused.
fn read(text: &[u8]) {
    for format in [SceneFormat::Toml, SceneFormat::Json] {
        let scene = Document::parse("broken", text, format).and_then(Document::into_scene);
        if let Err(error) = scene {
            let mut message = String::new();
            write!(message, "{error}").expect("a string takes all");
            assert!(message.starts_with("broken: "), "{message}");
        }
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
