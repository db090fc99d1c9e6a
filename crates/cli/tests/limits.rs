//! What the system does not grant: a clear end, and nothing left.

use crate::program::Folder;

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

#[test]
fn stacks_of_threads_that_cannot_be_had_are_1() {
    let folder = Folder::new();
    let threads = "-o out.png --engine recursive --threads 64";
    cramped(&folder, 1_000_000, threads, 1, &["64 threads cannot be had", "lower --threads"]);
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
