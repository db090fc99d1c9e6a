//! What the system does not grant: a clear end, and nothing left.

use crate::program::{Folder, Ran};

/// Runs with that much address space, in KiB, and expects that code and an unchanged folder.
fn cramped(folder: &Folder, space: u32, options: &str, code: i32, parts: &[&str]) {
    let before = folder.contents();
    let ran = folder.shell(&format!("ulimit -v {space}; catoptric render scene.toml {options}"));
    assert_eq!(ran.code, Some(code), "{options}: {}", ran.stderr);
    for part in parts {
        assert!(ran.stderr.contains(part), "{part:?} is not in {}", ran.stderr);
    }
    assert_eq!(folder.contents(), before, "{options}");
}

/// Refused before it is taken: taking it would end the program by a signal.
#[test]
fn too_large_a_picture_is_3() {
    let folder = Folder::new();
    let largest = "-o out.png --width 65535 --height 65535";
    cramped(&folder, 1_000_000, largest, 3, &["the limit is 2 GiB", "--memory-limit", "--crop"]);
    let granted = format!("{largest} --memory-limit 1000GiB");
    cramped(&folder, 1_000_000, &granted, 3, &["the system does not grant", "--crop"]);
}

/// The advice is to be followed: each part of it, in turn, gives the picture.
#[test]
fn stacks_of_threads_that_cannot_be_had_are_1() {
    let folder = Folder::new();
    let render = "-o out.png --engine recursive";
    let many = format!("{render} --threads 64");
    let says = ["64 threads cannot be had", "256 MiB of address space", "976.6 MiB in all"];
    cramped(&folder, 1_000_000, &many, 1, &[&says[..], &["lower --threads to 1,"]].concat());
    folder.granted(1_000_000, &format!("{render} --threads 1"));
    folder.granted(1_000_000, "-o out.png --engine packet --threads 1");

    for (space, threads) in [(100_000, 1), (30_000, 1), (400_000, 2), (3_000_000, 64)] {
        let asked = format!("{render} --threads {threads}");
        let before = folder.contents();
        let ran = folder.limited(&format!("-v {space}"), &asked);
        assert_eq!(ran.code, Some(1), "{}", ran.stderr);
        assert!(ran.stderr.contains("`ulimit -v` allows"), "{}", ran.stderr);
        assert_eq!(folder.contents(), before);
        let number = |before: &str| -> Option<u32> {
            let (_, rest) = ran.stderr.split_once(before)?;
            rest.split(|c: char| !c.is_ascii_digit()).next()?.parse().ok()
        };
        let enough = number("raise that to ").expect("what is enough");
        folder.granted(enough, &asked);
        match number("lower --threads to ") {
            Some(fewer) => folder.granted(space, &format!("{render} --threads {fewer}")),
            None => assert!(space < 900_000, "{}", ran.stderr),
        }
        folder.granted(space, "-o out.png --engine packet --threads 1");
    }
    // Only the recursion in f32 has an engine that stands for it.
    let exact = format!("{render} --precision f64 --threads 1");
    let ran = folder.limited("-v 100000", &exact);
    assert!(ran.stderr.contains("ulimit -v") && !ran.stderr.contains("packet"), "{}", ran.stderr);
}

impl Folder {
    /// Renders with a limit of the shell's.
    fn limited(&self, limit: &str, options: &str) -> Ran {
        self.shell(&format!("ulimit {limit} && catoptric render scene.toml {options}"))
    }

    /// Renders with that much address space, in KiB, and expects a picture.
    fn granted(&self, space: u32, options: &str) {
        let ran = self.limited(&format!("-v {space}"), options);
        assert_eq!(ran.code, Some(0), "{space} {options}: {}", ran.stderr);
    }
}

/// The first thread's stack is the caller's to limit, and is not what anything depends on.
#[test]
fn a_small_stack_gives_the_same() {
    let folder = Folder::new();
    // As deep as the parser of JSON goes.
    folder.write("deep.json", format!("{{\"a\": {}", "[".repeat(120)));
    for engine in crate::program::ENGINES {
        folder.done(&format!("render scene.toml -o {engine}.pfm --engine {engine}"));
        for (stack, threads) in [(64, 1), (64, 2), (32, 1), (256, 1)] {
            let asked = format!("-o small.pfm --engine {engine} --threads {threads} -q");
            let ran = folder.limited(&format!("-s {stack}"), &asked);
            assert_eq!((ran.code, &*ran.stderr), (Some(0), ""), "{stack} KiB, {engine}");
            assert_eq!(folder.read("small.pfm"), folder.read(&format!("{engine}.pfm")));
        }
    }
    for (command, code) in [
        ("render missing.toml", 3),
        ("render deep.json", 3),
        ("frobnicate", 2),
        ("--help", 0),
        ("compare packet.pfm recursive.pfm", 0),
        ("explain scene.toml --pixel 3,3", 0),
        ("generate room -o room.toml", 0),
    ] {
        let plain = folder.shell(&format!("catoptric {command}"));
        let ran = folder.shell(&format!("ulimit -s 64 && catoptric {command}"));
        assert_eq!(plain.code, Some(code), "{command}: {}", plain.stderr);
        assert_eq!(ran.code, Some(code), "{command}: {}", ran.stderr);
        assert_eq!((ran.stdout, ran.stderr), (plain.stdout, plain.stderr), "{command}");
    }
}

/// The system ends by SIGXFSZ whoever does not handle it, leaving what was written.
#[test]
fn a_file_larger_than_the_caller_allows_is_4() {
    let folder = Folder::new();
    folder.write("there.ppm", "kept");
    let before = folder.contents();
    for output in ["out.ppm", "there.ppm"] {
        let large = format!("-o {output} --width 400 --height 400");
        for ignored in ["", "trap '' XFSZ; "] {
            let ran = folder.shell(&format!(
                "{ignored}ulimit -c 0; ulimit -f 1; catoptric render scene.toml {large}"
            ));
            assert_eq!(ran.code, Some(4), "{output}: {}", ran.stderr);
            assert!(ran.stderr.contains("File too large"), "{}", ran.stderr);
            assert_eq!(folder.contents(), before, "{output}");
        }
    }
    for command in [
        "generate lattice --edge 20 -o out.toml",
        "explain scene.toml --pixel 6,3 --html out.html",
        "study error scene.toml --repeat 1 -q -o .",
        // The last, since the shell leaves what it has opened.
        "explain scene.toml --pixel 6,3 --json > out.json",
    ] {
        let ran = folder.shell(&format!("ulimit -c 0; ulimit -f 1; catoptric {command}"));
        assert_eq!(ran.code, Some(4), "{command}: {}", ran.stderr);
        if !command.contains('>') {
            assert_eq!(folder.contents(), before, "{command}");
        }
    }
}

#[test]
fn more_threads_than_rows_or_processors_give_the_same_picture() {
    let folder = Folder::new();
    for engine in crate::program::ENGINES {
        folder.done(&format!("render scene.toml -o one.pfm --engine {engine} --threads 1"));
        folder.done(&format!("render scene.toml -o many.pfm --engine {engine} --threads 200"));
        assert_eq!(folder.read("one.pfm"), folder.read("many.pfm"), "{engine}");
    }
}
