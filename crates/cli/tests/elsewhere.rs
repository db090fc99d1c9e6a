//! What other ray tracers are known to get wrong, one test each.

use std::thread::sleep;
use std::time::Duration;

use crate::program::{ENGINES, Folder, SCENE};
use crate::refusals::{MIRROR_ROOM, refused};

/// One has a cap of 256, another fixes 5 when it is compiled, a third crashes past 10 000.
#[test]
fn depth_has_no_cap_below_the_memory() {
    let folder = Folder::with(MIRROR_ROOM);
    for depth in [6, 257, 10_001, 70_000] {
        for engine in ENGINES {
            let options = format!("-o {engine}.pfm --engine {engine} --max-depth {depth}");
            let stats = folder.done(&format!("render scene.toml {options} --stats -")).json();
            assert_eq!(stats["depths"].as_array().map(Vec::len), Some(depth + 1), "{engine}");
            assert_eq!(stats["depths"][depth]["rays"], 2, "{engine}");
        }
        assert_eq!(folder.read("packet.pfm"), folder.read("recursive.pfm"), "{depth}");
    }
}

/// Every u32 is legal: where paths end, at once; where they do not, a clear refusal.
#[test]
fn the_greatest_depth_ends() {
    let greatest = "--max-depth 4294967295";
    let workshop = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/workshop.toml");
    let closed = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes/closed-room.toml");
    let folder = Folder::new();
    for engine in ENGINES {
        let size = "--width 160 --height 120";
        let options = format!("-o {engine}.pfm --engine {engine} {greatest} --stats - {size}");
        let stats = folder.done(&format!("render {workshop} {options}")).json();
        assert_eq!(stats["max_depth"], u32::MAX);
        assert!(stats["depths"].as_array().is_some_and(|depths| depths.len() < 50), "{stats}");

        let room = format!("render {closed} -o out.png --engine {engine} {greatest}");
        let words = ["deep", "--max-depth"];
        let few = "--width 4 --height 3 --memory-limit 64MiB";
        refused(
            &folder,
            &format!("{room} {few}"),
            1,
            if engine == "packet" { &words } else { &["100000 reflections", "--engine packet"] },
        );
    }
    assert_eq!(folder.read("packet.pfm"), folder.read("recursive.pfm"));
}

#[test]
fn a_missing_scene_does_not_exit_0() {
    let folder = Folder::new();
    for scene in ["missing.toml", "missing.json", "missing/scene.toml", "scene.toml/scene.toml"] {
        refused(&folder, &format!("render {scene} -o out.png"), 3, &[scene, "cannot be read"]);
    }
}

#[test]
fn garbage_does_not_exit_0_with_a_picture() {
    let folder = Folder::new();
    let mut seed = 1_u64;
    for length in [1, 10, 100, 1000] {
        let noise = || {
            seed = seed.wrapping_mul(6_364_136_223_846_793_005).wrapping_add(1);
            (seed >> 56) as u8
        };
        let bytes: Vec<u8> = std::iter::repeat_with(noise).take(length).collect();
        let printable: Vec<u8> = bytes.iter().map(|byte| b' ' + 1 + byte % 94).collect();
        for (name, bytes) in [("bytes", bytes), ("letters", printable)] {
            for ending in ["toml", "json"] {
                let file = format!("{name}.{ending}");
                folder.write(&file, &bytes);
                refused(&folder, &format!("render {file} -o out.png"), 3, &[&file]);
            }
        }
    }
}

#[test]
fn an_unwritable_output_does_not_exit_0() {
    let folder = Folder::new();
    for output in ["missing/out.png", "scene.toml/out.png", "."] {
        let command = format!("render scene.toml -o {output} --format png");
        refused(&folder, &command, 4, &[output, "cannot be written"]);
    }
}

/// Files may not grow past some kilobytes, which fails a write as a full disk does.
#[test]
fn a_full_disk_does_not_exit_0() {
    let folder = Folder::new();
    folder.write("there.ppm", "kept");
    let before = folder.contents();
    for output in ["out.png", "out.ppm", "out.pfm", "there.ppm"] {
        let command = format!("catoptric render scene.toml --width 640 --height 480 -o {output}");
        let ran = folder.shell(&format!("trap '' XFSZ; ulimit -f 2; {command}"));
        assert_eq!(ran.code, Some(4), "{output}: {}", ran.stderr);
        assert!(ran.stderr.contains(&format!("{output} cannot be written")), "{}", ran.stderr);
        assert_eq!(folder.contents(), before, "{output}");
    }
}

#[test]
fn size_0x0_is_refused() {
    let folder = Folder::new();
    let zero = SCENE.replace("width = 13", "width = 0").replace("height = 7", "height = 0");
    folder.write("zero.toml", zero);
    refused(&folder, "render zero.toml -o out.png", 3, &["image.width", "found 0", "1 to 65535"]);
    refused(&folder, "render scene.toml --width 0 --height 0", 2, &["--width", "from 1 to 65535"]);
    refused(&folder, "render scene.toml --crop 0,0,0,0", 2, &["0,0,0,0", "at least 1"]);
}

/// Time stamps in PNG count seconds.
#[test]
fn equal_pixels_are_equal_files_at_different_times() {
    let folder = Folder::new();
    folder.done("render scene.toml -o early.png");
    sleep(Duration::from_millis(1100));
    folder.done("render scene.toml -o late.png --engine recursive");
    assert_eq!(folder.read("early.png"), folder.read("late.png"));
}

#[test]
fn bits_are_equal_over_instruction_sets() {
    let folder = Folder::new();
    let size = "--width 203 --height 101";
    for numerics in ["robust", "textbook"] {
        for isa in ["portable", "avx2"] {
            let command = format!("render scene.toml -o {isa}.pfm --numerics {numerics} {size}");
            let ran = folder.run_with(&command, "", &[("CATOPTRIC_ISA", isa)]);
            assert_eq!(ran.code, Some(0), "{}", ran.stderr);
        }
        assert_eq!(folder.read("portable.pfm"), folder.read("avx2.pfm"), "{numerics}");
    }
}
