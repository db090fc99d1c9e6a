//! Interruptions: exit code 130, and nothing left behind.

use std::os::unix::process::ExitStatusExt;
use std::process::{Child, Command, Stdio};
use std::thread::sleep;
use std::time::{Duration, Instant};

use crate::program::{CATOPTRIC, Folder};

/// Starts a rendering.
fn start(folder: &Folder, arguments: &str) -> Child {
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
    let caught = || {
        let status = std::fs::read_to_string(format!("/proc/{}/status", child.id())).ok()?;
        let mask = status.lines().find_map(|line| line.strip_prefix("SigCgt:"))?;
        // SIGTERM is 15.
        u64::from_str_radix(mask.trim(), 16).ok().map(|mask| mask >> 14 & 1 == 1)
    };
    wait_until("signals are handled", || caught() == Some(true));
}

fn wait_until(what: &str, mut reached: impl FnMut() -> bool) {
    let start = Instant::now();
    while !reached() {
        assert!(start.elapsed() < Duration::from_secs(60), "waited in vain until {what}");
        sleep(Duration::from_millis(5));
    }
}

/// Sends a signal and expects exit code 130 within a minute.
fn interrupt(mut child: Child, signal: &str) {
    let id = child.id().to_string();
    let sent = Command::new("kill").args([&format!("-{signal}"), &id]).status();
    assert!(sent.is_ok_and(|sent| sent.success()), "kill -{signal}");
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
