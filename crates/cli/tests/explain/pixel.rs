//! One eye ray's life, in words and as JSON.

use serde_json::Value;

use super::{numbers, single};
use crate::program::{Folder, SCENE, reference};

/// The widest line that a terminal of 80 columns shows whole.
const COLUMNS: usize = 80;

/// Every pixel: the steps are a recursion's, they add up, and they end in the picture's colour.
#[test]
fn steps_end_in_the_pictures_colour() {
    let folder = Folder::new();
    let film = reference(None, 1);
    let mut deepest = 0;
    for (x, y) in (0..7).flat_map(|y| (0..13).map(move |x| (x, y))) {
        let told = folder.done(&format!("explain scene.toml --pixel {x},{y} --json")).json();
        assert_eq!(told["schema"], "catoptric-explain-pixel");
        let colour = film.pixels()[y * 13 + x];
        assert_eq!(numbers(&told["colour"]), colour, "{x},{y}");

        let steps = told["steps"].as_array().expect("steps");
        let mut pending: Vec<(Value, Value)> = Vec::new();
        let mut stack: Vec<(Value, Value)> = Vec::new();
        let mut back = Value::Null;
        for (i, step) in (1..).zip(steps) {
            assert_eq!(step["step"], i);
            let owed = (step["local"].clone(), step["k"].clone());
            match step["engine"].as_str() {
                Some("push") => stack.push(owed.clone()),
                Some("fold") => assert_eq!(stack.pop(), Some(owed.clone()), "{x},{y}"),
                _ => {}
            }
            match step["recursion"].as_str().expect("a word") {
                "call" => assert_eq!(step["depth"], pending.len()),
                "hit" if step["followed"] == true => pending.push(owed),
                "hit" => {}
                "fold" => {
                    assert_eq!(pending.pop(), Some(owed));
                    assert_eq!(step["back"], back, "{x},{y}: what has come back is folded");
                    assert_eq!(step["depth"], pending.len());
                    let (local, back) = (numbers(&step["local"]), numbers(&step["back"]));
                    let k = single(&step["k"]);
                    let sum: Vec<f32> = (0..3).map(|c| local[c] + k * back[c]).collect();
                    assert_eq!(numbers(&step["colour"]), sum, "{x},{y}");
                }
                "return" => back = step["colour"].clone(),
                other => panic!("{other}"),
            }
        }
        assert!(pending.is_empty() && stack.is_empty());
        assert_eq!(numbers(&back), colour, "{x},{y}: the last step returns the colour");
        deepest = deepest.max(told["deepest"].as_u64().expect("a depth"));
    }
    assert_eq!(deepest, 4, "some path is as deep as allowed");
}

#[test]
fn words_fit_a_terminal_and_hold_the_same_numbers() {
    let folder = Folder::new();
    let told = folder.done("explain scene.toml --pixel 4,3");
    let json = folder.done("explain scene.toml --pixel 4,3 --json").json();
    for colour in numbers(&json["colour"]) {
        let digits = colour.to_string();
        assert!(told.text().contains(&digits), "{digits} is not in {}", told.text());
    }
    for ran in [told, folder.done("explain scene.toml")] {
        let long = ran.text().lines().find(|line| line.chars().count() > COLUMNS);
        assert_eq!(long, None);
    }
}

/// Past the recursion's stack the loop tells its side; past the ladder's nothing is told.
#[test]
fn deep_paths_are_told_to_the_end() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 100001 -o deep.toml");
    let told = folder.done("explain deep.toml --pixel 0,0 --json").json();
    assert_eq!(told["rungs"], serde_json::json!(["r3", "r5"]));
    assert_eq!(told["deepest"], 100_001);
    assert_eq!(told["steps"].as_array().expect("steps").len(), 4 * 100_001 + 3);

    let page = "explain deep.toml --pixel 0,0 --html deep.html";
    folder.done(page);
    let page = String::from_utf8(folder.read("deep.html")).expect("text");
    assert!(page.len() < 2 << 20, "{} bytes", page.len());
    assert!(page.contains("steps, in the middle of the path, are not on this page"));
    assert!(page.contains("more are not"), "hits that are not drawn are counted");

    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 4294967295 -o e.toml");
    let ran = folder.run("explain e.toml --pixel 0,0");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("more than 1000000 reflections"), "{}", ran.stderr);
    assert!(ran.stdout.is_empty());
}

/// A hit that is the last says why, in words and as JSON.
#[test]
fn the_last_hit_says_why() {
    let folder = Folder::new();
    folder.write("cut.toml", SCENE.replace("[render]\n", "[render]\nmin_weight = 0.25\n"));
    folder.write("matt.toml", SCENE.replace("reflect = 0.2\n", ""));
    for (scene, min_weight, expected, words) in [
        ("scene.toml", 0.0, "max_depth", Some("not followed: max_depth is 4")),
        ("cut.toml", 0.25, "min_weight", Some("not followed: its weight is below 0.25")),
        ("matt.toml", 0.0, "no_mirror", None),
    ] {
        let mut found = 0;
        for (x, y) in (0..7).flat_map(|y| (0..13).map(move |x| (x, y))) {
            let told = folder.done(&format!("explain {scene} --pixel {x},{y} --json")).json();
            assert_eq!(told["min_weight"], min_weight);
            let formed = scene == "cut.toml";
            assert_eq!(told["engine_forms_weights"], formed, "without a cut the engine has none");
            let steps = told["steps"].as_array().expect("steps");
            for hit in steps.iter().filter(|step| step["recursion"] == "hit") {
                assert_eq!(hit["followed"] == true, hit["last"].is_null(), "{hit}");
            }
            if steps.iter().any(|step| step["last"] == expected) {
                found += 1;
                let ran = folder.done(&format!("explain {scene} --pixel {x},{y}"));
                let text = ran.text();
                assert!(words.is_none_or(|words| text.contains(words)), "{text}");
                assert!(text.contains("(the scene's: the engine keeps none)"), "{text}");
                let marked = text.contains("(the recursion's: the engine forms none)");
                assert_eq!(marked, !formed, "{text}");
            }
        }
        assert!(found > 0, "{scene}: no {expected}");
    }
}

/// The instruction set that was asked for is the one that is watched; the account is the same.
#[test]
fn every_instruction_set_tells_the_same() {
    let folder = Folder::new();
    let told = |isa: &str| {
        let ran = folder
            .shell(&format!("CATOPTRIC_ISA={isa} catoptric explain scene.toml --pixel 8,5 --json"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        ran.json()
    };
    assert_eq!(told("portable"), told("avx2"));
}
