//! What becomes of a file that is there, and of what a killed run leaves.

use std::fs;
use std::io::Write;
use std::os::unix::fs::{MetadataExt, PermissionsExt, symlink};
use std::process::{Command, Stdio};

use crate::program::{CATOPTRIC, Folder, Ran};
use crate::signals::{interrupt, start, wait_until};

const RENDER: &str = "catoptric render scene.toml --engine recursive";

/// Hours, if it is not refused before.
const SLOW: &str = "--width 4000 --height 4000 --samples 256";

/// Whether a test that needs root can run; said where it cannot.
fn is_root() -> bool {
    let root = fs::metadata("/proc/self").is_ok_and(|found| found.uid() == 0);
    if !root {
        let required = std::env::var_os("CATOPTRIC_REQUIRE_TOOLS").is_some();
        assert!(!required, "this must be run by root here");
        let _ = std::io::stderr().write_all(b"skipped a test of outputs that needs root\n");
    }
    root
}

/// Runs a line of shell with a copy of the program that everybody may run, as nobody.
fn as_nobody(folder: &Folder, line: &str) -> Ran {
    fs::copy(CATOPTRIC, folder.path("program")).expect("a copy");
    let line = line.replace("catoptric ", "./program ");
    let ran = folder
        .shell(&format!("exec setpriv --reuid=65534 --regid=65534 --clear-groups sh -c '{line}'"));
    fs::remove_file(folder.path("program")).expect("the copy");
    ran
}

/// Runs a line of shell with mounts of its own.
fn with_mounts(folder: &Folder, line: &str) -> Ran {
    folder.shell(&format!("exec unshare --mount sh -ec '{line}'"))
}

fn set_mode(folder: &Folder, name: &str, mode: u32) {
    fs::set_permissions(folder.path(name), fs::Permissions::from_mode(mode)).expect("a mode");
}

fn of(folder: &Folder, name: &str) -> (u32, u32, u32) {
    let found = fs::metadata(folder.path(name)).expect(name);
    (found.mode() & 0o7777, found.uid(), found.gid())
}

fn is_png(bytes: &[u8]) -> bool {
    bytes.starts_with(b"\x89PNG") && bytes.ends_with(b"IEND\xae\x42\x60\x82")
}

#[test]
fn a_file_that_is_replaced_keeps_its_mode() {
    let folder = Folder::new();
    symlink("s.json", folder.path("link.json")).expect("a link");
    for mode in [0o600, 0o640, 0o666, 0o755, 0o200] {
        for umask in ["022", "077"] {
            for name in ["a.png", "s.json", "room.toml"] {
                folder.write(name, "old");
                set_mode(&folder, name, mode);
            }
            let ran = folder.shell(&format!(
                "umask {umask}; {RENDER} -o a.png --stats link.json && \
                 catoptric generate room -o room.toml"
            ));
            assert_eq!(ran.code, Some(0), "{}", ran.stderr);
            for name in ["a.png", "s.json", "room.toml"] {
                assert_eq!(of(&folder, name).0, mode, "{name} under umask {umask}");
                set_mode(&folder, name, 0o600);
                assert!(folder.read(name).len() > 3, "{name} is as before");
            }
        }
    }
}

#[test]
fn a_file_that_root_replaces_keeps_its_owner() {
    if !is_root() {
        return;
    }
    let folder = Folder::new();
    folder.write("a.png", "old");
    set_mode(&folder, "a.png", 0o640);
    std::os::unix::fs::chown(folder.path("a.png"), Some(65534), Some(12)).expect("an owner");
    assert_eq!(folder.shell(&format!("{RENDER} -o a.png")).code, Some(0));
    assert_eq!(of(&folder, "a.png"), (0o640, 65534, 12));
    assert!(is_png(&folder.read("a.png")));
}

/// What only the old group could do, the new one cannot.
#[test]
fn a_group_that_cannot_be_kept_gets_no_more_than_everybody() {
    if !is_root() {
        return;
    }
    let folder = Folder::new();
    set_mode(&folder, ".", 0o777);
    for (before, after) in [(0o664, 0o644), (0o660, 0o600), (0o666, 0o666)] {
        folder.write("a.png", "old");
        set_mode(&folder, "a.png", before);
        std::os::unix::fs::chown(folder.path("a.png"), Some(0), Some(0)).expect("an owner");
        let ran = as_nobody(&folder, &format!("{RENDER} -o a.png"));
        assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        assert_eq!(of(&folder, "a.png"), (after, 65534, 65534));
        fs::remove_file(folder.path("a.png")).expect("the picture");
    }
}

#[test]
fn another_s_file_in_a_sticky_folder_is_written_in_place_or_refused() {
    if !is_root() {
        return;
    }
    let folder = Folder::new();
    set_mode(&folder, ".", 0o1777);
    folder.write("a.png", "old");
    folder.write("kept.png", "old");
    set_mode(&folder, "a.png", 0o666);
    let node = fs::metadata(folder.path("a.png")).expect("the file").ino();

    let ran = as_nobody(&folder, &format!("{RENDER} -o a.png"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stderr.contains("a.png (written in place: it is another user's"), "{}", ran.stderr);
    assert!(is_png(&folder.read("a.png")));
    assert_eq!(fs::metadata(folder.path("a.png")).expect("the file").ino(), node);

    let before = folder.contents();
    let ran = as_nobody(&folder, &format!("exec timeout 60 {RENDER} -o kept.png {SLOW}"));
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    assert!(ran.stderr.contains("another user"), "{}", ran.stderr);
    assert_eq!(folder.contents(), before);

    // Root may replace it, and does.
    assert_eq!(folder.shell(&format!("{RENDER} -o a.png")).code, Some(0));
    assert_ne!(fs::metadata(folder.path("a.png")).expect("the file").ino(), node);
}

#[test]
fn a_file_that_is_mounted_by_itself_is_written_in_place() {
    if !is_root() {
        return;
    }
    let folder = Folder::new();
    folder.write("real.png", vec![b'x'; 1 << 20]);
    folder.write("mounted.png", "");
    let mount = "mount --bind real.png mounted.png";
    let ran = with_mounts(&folder, &format!("{mount}; {RENDER} -o mounted.png"));
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(ran.stderr.contains("mounted.png (written in place: it is mounted"), "{}", ran.stderr);
    assert!(is_png(&folder.read("real.png")), "all of it, and nothing of the old");
    assert_eq!(folder.read("mounted.png"), b"");
    assert_eq!(folder.contents().len(), 3, "{:?}", folder.contents().keys());

    // One that cannot be opened either is refused before tracing.
    let before = folder.contents();
    let ran = with_mounts(
        &folder,
        &format!(
            "{mount}; mount -o remount,bind,ro mounted.png; timeout 60 {RENDER} -o mounted.png {SLOW}"
        ),
    );
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    assert!(ran.stderr.contains("mounted by itself"), "{}", ran.stderr);
    assert_eq!(folder.contents(), before);

    // The scene under another name is the scene.
    let ran = with_mounts(
        &folder,
        "mount --bind scene.toml mounted.png; catoptric render scene.toml -o mounted.png",
    );
    assert_eq!(ran.code, Some(2), "{}", ran.stderr);
    assert!(ran.stderr.contains("is the scene itself"), "{}", ran.stderr);
    assert_eq!(folder.contents(), before);
}

/// Of two files, the second may fail when the first is in place already.
#[test]
fn what_was_kept_and_what_was_not_is_said() {
    if !is_root() {
        return;
    }
    let folder = Folder::new();
    fs::create_dir(folder.path("small")).expect("a folder");
    folder.write("mounted", "");
    folder.write("old.json", "old");
    // A file on a disk with that much left, which can only be written in place.
    let with_left = |kilobytes: u32, arguments: &str| {
        let size = 4 + kilobytes;
        let disk = format!("mount -t tmpfs -o size={size}k none small");
        let fill = "dd if=/dev/zero of=small/full bs=4k count=1 status=none";
        let file = "touch small/file; mount --bind small/file mounted";
        let run = format!("code=0; {RENDER} {arguments} || code=$?; cp small/file after");
        with_mounts(&folder, &format!("{disk}; {fill}; {file}; {run}; exit $code"))
    };
    let ran = with_left(0, "-o picture.png --stats mounted");
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    for words in ["mounted cannot be written", "is empty now", "written and kept: picture.png"] {
        assert!(ran.stderr.contains(words), "{words}: {}", ran.stderr);
    }
    assert!(is_png(&folder.read("picture.png")));

    let large = "--format ppm --width 100 --height 100";
    let ran = with_left(4, &format!("-o mounted {large} --stats old.json"));
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    let words = "given up, and as before: old.json";
    assert!(ran.stderr.contains(words), "{}", ran.stderr);
    assert_eq!(folder.read("old.json"), b"old");
    assert_eq!(folder.read("after"), b"", "half written");
    assert_eq!(unfinished(&folder), [""; 0]);
}

#[test]
fn a_file_that_nothing_can_change_is_refused_before_tracing() {
    let folder = Folder::new();
    folder.write("fixed.png", "old");
    fs::create_dir(folder.path("growing")).expect("a folder");
    let set = |how: &str| {
        let line = format!("chattr {how}i fixed.png && chattr {how}a growing");
        folder.shell(&line).code == Some(0)
    };
    // File systems without such attributes, and users who may not set them.
    if !set("+") {
        set("-");
        let _ = std::io::stderr().write_all(b"skipped a test that needs chattr\n");
        return;
    }
    let runs = ["fixed.png", "growing/new.png"]
        .map(|name| (name, folder.shell(&format!("timeout 60 {RENDER} -o {name} {SLOW}"))));
    let left = fs::read_dir(folder.path("growing")).expect("the folder").count();
    assert!(set("-"));
    for (name, ran) in runs {
        assert_eq!(ran.code, Some(4), "{name}: {}", ran.stderr);
        assert!(ran.stderr.contains("immutable"), "{name}: {}", ran.stderr);
    }
    assert_eq!(left, 0, "a file that cannot be removed");
}

/// A run that waits, its picture complete beside its name; killed, it leaves that.
fn waiting(folder: &Folder, output: &str) -> std::process::Child {
    let there = unfinished(folder).len();
    let arguments = format!("render scene.toml -o {output} --stats fifo --engine recursive");
    let child = start(folder, &arguments);
    let complete = || {
        let complete =
            |(name, bytes): (&String, &Vec<u8>)| name.ends_with(".unfinished") && is_png(bytes);
        folder.contents().iter().filter(|file| complete(*file)).count()
    };
    wait_until("the picture is written beside", || complete() > there);
    child
}

fn unfinished(folder: &Folder) -> Vec<String> {
    let names = folder.contents().into_keys();
    names.filter(|name| name.ends_with(".unfinished")).collect()
}

#[test]
fn what_a_killed_run_left_is_removed_by_the_next_to_the_same_name() {
    let folder = Folder::new();
    let made = Command::new("mkfifo").arg(folder.path("fifo")).stdout(Stdio::null()).status();
    assert!(made.is_ok_and(|made| made.success()));
    let long = format!("{}.png", "x".repeat(251));
    for output in ["a.png", &*long] {
        let mut killed = waiting(&folder, output);
        killed.kill().expect("SIGKILL");
        killed.wait().expect("an end");
        let left = unfinished(&folder);
        assert_eq!(left.len(), 1, "{left:?}");

        // A run to another name leaves it, since that may be anybody's.
        folder.done("render scene.toml -o other.png --engine recursive");
        assert_eq!(unfinished(&folder), left);
        // So does one that is refused before; one that is not, removes it.
        folder.done(&format!("render scene.toml -o {output} --engine recursive"));
        assert_eq!(unfinished(&folder), [""; 0]);
        assert!(is_png(&folder.read(output)));
        fs::remove_file(folder.path(output)).expect("the picture");
    }
}

#[test]
fn what_a_run_that_lives_has_unfinished_is_left_alone() {
    let folder = Folder::new();
    let made = Command::new("mkfifo").arg(folder.path("fifo")).stdout(Stdio::null()).status();
    assert!(made.is_ok_and(|made| made.success()));
    let before = folder.contents();
    let one = waiting(&folder, "a.png");
    let ones = unfinished(&folder);
    let other = waiting(&folder, "a.png");
    folder.done("render scene.toml -o a.png --engine recursive");
    assert_eq!(unfinished(&folder).len(), 2);
    assert!(unfinished(&folder).contains(&ones[0]));
    fs::remove_file(folder.path("a.png")).expect("the picture");
    interrupt(one, "TERM");
    interrupt(other, "TERM");
    assert_eq!(folder.contents(), before);

    // Nor is anything that has such a name and is no file.
    let name = &ones[0];
    fs::create_dir(folder.path(name)).expect("a folder");
    let link = name.replace(".unfinished", "x.unfinished");
    symlink("scene.toml", folder.path(&link)).expect("a link");
    let pipe = name.replace(".unfinished", "y.unfinished");
    let made = Command::new("mkfifo").arg(folder.path(&pipe)).status();
    assert!(made.is_ok_and(|made| made.success()));
    folder.done("render scene.toml -o a.png --engine recursive");
    assert_eq!(unfinished(&folder).len(), 3);
    assert!(folder.path("scene.toml").exists());
}
