//! Where bytes go, and what is there when they cannot.

use std::fs;
use std::io::Read;
use std::os::unix::fs::{FileTypeExt, PermissionsExt, symlink};
use std::process::{Command, Stdio};

use crate::program::{CATOPTRIC, Folder};

const RENDER: &str = "render scene.toml --engine recursive";

/// Runs, expects code 4, a message with all of `parts`, and an unchanged folder.
fn not_written(folder: &Folder, arguments: &str, parts: &[&str]) {
    let before = folder.contents();
    let ran = folder.run(arguments);
    assert_eq!(ran.code, Some(4), "{arguments}: {}", ran.stderr);
    for part in parts {
        assert!(ran.stderr.contains(part), "{arguments}: {part:?} is not in {}", ran.stderr);
    }
    assert!(!ran.stderr.contains("panicked"), "{}", ran.stderr);
    assert_eq!(folder.contents(), before, "{arguments} changed the folder");
}

#[test]
fn places_that_cannot_be_written_are_4() {
    let folder = Folder::new();
    folder.write("file", "kept");
    fs::create_dir(folder.path("folder.png")).expect("a folder");
    folder.write("protected.png", "kept");
    let read_only = fs::Permissions::from_mode(0o444);
    fs::set_permissions(folder.path("protected.png"), read_only).expect("permissions");
    symlink("missing/picture.png", folder.path("dangling.png")).expect("a link");
    symlink("loop.png", folder.path("loop.png")).expect("a link");
    let long = format!("{}.png", "x".repeat(300));
    let cases: &[(&str, &[&str])] = &[
        ("missing/out.png", &["missing/out.png", "make it first"]),
        ("file/out.png", &["file/out.png", "is a file"]),
        ("folder.png", &["folder.png", "is a folder"]),
        ("new.png/", &["new.png/", "folder"]),
        ("protected.png", &["protected.png", "write-protected"]),
        ("dangling.png", &["dangling.png", "missing"]),
        ("loop.png", &["loop.png"]),
        (&long, &["xxx.png"]),
        ("/proc/out.png", &["/proc/out.png"]),
    ];
    for (output, parts) in cases {
        not_written(&folder, &format!("{RENDER} -o {output}"), parts);
        // The picture is given up too if its statistics cannot be written.
        not_written(&folder, &format!("{RENDER} -o good.png --stats {output}"), parts);
    }
}

#[test]
fn what_fails_is_found_before_tracing() {
    // Rendering this would take hours.
    let folder = Folder::new();
    let slow = "--width 4000 --height 4000 --samples 256";
    not_written(&folder, &format!("{RENDER} -o missing/out.png {slow}"), &["missing"]);
    not_written(
        &folder,
        &format!("{RENDER} -o out.png --stats missing/out.json {slow}"),
        &["missing"],
    );
    not_written(&folder, &format!("{RENDER} -o /proc/out.png {slow}"), &["/proc"]);
}

#[test]
fn a_full_device_is_4() {
    let folder = Folder::new();
    for format in ["png", "ppm", "pfm"] {
        let full = format!("{RENDER} -o /dev/full --format {format}");
        not_written(&folder, &full, &["/dev/full", "space"]);
    }
    // Statistics are written before anything is put in place.
    not_written(&folder, &format!("{RENDER} -o good.png --stats /dev/full"), &["/dev/full"]);
    let compared = folder.done(&format!("{RENDER} -o a.png"));
    assert!(compared.stdout.is_empty());
    not_written(&folder, "compare a.png a.png --diff /dev/full", &["/dev/full"]);
}

/// Runs with stdout as given and expects code 4 and an unchanged folder.
fn stdout_fails(folder: &Folder, arguments: &str, stdout: Stdio) {
    let before = folder.contents();
    let output = Command::new(CATOPTRIC)
        .args(arguments.split_whitespace())
        .current_dir(folder.path("."))
        .stdout(stdout)
        .stderr(Stdio::piped())
        .output()
        .expect("the program runs");
    let stderr = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(4), "{arguments}: {stderr}");
    assert!(!stderr.contains("panicked"), "{stderr}");
    assert_eq!(folder.contents(), before, "{arguments} changed the folder");
}

#[test]
fn a_closed_pipe_and_a_full_stdout_are_4() {
    let folder = Folder::new();
    folder.done(&format!("{RENDER} -o a.png"));
    let everything = [
        "render scene.toml -o - --format png --engine recursive",
        "render scene.toml -o - --format ppm --engine recursive",
        "render scene.toml -o - --format pfm --engine recursive",
        "render scene.toml -o good.png --stats - --engine recursive",
        "compare a.png a.png",
        "compare a.png a.png --json",
        "compare a.png a.png --diff d.png",
        "--help",
        "render --help",
        "--version",
    ];
    for arguments in everything {
        let (reader, writer) = std::io::pipe().expect("a pipe");
        drop(reader);
        stdout_fails(&folder, arguments, writer.into());
        let full = fs::OpenOptions::new().write(true).open("/dev/full").expect("/dev/full");
        stdout_fails(&folder, arguments, full.into());
    }
}

#[test]
fn a_new_file_has_the_permissions_of_any_new_file() {
    let folder = Folder::new();
    for (umask, mode) in [("022", 0o644), ("077", 0o600), ("002", 0o664)] {
        let script =
            format!("umask {umask}; {CATOPTRIC} {RENDER} -o {umask}.png --stats {umask}.json");
        let status = Command::new("sh")
            .args(["-c", &script])
            .current_dir(folder.path("."))
            .stderr(Stdio::null())
            .status();
        assert!(status.is_ok_and(|status| status.success()));
        for ending in ["png", "json"] {
            let file = folder.path(&format!("{umask}.{ending}"));
            let found = fs::metadata(file).expect("the file").permissions().mode();
            assert_eq!(found & 0o777, mode, "{ending} under umask {umask}");
        }
    }
}

#[test]
fn a_file_that_is_there_is_replaced_as_a_whole() {
    let folder = Folder::new();
    folder.write("out.png", vec![b'x'; 1 << 20]);
    fs::hard_link(folder.path("out.png"), folder.path("other.png")).expect("a hard link");
    folder.done(&format!("{RENDER} -o out.png"));
    folder.done(&format!("{RENDER} -o fresh.png"));
    assert_eq!(folder.read("out.png"), folder.read("fresh.png"));
    // Renamed, not written over: whoever has the old file open keeps it.
    assert_eq!(folder.read("other.png").len(), 1 << 20);
}

#[test]
fn links_are_followed_and_kept() {
    let folder = Folder::new();
    fs::create_dir(folder.path("real")).expect("a folder");
    folder.write("real/there.png", "old");
    symlink("real/there.png", folder.path("a.png")).expect("a link");
    symlink("real/new.png", folder.path("b.png")).expect("a link to nothing yet");
    for (link, file) in [("a.png", "real/there.png"), ("b.png", "real/new.png")] {
        folder.done(&format!("{RENDER} -o {link}"));
        assert!(folder.path(link).is_symlink(), "{link}");
        assert!(!folder.path(file).is_symlink(), "{file}");
        assert!(folder.read(file).starts_with(b"\x89PNG"), "{file}");
    }
}

#[test]
fn a_pipe_with_a_name_is_written_directly() {
    let folder = Folder::new();
    let fifo = folder.path("fifo.ppm");
    assert!(Command::new("mkfifo").arg(&fifo).status().is_ok_and(|made| made.success()));
    let reader = std::thread::spawn({
        let fifo = fifo.clone();
        move || {
            let mut bytes = Vec::new();
            fs::File::open(fifo).and_then(|mut file| file.read_to_end(&mut bytes)).map(|_| bytes)
        }
    });
    folder.done(&format!("{RENDER} -o fifo.ppm"));
    folder.done(&format!("{RENDER} -o file.ppm"));
    let bytes = reader.join().expect("the reader").expect("bytes");
    assert_eq!(bytes, folder.read("file.ppm"));
    assert!(fs::metadata(&fifo).is_ok_and(|found| found.file_type().is_fifo()));
}

#[test]
fn an_open_file_by_number_is_written_directly() {
    let folder = Folder::new();
    folder.done(&format!("{RENDER} -o file.ppm"));
    let script = format!("{CATOPTRIC} {RENDER} -o /dev/fd/3 --format ppm 3> number.ppm");
    let run = Command::new("sh")
        .args(["-c", &script])
        .current_dir(folder.path("."))
        .stderr(Stdio::null())
        .status();
    assert!(run.is_ok_and(|status| status.success()));
    assert_eq!(folder.read("number.ppm"), folder.read("file.ppm"));
}

#[test]
fn quiet_is_silent_and_progress_can_be_forced() {
    let folder = Folder::new();
    assert_eq!(folder.done(&format!("{RENDER} --quiet")).stderr, "");
    assert_eq!(folder.done(&format!("{RENDER} -q --progress always")).stderr, "");
    let plain = folder.done(RENDER).stderr;
    assert!(plain.starts_with("scene.png: 13x7"), "{plain}");
    assert_eq!(plain.lines().count(), 1, "{plain}");
    assert!(!plain.contains('%'), "auto shows a bar without a terminal: {plain}");
    let large = "--width 300 --height 300 --samples 2";
    let shown = folder.done(&format!("{RENDER} {large} --progress always")).stderr;
    assert!(shown.contains('%'), "{shown}");
    let hidden = folder.done(&format!("{RENDER} {large} --progress never")).stderr;
    assert!(!hidden.contains('%'), "{hidden}");
}
