//! Interruptions: exit code 130, and nothing left behind.

use std::io::{BufRead, BufReader, Write};
use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::program::{CATOPTRIC, Folder};

/// Starts a rendering.
pub(crate) fn start(folder: &Folder, arguments: &str) -> Child {
    Command::new(CATOPTRIC)
        .args(arguments.split_whitespace())
        .current_dir(folder.path("."))
        .stdout(Stdio::null())
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts")
}

/// Waits until the program handles signals, which its own status tells.
fn wait_for_handler(child: &Child) {
    wait_until("signals are handled", || handles(child, "TERM") == Some(true));
}

/// Whether a process handles a signal, as far as its status can be read.
fn handles(child: &Child, signal: &str) -> Option<bool> {
    let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
    is_in_mask(&status, "SigCgt:", signal)
}

/// Whether a line of a process's status has a signal in its mask.
fn is_in_mask(status: &str, line: &str, signal: &str) -> Option<bool> {
    let number = match signal {
        "HUP" => 1,
        "INT" => 2,
        "TERM" => 15,
        "XFSZ" => 25,
        _ => panic!("{signal}"),
    };
    let mask = status.lines().find_map(|text| text.strip_prefix(line))?;
    let mask = u64::from_str_radix(mask.trim(), 16).ok()?;
    Some(mask >> (number - 1) & 1 == 1)
}

/// Whether whoever runs the tests ignores a signal, which then ends nothing that they start.
fn is_ignored_here(signal: &str) -> bool {
    let status = std::fs::read_to_string("/proc/self/status").unwrap_or_default();
    is_in_mask(&status, "SigIgn:", signal) == Some(true)
}

fn send(child: &Child, signal: &str) {
    let id = child.id().to_string();
    let sent = Command::new("kill").args([&format!("-{signal}"), &id]).status();
    assert!(sent.is_ok_and(|sent| sent.success()), "kill -{signal}");
}

pub(crate) fn wait_until(what: &str, mut reached: impl FnMut() -> bool) {
    let start = Instant::now();
    while !reached() {
        assert!(start.elapsed() < Duration::from_secs(60), "waited in vain until {what}");
        sleep(Duration::from_millis(5));
    }
}

/// Sends a signal and expects exit code 130 within a minute.
pub(crate) fn interrupt(mut child: Child, signal: &str) {
    let signal = if is_ignored_here(signal) { "TERM" } else { signal };
    send(&child, signal);
    let mut ended = None;
    wait_until("the program ends", || {
        ended = child.try_wait().expect("a status");
        ended.is_some()
    });
    let ended = ended.expect("it has ended");
    assert_eq!((ended.code(), ended.signal()), (Some(130), None), "{signal}");
}

#[test]
fn a_long_rendering_leaves_nothing() {
    for signal in ["INT", "TERM", "HUP"] {
        let folder = Folder::new();
        folder.write("there.png", "kept");
        let before = folder.contents();
        // Hours, if nothing interrupts it.
        let size = "--width 4000 --height 4000 --samples 256 --engine recursive";
        for output in ["new.png", "there.png"] {
            let child =
                start(&folder, &format!("render scene.toml -o {output} --stats s.json {size}"));
            wait_for_handler(&child);
            sleep(Duration::from_millis(50));
            interrupt(child, signal);
            assert_eq!(folder.contents(), before, "{signal}, {output}");
        }
    }
}

/// A signal that whoever starts the program ignores stays so, as for `nohup` and for what a shell
/// starts in the background; the others are handled all the same.
#[test]
fn a_signal_that_the_caller_ignores_stays_ignored() {
    let folder = Folder::new();
    folder.write("there.png", "kept");
    let before = folder.contents();
    for (ignored, signal) in [("INT", "TERM"), ("TERM", "INT"), ("HUP", "INT"), ("TERM HUP", "INT")]
    {
        if is_ignored_here(signal) {
            println!("skipped: {signal} is ignored by whoever runs this");
            continue;
        }
        for command in [
            "render scene.toml -o there.png --width 4000 --height 4000 --samples 256",
            "study depth scene.toml --depths 1 --repeat 1000000 --json -q",
        ] {
            let child = Command::new("sh")
                .args(["-c", &format!("trap '' {ignored}; exec {CATOPTRIC} {command}")])
                .current_dir(folder.path("."))
                .stdout(Stdio::null())
                .stderr(Stdio::null())
                .spawn()
                .expect("the program starts");
            wait_until("signals are handled", || handles(&child, signal) == Some(true));
            for name in ignored.split(' ') {
                assert_eq!(handles(&child, name), Some(false), "{name}");
                send(&child, name);
            }
            sleep(Duration::from_millis(100));
            // The one that is not ignored finds it running, and ends it as ever.
            interrupt(child, signal);
        }
        assert_eq!(folder.contents(), before, "{ignored}");
    }
}

#[test]
fn a_rendering_goes_on_where_all_signals_are_ignored() {
    let folder = Folder::new();
    // Waits for its reader, so that the signals come before the end.
    let fifo = folder.path("fifo");
    assert!(Command::new("mkfifo").arg(&fifo).status().is_ok_and(|made| made.success()));
    let run = format!("trap '' INT TERM HUP; exec {CATOPTRIC} render scene.toml -q -o fifo");
    let mut child = Command::new("sh")
        .args(["-c", &format!("{run} --format ppm")])
        .current_dir(folder.path("."))
        .spawn()
        .expect("the program starts");
    // SIGXFSZ is handled at the same time as the others would be.
    wait_until("signals are handled", || handles(&child, "XFSZ") == Some(true));
    for signal in ["INT", "TERM", "HUP"] {
        send(&child, signal);
    }
    sleep(Duration::from_millis(100));
    let picture = std::fs::read(fifo).expect("a picture");
    assert!(picture.starts_with(b"P6"));
    assert_eq!(child.wait().expect("a status").code(), Some(0));
}

#[test]
fn a_long_explanation_is_given_up() {
    let folder = Folder::new();
    // Minutes, if nothing interrupts it.
    folder.done("generate room --reflect 1 --width 2000 --height 2000 --max-depth 9999 -o r.toml");
    let before = folder.contents();
    for asked in ["explain r.toml", "explain r.toml --pixel 0,0 --html page.html"] {
        let child = start(&folder, asked);
        wait_for_handler(&child);
        sleep(Duration::from_millis(100));
        interrupt(child, "INT");
        assert_eq!(folder.contents(), before, "{asked}");
    }
}

#[test]
fn what_is_written_but_not_in_place_is_removed() {
    let folder = Folder::new();
    let fifo = folder.path("fifo");
    assert!(Command::new("mkfifo").arg(&fifo).status().is_ok_and(|made| made.success()));
    let before = folder.contents();
    // The picture is complete beside its name while the statistics wait for a reader.
    let child = start(&folder, "render scene.toml -o out.png --stats fifo --engine recursive");
    wait_until("the picture is written beside", || {
        let unfinished = |(name, bytes): (&String, &Vec<u8>)| {
            name.contains("unfinished") && bytes.ends_with(b"IEND\xae\x42\x60\x82")
        };
        folder.contents().iter().any(unfinished)
    });
    assert!(!folder.path("out.png").exists(), "in place before all is written");
    interrupt(child, "TERM");
    assert_eq!(folder.contents(), before);
}

#[test]
fn a_scene_that_waits_for_its_reader_is_given_up() {
    let folder = Folder::new();
    let fifo = folder.path("fifo");
    assert!(Command::new("mkfifo").arg(&fifo).status().is_ok_and(|made| made.success()));
    let before = folder.contents();
    let child = start(&folder, "generate room -o fifo --format toml");
    wait_for_handler(&child);
    interrupt(child, "TERM");
    assert_eq!(folder.contents(), before);
}

#[test]
fn a_study_keeps_what_it_has_measured() {
    for (study, rows_are) in [("depth --depths 1,2", 2 * 4), ("error", 75)] {
        let folder = Folder::new();
        // Hours, if nothing interrupts it.
        let asked = format!("study {study} scene.toml --repeat 1000000 -o out");
        let mut child = Command::new(CATOPTRIC)
            .args(asked.split_whitespace())
            .current_dir(folder.path("."))
            .stdout(Stdio::null())
            .stderr(Stdio::piped())
            .spawn()
            .expect("the program starts");
        let stderr = BufReader::new(child.stderr.take().expect("a pipe"));
        let timing = |line: std::io::Result<String>| line.expect("text").contains("timing");
        assert!(stderr.lines().any(timing), "{study}");
        sleep(Duration::from_millis(300));
        interrupt(child, "INT");
        let name = study.split_whitespace().next().expect("a name");
        let json: serde_json::Value =
            serde_json::from_slice(&folder.read(&format!("out/{name}.json"))).expect("JSON");
        assert_eq!(json["complete"], false);
        let rows = json["rows"].as_array().expect("rows");
        assert!(rows.len() >= rows_are, "{study}: {}", rows.len());
        assert!(rows.iter().all(|row| row["runs"].as_u64() < Some(1_000_000)));
        assert!(rows.iter().any(|row| row["min_ms"].as_f64().is_some()));
        assert!(folder.read("out/index.html").windows(11).any(|w| w == b"Interrupted"));
    }
}

/// Of a study that is still preparing, what is kept has a time, and the end is not far.
#[test]
fn a_study_is_interrupted_while_it_prepares() {
    let folder = Folder::new();
    // Minutes, if nothing interrupts it.
    folder.done("generate room --width 400 --height 400 -o room.toml");
    let child = start(&folder, "study error room.toml -o out");
    wait_for_handler(&child);
    sleep(Duration::from_millis(1500));
    let begun = Instant::now();
    interrupt(child, "INT");
    assert!(begun.elapsed() < Duration::from_secs(3), "{:?}", begun.elapsed());
    let json: serde_json::Value =
        serde_json::from_slice(&folder.read("out/error.json")).expect("JSON");
    assert_eq!(json["complete"], false);
    for row in json["rows"].as_array().expect("rows") {
        assert!(row["min_ms"].as_f64().is_some(), "{row}");
    }
}

/// Nothing is measured yet that could be kept, so the first signal ends it.
#[test]
fn a_study_that_waits_for_its_scene_ends() {
    for signal in ["TERM", "INT"] {
        let folder = Folder::new();
        let made = Command::new("mkfifo").arg(folder.path("fifo")).status();
        assert!(made.is_ok_and(|made| made.success()));
        let before = folder.contents();
        let child = start(&folder, "study depth fifo -o out");
        wait_for_handler(&child);
        interrupt(child, signal);
        assert_eq!(folder.contents(), before);
    }
}

/// Nor is it while a report waits for whoever reads it.
#[test]
fn a_study_that_waits_for_its_reader_ends() {
    let folder = Folder::new();
    let (reader, mut writer) = std::io::pipe().expect("a pipe");
    // Most of what it holds.
    writer.write_all(&[b' '; 60 << 10]).expect("room");
    let mut child = Command::new(CATOPTRIC)
        .args("study depth scene.toml --repeat 1 --json -o out".split_whitespace())
        .current_dir(folder.path("."))
        .stdout(writer)
        .stderr(Stdio::null())
        .spawn()
        .expect("the program starts");
    wait_until("the folder is written", || {
        assert_eq!(child.try_wait().expect("a status"), None, "the report is too short");
        folder.path("out/depth.json").exists()
    });
    sleep(Duration::from_millis(100));
    interrupt(child, "TERM");
    drop(reader);
}
