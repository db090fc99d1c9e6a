//! `--memory-limit` is what it says: memory is refused before it is taken.
//!
//! The peak of a run is what the system reports of its process (`VmHWM`), asked for again and again
//! until it ends. That is Linux alone; elsewhere these tests say so and pass.

use std::fs;
use std::io::{Read as _, Seek as _};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::time::Duration;

use crate::program::{CATOPTRIC, Folder};

/// What a process may take beside its limit: the program itself, and each thread's scratch.
const BESIDE: u64 = 16_000_000;

/// Runs and gives the exit code, the peak in bytes and what was said.
fn watched(folder: &Folder, arguments: &str) -> (Option<i32>, u64, String) {
    let mut said = tempfile::tempfile().expect("a file for messages");
    let mut child = Command::new(CATOPTRIC)
        .args(arguments.split_whitespace())
        .current_dir(folder.path("."))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(said.try_clone().expect("the same file"))
        .spawn()
        .expect("the program runs");
    let status = format!("/proc/{}/status", child.id());
    let mut peak = 0;
    let code = loop {
        // A process that has ended, but was not waited for, has no memory: the last peak stays.
        let status = fs::read_to_string(&status).unwrap_or_default();
        let kib = status.lines().find_map(|line| line.strip_prefix("VmHWM:"));
        let kib = kib.and_then(|kib| kib.trim().trim_end_matches(" kB").parse::<u64>().ok());
        peak = kib.map_or(peak, |kib| peak.max(kib * 1024));
        if let Some(ended) = child.try_wait().expect("it can be waited for") {
            break ended.code();
        }
        std::thread::sleep(Duration::from_micros(300));
    };
    let mut message = String::new();
    said.rewind().expect("a file");
    said.read_to_string(&mut message).expect("text");
    (code, peak, message)
}

/// A text for each of the first numbers, one after another.
fn many(count: usize, each: impl Fn(usize) -> String) -> String {
    (0..count).fold(String::new(), |text, i| text + &each(i))
}

/// A wall of spheres, each of a material of its own.
fn spheres(count: usize) -> String {
    many(count, |i| {
        let (x, z, red) = (i % 500, i / 500 + 5, i as f64 / count as f64);
        format!("[[spheres]]\ncenter = [{x}, 0, -{z}]\nradius = 0.4\ncolor = [{red}, 1, 1]\n")
    })
}

/// Spheres that name their materials.
fn named(count: usize) -> String {
    many(count, |i| {
        let sphere = format!("center = [0, 0, -{i}.5]\nradius = 0.1\nmaterial = \"m{i}\"");
        format!("[[spheres]]\n{sphere}\n[materials.m{i}]\ncolor = [0.5, 0.5, 0.{i}]\n")
    })
}

fn list(count: usize, [before, after]: [&str; 2], entry: &str) -> String {
    let entries = vec![entry; count].join(",\n");
    format!("{before}{entries}{after}")
}

/// A scene whose rays go on for ever.
const ROOM: &str = "\
[camera]
position = [0, 0, 0]
look_at = [0, 0, -1]
[[lights]]
position = [0, 1, 0]
[[spheres]]
center = [0, 0, 0]
radius = 10
color = [1, 1, 1]
reflect = 1
";

/// The ending of the scene's name, its text, the limit in MB, further options, the exit code.
type Case = (&'static str, String, u64, &'static str, i32);

fn cases() -> Vec<Case> {
    let in_toml = "{ center = [0, 0, -9.5], radius = 1, color = [1, 1, 0.5] }";
    let in_json = r#"{"center": [0, 0, -9.5], "radius": 1, "color": [1, 1, 0.5]}"#;
    let toml_list = |count| list(count, ["spheres = [", "]\n"], in_toml);
    let json = |count| list(count, [r#"{"spheres": ["#, "]}"], in_json);
    let lamp = |i| format!("[[lights]]\nposition = [{i}, 9, {i}]\n");
    let nested = "[[1,1],[1,1]],".repeat(300_000);
    let long = "x".repeat(9_000_000);
    let small = "--width 8 --height 8";
    let deep = "--width 64 --height 64 --max-depth 4294967295";
    let large = "--width 2000 --height 2000 --max-depth 1 --threads 40";
    vec![
        ("toml", spheres(100_000), 30, small, 3),
        ("toml", spheres(100_000), 80, small, 0),
        ("toml", named(50_000), 12, small, 3),
        ("toml", named(50_000), 45, small, 0),
        ("toml", toml_list(100_000), 20, small, 3),
        ("toml", toml_list(100_000), 80, small, 0),
        ("json", json(100_000), 20, small, 3),
        ("json", json(100_000), 80, small, 0),
        // The text alone is more.
        ("toml", spheres(100_000), 4, small, 3),
        // Lights, and what lights and spheres make together.
        ("toml", many(100_000, lamp), 8, small, 3),
        ("toml", many(300, lamp) + &spheres(5_000), 40, small, 0),
        // No scene at all, but much of something.
        ("toml", format!("image = [{}]\n", "1,".repeat(1_000_000)), 30, small, 3),
        ("toml", format!("image = [{}]\n", "{a=1},".repeat(300_000)), 30, small, 3),
        ("toml", format!("{}[image]\n", "\n".repeat(3_000_000)), 30, small, 3),
        ("json", format!("{{\"image\": [{nested}1]}}"), 30, small, 3),
        ("json", format!("{{\"lights\": [{{\"position\": \"{long}\"}}]}}"), 20, small, 3),
        // Faults are looked for in the text once more.
        ("toml", spheres(100_000) + "[[spheres]]\nradius = 1\n", 60, small, 3),
        ("json", json(100_000).replace("]}", ",{\"radius\": 2}]}"), 60, small, 3),
        // Stacks that are copied as they grow, and pictures.
        ("toml", ROOM.to_owned(), 60, deep, 1),
        ("toml", ROOM.to_owned(), 40, large, 0),
    ]
}

#[test]
fn peaks_stay_within_the_limit() {
    if !Path::new("/proc/self/status").exists() {
        println!("skipped: no /proc/self/status here, so peaks of memory are not known");
        return;
    }
    let folder = Folder::new();
    for (case, (format, text, megabytes, options, code)) in cases().into_iter().enumerate() {
        let scene = format!("many.{format}");
        folder.write(&scene, &text);
        let arguments = format!("render {scene} -o out.png --memory-limit {megabytes}MB {options}");
        let (ended, peak, message) = watched(&folder, &arguments);
        let start: String = text.chars().take(40).collect();
        let said: String = message.chars().take(300).collect();
        let run = format!("case {case}, {arguments}, {} bytes of {start:?}: {said}", text.len());
        assert_eq!(ended, Some(code), "{run}");
        let most = megabytes * 1_000_000 + BESIDE;
        assert!(peak > 1_000_000 && peak <= most, "{peak} bytes, at most {most}: {run}");
    }
}

/// Whatever the system grants, the program ends by itself.
#[test]
fn memory_that_the_system_refuses_ends_no_program() {
    let folder = Folder::new();
    folder.write("many.toml", spheres(60_000));
    let entry = r#"{"center": [0, 0, -9.5], "radius": 1, "color": [1, 1, 0.5]}"#;
    folder.write("many.json", list(60_000, [r#"{"spheres": ["#, "]}"], entry));
    let mut codes = Vec::new();
    for scene in ["many.toml", "many.json"] {
        for mib in (24..100).step_by(4) {
            let render =
                format!("catoptric render {scene} -o out.png --width 8 --height 8 --threads 1");
            let ran = folder.shell(&format!("ulimit -v {}; {render}", mib * 1024));
            let message = &ran.stderr;
            let what = format!("{scene} in {mib} MiB: {:?} {message}", ran.code);
            assert!(matches!(ran.code, Some(0 | 3)), "{what}");
            let words = ["does not grant", "cannot be read"];
            assert!(ran.code != Some(3) || words.iter().any(|w| message.contains(w)), "{what}");
            codes.push(ran.code);
        }
    }
    assert!(codes.contains(&Some(0)) && codes.contains(&Some(3)), "{codes:?}");
}

/// A new memory cgroup, removed at the end.
struct Cgroup(PathBuf);

impl Cgroup {
    /// One with that limit in bytes, or why none can be made here.
    fn new(bytes: u64) -> Result<Self, String> {
        let first = Path::new("/sys/fs/cgroup/memory");
        let (root, limit) = if first.is_dir() {
            (first, "memory.limit_in_bytes")
        } else {
            (Path::new("/sys/fs/cgroup"), "memory.max")
        };
        let group = Self(root.join(format!("memory-test-{}", std::process::id())));
        let refused = |path: &Path, error| format!("{}: {error}", path.display());
        fs::create_dir(&group.0).map_err(|error| refused(&group.0, error))?;
        let limit = group.0.join(limit);
        fs::write(&limit, bytes.to_string()).map_err(|error| refused(&limit, error))?;
        Ok(group)
    }
}

impl Drop for Cgroup {
    fn drop(&mut self) {
        let _ = fs::remove_dir(&self.0);
    }
}

#[test]
fn a_cgroup_a_little_above_the_limit_kills_nothing() {
    let folder = Folder::new();
    for (format, text, megabytes, options, code) in cases() {
        let group = match Cgroup::new(megabytes * 1_000_000 + BESIDE) {
            Ok(group) => group,
            Err(why) => {
                println!("skipped: no memory cgroup can be made here: {why}");
                return;
            }
        };
        let scene = format!("many.{format}");
        folder.write(&scene, &text);
        let enter = format!("echo $$ > {}/cgroup.procs || exit 99", group.0.display());
        let render = format!("render {scene} -o out.png --memory-limit {megabytes}MB {options}");
        // Not `exec`: the shell is in the group too, and tells by which signal a run was ended.
        let ran = folder.shell(&format!("{enter}; catoptric {render}"));
        if ran.code == Some(99) {
            println!("skipped: no process can be put in a memory cgroup here: {}", ran.stderr);
            return;
        }
        // A picture that would not fit in what the group leaves is refused, with advice.
        let refused = ran.code == Some(3) && ran.stderr.contains("memory cgroup");
        assert!(ran.code == Some(code) || refused, "{render}: {:?}: {}", ran.code, ran.stderr);
    }
}
