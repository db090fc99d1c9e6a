//! What a terminal is given: nothing that it obeys or hides, and a screenful at most.

use std::ffi::OsStr;
use std::process::Command;

use crate::program::{CATOPTRIC, Folder, SCENE};

/// A name with ESC, BEL, CR, LF, DEL, C1, marks of direction, joiners, tags and fillers.
const UNSEEN: &str = "a\u{1b}[31m\u{7}\r\n\u{7f}\u{9b}31m\u{9d}\u{ad}\u{61c}\u{200b}\u{200d}\u{200f}\
    \u{202e}\u{2028}\u{2066}\u{feff}\u{fe0f}\u{3164}\u{e000}\u{e0041}";

/// Runs with arguments that may be anything; what both ways out were given, as one text.
fn said(folder: &Folder, arguments: &[&OsStr]) -> String {
    let ran = Command::new(CATOPTRIC)
        .args(arguments)
        .current_dir(folder.path("."))
        .env_remove("CATOPTRIC_ISA")
        .output()
        .expect("the program runs");
    let text = [ran.stdout, ran.stderr].concat();
    String::from_utf8(text).expect("text")
}

/// Expects that a terminal shows all of a text, obeys none of it, and need not scroll for it.
fn assert_plain(text: &str, arguments: &[&OsStr]) {
    let hidden = |c: &char| *c != '\n' && (c.is_control() || !c.is_ascii() && UNSEEN.contains(*c));
    assert_eq!(text.chars().find(hidden), None, "{arguments:?}: {text:?}");
    let rows: usize = text.lines().map(|line| line.chars().count().div_ceil(80).max(1)).sum();
    assert!(rows <= 24, "{arguments:?}: {rows} rows: {text}");
}

#[test]
fn arguments_are_quoted_without_what_a_terminal_obeys() {
    let folder = Folder::new();
    let long = format!("{UNSEEN}{}", "x".repeat(100_000));
    let wide = "シ\u{202e}".repeat(20_000);
    for name in [UNSEEN, &long, &wide, "x\nerror:false"] {
        for line in [
            "@",
            "--@",
            "render @",
            "render --@ scene.toml",
            "render scene.toml @",
            "render scene.toml --width @",
            "render scene.toml --engine @",
            "render scene.toml --crop @",
            "render scene.toml --numerics @",
            "render scene.toml --memory-limit @",
            "render scene.toml --quiet=@",
            "render scene.toml -o @",
            "render scene.toml -o @/x.png",
            "render scene.toml -o @.gif",
            "render scene.toml -o x.png --stats @/x",
            "render @.json",
            "compare @ @",
            "compare @ scene.toml",
            "compare scene.toml scene.toml --diff @/x.png",
            "explain @",
            "explain scene.toml --pixel @",
            "generate @",
            "generate room -o @",
            "generate room -o @/x.toml",
            "study @",
            "study error @",
        ] {
            let line = line.replace('@', name);
            let arguments: Vec<&OsStr> = line.split(' ').map(OsStr::new).collect();
            let said = said(&folder, &arguments);
            assert_plain(&said, &arguments);
            assert!(said.starts_with("error: ") && !said.contains("\nerror:"), "{said}");
        }
    }
    assert_eq!(folder.contents().len(), 1, "nothing was written");
}

#[test]
fn names_of_files_that_are_there_are_as_plain() {
    let folder = Folder::new();
    let scene = format!("{UNSEEN}.toml");
    folder.write(&scene, SCENE);
    for line in [
        "render @.toml -o @.png",
        "render @.toml -o @.pfm --stats -",
        "compare @.png @.png",
        "compare @.png @.png --json",
        "compare @.png @.pfm",
        "render @.toml -o @.toml --format png",
        "explain @.toml --pixel 0,0",
        "explain @.toml --pixel 0,0 --html @.html",
        "generate room -o @-2.toml",
    ] {
        let line = line.replace('@', UNSEEN);
        let arguments: Vec<&OsStr> = line.split(' ').map(OsStr::new).collect();
        let text = said(&folder, &arguments);
        let seen = text.lines().any(|line| line.contains("[31m"));
        assert!(seen, "the name is said: {text}");
        // Documents are longer than a screen, as they are asked for.
        text.lines().for_each(|line| assert_plain(line, &arguments));
    }
    let line = format!("render {scene} -o - --format ppm --stats {UNSEEN}.json -q");
    let arguments = line.split(' ').map(OsStr::new);
    let ran = Command::new(CATOPTRIC).args(arguments).current_dir(folder.path(".")).output();
    assert!(ran.expect("the program runs").status.success());
    let stats: serde_json::Value =
        serde_json::from_slice(&folder.read(&format!("{UNSEEN}.json"))).expect("JSON");
    assert_eq!(stats["scene"], *scene, "an escape is read back as what it stands for");
}

#[test]
fn bad_scenes_are_quoted_without_what_a_terminal_obeys() {
    let folder = Folder::new();
    let above: String = UNSEEN.chars().filter(|c| !c.is_ascii()).collect();
    for part in [above.clone(), "x".repeat(200_000), format!("{above}シ").repeat(5_000)] {
        for (ending, text) in [
            ("toml", format!("camera.'{part}' = 1 # {part}")),
            ("toml", format!("image.transfer = '{part}' # {part}")),
            ("toml", format!("{part} {part}")),
            ("toml", format!("a = \u{1b}{part}")),
            ("toml", format!("[materials.'{part}']\ncolor = [1, 1, 1]\nreflekt = 1")),
            ("json", format!("{{\"{part}\": 1}}")),
            ("json", format!("{{\"image\": {{\"transfer\": \"{part}\"}}}}")),
            ("json", format!("{{\"image\": {part}}}")),
        ] {
            let name = format!("{}.{ending}", UNSEEN);
            folder.write(&name, text);
            for command in ["render", "explain", "study error"] {
                let mut arguments: Vec<&OsStr> = command.split(' ').map(OsStr::new).collect();
                arguments.push(OsStr::new(&name));
                let said = said(&folder, &arguments);
                assert_plain(&said, &arguments);
                assert!(said.starts_with("error: a\\u{1b}[31m"), "{said}");
            }
        }
    }
}
