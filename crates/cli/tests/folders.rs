//! The folder of a study: what is read, replaced and removed there, and what is not.

use std::process::Command;

use crate::program::Folder;

const STUDY: &str = "catoptric study depth scene.toml --depths 1 --repeat 1 --threads 1";

fn pipe(folder: &Folder, name: &str) {
    let made = Command::new("mkfifo").arg(folder.path(name)).status();
    assert!(made.is_ok_and(|made| made.success()), "{name}");
}

#[test]
fn pipes_are_not_opened() {
    let folder = Folder::new();
    std::fs::create_dir(folder.path("out")).expect("a folder");
    for name in ["out/x.json", "out/notes.md"] {
        pipe(&folder, name);
    }
    let ran = folder.shell(&format!("timeout -s KILL 60 {STUDY} -o out -q"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(folder.path("out/depth.json").is_file());

    // One under the name of a file of the study is refused before anything is measured.
    for name in ["depth.json", "error.json", "index.html", "depth.csv", "depth-scene-ray.svg"] {
        std::fs::remove_dir_all(folder.path("out")).expect("the folder");
        std::fs::create_dir(folder.path("out")).expect("a folder");
        pipe(&folder, &format!("out/{name}"));
        let ran = folder.shell(&format!("timeout -s KILL 60 {STUDY} -o out"));
        // Of another study's name there is no report, and nothing is in the way.
        let code = if name == "error.json" { 0 } else { 4 };
        assert_eq!(ran.code, Some(code), "{name}: {}", ran.stderr);
        if code == 4 {
            assert!(ran.stderr.contains(name), "{}", ran.stderr);
            assert!(ran.stderr.contains("no regular file"), "{}", ran.stderr);
            assert!(!ran.stderr.contains("timing"), "{name}: {}", ran.stderr);
        }
    }
}

/// Anybody can write a list. What it lists is removed only if it is as the program wrote it.
#[test]
fn nothing_is_removed_that_was_not_surely_made() {
    let folder = Folder::new();
    folder.done("generate room --width 4 --height 4 -o room.toml");
    std::fs::create_dir(folder.path("out")).expect("a folder");
    folder.write("out/thesis.md", "years");
    folder.write("out/photo.png", "holidays");
    let lists = [
        r#"{"schema": "catoptric-study", "version": 2, "study": "depth",
            "files": ["thesis.md", "photo.png"]}"#,
        r#"{"schema": "catoptric-study", "version": 2, "study": "depth",
            "files": ["thesis.md", "photo.png"],
            "sums": [{"file": "thesis.md", "bytes": 5, "fnv1a_64": "0000000000000000"},
                     {"file": "photo.png", "bytes": 7, "fnv1a_64": "0000000000000000"}]}"#,
        r#"{"schema": "catoptric-study", "study": "depth", "sums": [{"file": "thesis.md"}]}"#,
    ];
    for list in lists {
        folder.write("out/depth.json", list);
        folder.write("out/mine.json", list);
        let ran = folder.shell(&format!("{STUDY} -o out"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        assert_eq!(folder.read("out/thesis.md"), b"years", "{list}");
        assert_eq!(folder.read("out/photo.png"), b"holidays", "{list}");
        assert_eq!(folder.read("out/mine.json"), list.as_bytes());
    }

    // Of a true report: what somebody has worked on since, or put in its place.
    let both = STUDY.replace("scene.toml", "scene.toml room.toml");
    assert_eq!(folder.shell(&format!("{both} -o out -q")).code, Some(0));
    let svg = |plot: &str| format!("out/depth-room-{plot}.svg");
    let edited = String::from_utf8(folder.read(&svg("time"))).expect("text") + "<!-- mine -->";
    folder.write(&svg("time"), &edited);
    std::fs::rename(folder.path(&svg("ray")), folder.path("elsewhere.svg")).expect("a move");
    std::os::unix::fs::symlink("../elsewhere.svg", folder.path(&svg("ray"))).expect("a link");
    assert!(folder.path(&svg("rays")).exists());
    let ran = folder.shell(&format!("{STUDY} -o out"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(!folder.path(&svg("rays")).exists(), "as it was written, and written no more");
    assert_eq!(folder.read(&svg("time")), edited.as_bytes());
    assert!(folder.path("elsewhere.svg").exists() && folder.path(&svg("ray")).is_symlink());
    for plot in ["time", "ray"] {
        assert!(ran.stderr.contains(&format!("{} is an earlier", svg(plot))), "{}", ran.stderr);
    }
}
