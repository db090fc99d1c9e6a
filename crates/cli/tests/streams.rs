//! Files that the caller opened: the standard streams, and others by their number.

use std::fs;
use std::os::unix::fs::symlink;

use crate::program::Folder;

const PPM: &str = "catoptric render scene.toml --engine recursive --format ppm -q";

/// Hours, if it is not refused before.
const SLOW: &str = "--width 4000 --height 4000 --samples 256";

/// Runs a line of shell, expects code 4, a message with all of `parts`, and an unchanged folder.
fn refused(folder: &Folder, line: &str, parts: &[&str]) {
    let before = folder.contents();
    let ran = folder.shell(&format!("exec timeout 60 {line}"));
    assert_eq!(ran.code, Some(4), "{line}: {}", ran.stderr);
    for part in parts {
        assert!(ran.stderr.contains(part), "{line}: {part:?} is not in {}", ran.stderr);
    }
    assert!(!ran.stderr.contains("panicked"), "{}", ran.stderr);
    assert_eq!(folder.contents(), before, "{line} changed the folder");
}

#[test]
fn a_stdout_that_cannot_be_written_is_4() {
    let folder = Folder::new();
    folder.done("render scene.toml -o a.png --engine recursive");
    let everything = [
        "--help",
        "--version",
        "help",
        "help render",
        "render --help",
        "compare -h",
        "explain --help",
        "study --help",
        "study depth --help",
        "generate room --help",
        "render scene.toml -o - --format png",
        "render scene.toml -o - --format ppm --engine recursive",
        "render scene.toml -o - --format pfm",
        "render scene.toml -o /dev/stdout --format ppm",
        "render scene.toml -o /dev/fd/1 --format ppm",
        "render scene.toml -o b.png --stats -",
        "compare a.png a.png",
        "compare a.png a.png --json",
        "compare a.png a.png --diff d.png",
        "explain scene.toml",
        "explain scene.toml --json",
        "explain scene.toml --pixel 1,1",
        "explain scene.toml --pixel 1,1 --html -",
        "explain scene.toml --pixel 1,1 --html b.html --json",
        "study depth scene.toml --depths 1 --repeat 1",
        "study depth scene.toml --depths 1 --repeat 1 --json",
        "study depth scene.toml --depths 1 --repeat 1 --json -o new",
        "generate room -o - --format toml",
    ];
    for arguments in everything {
        for redirected in [">&-", "1</dev/null"] {
            let line = format!("catoptric {arguments} {redirected}");
            refused(&folder, &line, &["cannot be written: it is closed, or open for reading"]);
        }
    }
    refused(&folder, &format!("{PPM} -o - {SLOW} >&-"), &["closed"]);
    refused(&folder, &format!("{PPM} -o /dev/stderr {SLOW} 2</dev/null"), &[]);
    refused(&folder, &format!("{PPM} -o /dev/stderr {SLOW} 2>&-"), &[]);
}

/// Only what is written needs a place. What then gets the number of stdout is not written to.
#[test]
fn a_closed_stdout_that_nothing_goes_to_does_not_matter() {
    let folder = Folder::new();
    for (arguments, file) in [
        ("render scene.toml --engine recursive -o", "a.png"),
        ("generate room -o", "a.toml"),
        ("explain scene.toml --pixel 1,1 --html", "a.html"),
    ] {
        folder.done(&format!("{arguments} {file}"));
        let expected = folder.read(file);
        for closed in [">&-", "<&- >&-", "<&- >&- 2>&-", "1</dev/null"] {
            fs::remove_file(folder.path(file)).expect("the file");
            let ran = folder.shell(&format!("catoptric {arguments} {file} {closed}"));
            assert_eq!(ran.code, Some(0), "{arguments} {closed}: {}", ran.stderr);
            // The recipe in a scene's head names the file.
            assert_eq!(folder.read(file), expected, "{arguments} {closed}");
        }
    }
    let ran = folder.shell("catoptric study depth scene.toml --depths 1 --repeat 1 -o new >&-");
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    assert!(folder.path("new/index.html").exists());
}

/// Programs that start others open it for reading too, and nothing is wrong with that.
#[test]
fn output_may_be_thrown_away() {
    let folder = Folder::new();
    for redirected in [">/dev/null", "1<>/dev/null", ">>/dev/null"] {
        for arguments in ["--help", "render scene.toml -o - --format ppm"] {
            let ran = folder.shell(&format!("catoptric {arguments} {redirected}"));
            assert_eq!(ran.code, Some(0), "{arguments} {redirected}: {}", ran.stderr);
        }
    }
}

/// A file that the caller opened is gone on with, whatever name leads to it.
#[test]
fn an_open_file_is_written_where_the_caller_is_in_it() {
    let folder = Folder::new();
    folder.done("render scene.toml -o file.ppm --engine recursive");
    let picture = folder.read("file.ppm");
    symlink("/dev/stdout", folder.path("out.ppm")).expect("a link");
    symlink("out.ppm", folder.path("link.ppm")).expect("a link");
    symlink("/dev", folder.path("devices")).expect("a link");
    symlink("/proc/self/fd/3", folder.path("three.ppm")).expect("a link");
    let names = [
        ("-", 1),
        ("/dev/stdout", 1),
        ("/dev/fd/1", 1),
        ("/proc/self/fd/1", 1),
        ("/proc/thread-self/fd/1", 1),
        ("out.ppm", 1),
        ("link.ppm", 1),
        ("devices/stdout", 1),
        ("devices/fd/1", 1),
        ("/dev/fd/3", 3),
        ("/proc/self/fd/3", 3),
        ("devices/fd/3", 3),
        ("three.ppm", 3),
        ("/dev/stderr", 2),
    ];
    let framed = |picture: &[u8]| [b"head\n", picture, b"tail\n"].concat();
    for (name, number) in names {
        for opened in [">", ">>"] {
            let line = format!(
                "rm -f log; {{ echo head >&{number}; {PPM} -o {name} && echo tail >&{number}; }} \
                 {number}{opened}log"
            );
            let ran = folder.shell(&line);
            assert_eq!(ran.code, Some(0), "{line}: {}", ran.stderr);
            assert_eq!(folder.read("log"), framed(&picture), "{line}");
        }
        let line = format!("echo head > log; {PPM} -o {name} {number}>>log");
        assert_eq!(folder.shell(&line).code, Some(0), "{line}");
        assert_eq!(folder.read("log"), [b"head\n", &*picture].concat(), "{line}");
    }
    for link in ["out.ppm", "link.ppm", "three.ppm"] {
        assert!(folder.path(link).is_symlink(), "{link} was replaced");
    }
    let piped = folder.shell(&format!("{PPM} -o /dev/fd/3 3>&1 | cat"));
    assert_eq!(piped.stdout, picture);
    let both = folder.run("render scene.toml -o - --format ppm --stats /dev/fd/1");
    assert_eq!(both.code, Some(2), "{}", both.stderr);
}

#[test]
fn an_open_file_that_cannot_be_written_is_refused_before_tracing() {
    let folder = Folder::new();
    folder.write("kept", "kept");
    symlink("/dev/fd/3", folder.path("three.ppm")).expect("a link");
    for name in ["/dev/fd/3", "three.ppm"] {
        refused(&folder, &format!("{PPM} -o {name} {SLOW}"), &["number 3"]);
        refused(&folder, &format!("{PPM} -o {name} {SLOW} 3<kept"), &["reading only"]);
    }
    refused(&folder, &format!("{PPM} -o /dev/stdin {SLOW} <kept"), &["reading only"]);
    // Those that the program itself has open, for signals, are nobody's to write to.
    let closed: String = (3..10).map(|number| format!(" {number}<&-")).collect();
    for number in 3..10 {
        refused(&folder, &format!("{PPM} -o /dev/fd/{number} {SLOW}{closed}"), &["was opened"]);
    }
    // Of another process, the place in the file is not known.
    let run = format!("exec 7>&-; exec timeout 60 {PPM} -o /proc/$$/fd/7 {SLOW}");
    let ran = folder.shell(&format!("exec 7<>kept; ({run}); exit $?"));
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    assert!(ran.stderr.contains("another process"), "{}", ran.stderr);
    assert_eq!(folder.read("kept"), b"kept");
}
