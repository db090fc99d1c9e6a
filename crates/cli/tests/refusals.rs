//! What is refused: the exit code, a message that helps, and nothing done.

use crate::program::{Folder, SCENE};

/// Runs, expects that code, one message with all of `parts`, no output and no change.
pub(crate) fn refused(folder: &Folder, arguments: &str, code: i32, parts: &[&str]) {
    refused_with(folder, arguments, "", &[], code, parts);
}

fn refused_with(
    folder: &Folder,
    arguments: &str,
    stdin: &str,
    env: &[(&str, &str)],
    code: i32,
    parts: &[&str],
) {
    let before = folder.contents();
    let ran = folder.run_with(arguments, stdin, env);
    assert_eq!(ran.code, Some(code), "{arguments}: {}", ran.stderr);
    assert!(ran.stderr.starts_with("error: "), "{arguments}: {}", ran.stderr);
    assert!(!ran.stderr.contains("panicked"), "{arguments}: {}", ran.stderr);
    for part in parts {
        assert!(ran.stderr.contains(part), "{arguments}: {part:?} is not in {}", ran.stderr);
    }
    assert!(ran.stdout.is_empty(), "{arguments} wrote to stdout");
    assert_eq!(folder.contents(), before, "{arguments} changed the folder");
}

#[test]
fn wrong_use_is_2() {
    let folder = Folder::new();
    let cases: &[(&str, &[&str])] = &[
        ("render", &["SCENE"]),
        ("frobnicate", &["frobnicate"]),
        ("render scene.toml --frobnicate", &["--frobnicate"]),
        ("render scene.toml -o -", &["-o -", "--format"]),
        ("render scene.toml -o /dev/stdout", &["--format"]),
        ("render scene.toml -o picture.gif", &["picture.gif", ".png", ".ppm", ".pfm", "--format"]),
        ("render scene.toml -o picture", &["picture", "--format"]),
        ("render scene.toml --format gif", &["gif", "png", "ppm", "pfm"]),
        ("render scene.toml --engine gpu", &["gpu", "packet", "recursive"]),
        ("render scene.toml --precision f16 --engine recursive", &["f16", "f32", "f64", "dd"]),
        ("render scene.toml --precision f64", &["f64", "--engine recursive"]),
        ("render scene.toml --precision dd --engine packet", &["dd", "--engine recursive"]),
        ("render scene.toml --numerics exact", &["exact", "robust", "textbook"]),
        ("render scene.toml --transfer gamma", &["--transfer", "gamma", "linear and srgb"]),
        ("compare a b --tolerance 256", &["--tolerance", "256", "from 0 to 255"]),
        ("compare a b --tolerance -1", &["--tolerance", "-1", "from 0 to 255"]),
        ("compare a b --allow -1", &["--allow", "-1", "whole number of pixels"]),
        ("compare a b --allow 101%", &["--allow", "101%", "from 0% to 100%"]),
        ("compare a b --memory-limit 0", &["--memory-limit", "above 0", "GiB"]),
        ("render scene.toml --width 0", &["--width", "0", "from 1 to 65535"]),
        ("render scene.toml --width 65536", &["--width", "65536", "from 1 to 65535"]),
        ("render scene.toml --height 0", &["--height", "from 1 to 65535"]),
        ("render scene.toml --height -1", &["--height", "-1", "from 1 to 65535"]),
        ("render scene.toml --height 65536", &["--height", "from 1 to 65535"]),
        ("render scene.toml --max-depth 4294967296", &["--max-depth", "4294967295"]),
        ("render scene.toml --max-depth -1", &["--max-depth", "-1", "4294967295"]),
        (
            "render scene.toml --min-weight -0.5",
            &["--min-weight", "-0.5", "from 0 to 3.4028234e38"],
        ),
        ("render scene.toml --min-weight NaN", &["--min-weight", "NaN", "from 0 to"]),
        ("render scene.toml --min-weight 1e39", &["--min-weight", "1e39", "the largest of f32"]),
        ("render scene.toml --samples 0", &["--samples", "from 1 to 256"]),
        ("render scene.toml --samples 257", &["--samples", "257", "from 1 to 256"]),
        ("render scene.toml --threads 0", &["--threads", "0", "from 1 to 1024"]),
        ("render scene.toml --threads 1025", &["--threads", "1025", "from 1 to 1024"]),
        ("render scene.toml --threads 99999999999", &["--threads", "from 1 to 1024"]),
        ("render scene.toml --threads two", &["--threads", "two", "from 1 to 1024"]),
        ("render scene.toml --max-depth 1.5", &["--max-depth", "1.5", "whole number from 0 to"]),
        ("render scene.toml --crop 4294967296,0,1,1", &["--crop", "4294967296", "X,Y,W,H"]),
        ("render scene.toml --crop 13,0,1,1", &["13,0,1,1", "13x7", "X + W <= 13"]),
        ("render scene.toml --threads -2", &["--threads", "-2", "from 1 to 1024"]),
        ("render scene.toml --memory-limit 0", &["--memory-limit", "above 0", "GiB"]),
        ("render scene.toml --memory-limit 2T", &["--memory-limit", "2T", "GiB"]),
        ("render scene.toml --memory-limit -1", &["--memory-limit", "-1"]),
        ("render scene.toml --crop 1,2,3", &["--crop", "1,2,3", "X,Y,W,H"]),
        ("render scene.toml --crop -1,0,3,3", &["--crop", "-1,0,3,3", "X,Y,W,H"]),
        ("render scene.toml --crop 0,0,0,1", &["0,0,0,1", "13x7"]),
        ("render scene.toml --crop 12,0,2,1", &["12,0,2,1", "13x7"]),
        ("render scene.toml --crop 4294967295,0,4294967295,1", &["4294967295", "13x7"]),
        ("render scene.toml --progress sometimes", &["sometimes", "auto", "always", "never"]),
        ("render scene.toml -o - --format png --stats -", &["--stats", "-"]),
        ("render scene.toml -o x.png --stats x.png", &["--stats", "x.png"]),
        ("render scene.toml -o x.png --stats ./x.png", &["--stats", "x.png"]),
        ("render scene.toml -o scene.toml --format png", &["scene.toml", "the scene itself"]),
        ("render scene.toml --stats ./scene.toml", &["scene.toml", "the scene itself"]),
        ("compare", &["<A>", "<B>"]),
        ("compare a.png", &["<B>"]),
        ("compare - -", &["stdin"]),
        ("compare a.png b.png --diff -", &["--diff"]),
    ];
    for (arguments, parts) in cases {
        refused(&folder, arguments, 2, parts);
    }
}

#[test]
fn an_empty_name_is_2() {
    let folder = Folder::new();
    refused(&folder, "render scene.toml --output= --format png", 2, &["--output"]);
    refused(&folder, "render scene.toml --stats=", 2, &["--stats"]);
    refused(&folder, "compare a.png b.png --diff=", 2, &["--diff"]);
}

#[test]
fn an_unknown_instruction_set_is_2() {
    let folder = Folder::new();
    for engine in ["packet", "recursive"] {
        let arguments = format!("render scene.toml --engine {engine}");
        let env = [("CATOPTRIC_ISA", "avx9")];
        refused_with(
            &folder,
            &arguments,
            "",
            &env,
            2,
            &["CATOPTRIC_ISA", "avx9", "portable", "avx2"],
        );
    }
    // Names are exact; an empty value is as good as none.
    let upper = [("CATOPTRIC_ISA", "AVX2")];
    refused_with(&folder, "render scene.toml", "", &upper, 2, &["AVX2"]);
    for known in ["portable", "avx2", ""] {
        let ran = folder.run_with("render scene.toml", "", &[("CATOPTRIC_ISA", known)]);
        assert_eq!(ran.code, Some(0), "{known:?}: {}", ran.stderr);
    }
}

#[test]
fn a_bad_scene_is_3() {
    let folder = Folder::new();
    folder.write("empty.toml", "");
    folder.write("syntax.toml", "[image\nwidth = 3\n");
    folder.write("key.toml", SCENE.replace("fov", "fow"));
    folder.write("radius.toml", SCENE.replace("radius = 1", "radius = -1"));
    folder.write("size.toml", SCENE.replace("width = 13", "width = 65536"));
    folder.write("syntax.json", "{ \"image\": ");
    folder.write("binary.toml", [0xff, 0xfe, 0x00]);
    let cases: &[(&str, &[&str])] = &[
        ("missing.toml", &["missing.toml", "No such file"]),
        (".", &["directory"]),
        ("empty.toml", &["empty.toml"]),
        ("syntax.toml", &["syntax.toml"]),
        ("key.toml", &["key.toml", "camera.fow"]),
        ("radius.toml", &["radius.toml", "spheres[0].radius", "-1"]),
        ("size.toml", &["size.toml", "image.width", "65536"]),
        ("syntax.json", &["syntax.json"]),
        ("binary.toml", &["binary.toml"]),
    ];
    for (scene, parts) in cases {
        refused(&folder, &format!("render {scene} -o out.png"), 3, parts);
    }
    refused_with(&folder, "render - -o out.png", "", &[], 3, &["<stdin>"]);
    refused_with(&folder, "render - -o out.png", "{ \"x\": 1 }", &[], 3, &["<stdin>", "x"]);
}

#[test]
fn more_memory_than_the_limit_is_3_before_it_is_taken() {
    let folder = Folder::new();
    let largest = "render scene.toml -o out.png --width 65535 --height 65535";
    refused(&folder, largest, 3, &["65535x65535", "2 GiB", "--memory-limit", "--crop"]);
    refused(&folder, "render scene.toml --memory-limit 100", 3, &["--memory-limit"]);

    // Bytes a pixel: for PFM the film in f32, for the others the levels, with the recursion
    // also the film; for PNG the compressed picture.
    let cases = [
        ("png", "recursive", 12 + 3),
        ("ppm", "recursive", 12 + 3),
        ("pfm", "recursive", 12),
        ("png", "packet", 3 + 4),
        ("ppm", "packet", 3),
        ("pfm", "packet", 12),
    ];
    for (format, engine, bytes) in cases {
        // The message says how much is enough: to the byte.
        let arguments =
            format!("render scene.toml -o out.{format} --width 800 --height 600 --engine {engine}");
        let ran = folder.run(&format!("{arguments} --memory-limit 1MB"));
        let need = ran.stderr.split(['(', ' ']).zip(ran.stderr.split(['(', ' ']).skip(1));
        let need = need.filter(|(_, unit)| unit.starts_with("bytes")).map(|(number, _)| number);
        let need: u64 = need.last().and_then(|n| n.parse().ok()).expect("a number of bytes");
        // Then rows, grid and scene.
        let pixels = 800 * 600 * bytes;
        assert!((pixels..pixels + (1 << 20)).contains(&need), "{format} {engine}: {need}");
        refused(&folder, &format!("{arguments} --memory-limit {}", need - 1), 3, &["800x600"]);
        folder.done(&format!("{arguments} --memory-limit {need}"));
    }
    // A crop takes only what it shows.
    folder.done(&format!("{largest} --crop 32000,32000,20,10 --engine recursive"));
}

/// Inside a perfect mirror every path goes on for ever.
pub(crate) const MIRROR_ROOM: &str = r#"
[image]
width = 2
height = 1
[render]
max_depth = 200000
[[spheres]]
center = [0.1, 0.2, 0]
radius = 5
color = [1, 1, 1]
reflect = 1
"#;

#[test]
fn a_path_too_deep_for_the_recursion_is_1() {
    let folder = Folder::with(MIRROR_ROOM);
    let deep = "render scene.toml -o out.png --engine recursive";
    for precision in ["f32", "f64"] {
        let arguments = format!("{deep} --precision {precision}");
        refused(&folder, &arguments, 1, &["100000 ", "lower", "packet"]);
    }
    // The first such path ends it; all paths of this size would take hours.
    refused(&folder, &format!("{deep} --width 1000 --height 1000"), 1, &["100000 "]);
    folder.done(&format!("{deep} --max-depth 100000"));
    folder.done(&format!("{deep} --max-depth 100000 --precision f64"));
    // The packet engine's stacks grow as far as the memory limit lets them.
    let packet = "render scene.toml -o out.png --engine packet --max-depth 2000000";
    refused(&folder, &format!("{packet} --memory-limit 1MiB"), 1, &["--memory-limit", "bytes"]);
    folder.done(&format!("{packet} --memory-limit 2GiB"));
    // Nor is it an error to allow what no path reaches.
    let shallow = Folder::new();
    shallow.done("render scene.toml --engine recursive --max-depth 4294967295");
}

#[test]
fn help_and_version_are_0_and_nothing_asked_is_2() {
    let folder = Folder::new();
    for arguments in ["--help", "-h", "--version", "help", "render --help", "compare -h"] {
        let ran = folder.done(arguments);
        assert!(!ran.stdout.is_empty() && ran.stderr.is_empty(), "{arguments}");
    }
    assert!(folder.done("--version").text().starts_with("catoptric 0."));
    let ran = folder.run("");
    assert_eq!((ran.code, ran.stdout.len()), (Some(2), 0));
    assert!(ran.stderr.contains("Usage: catoptric"), "{}", ran.stderr);
}

#[test]
fn every_option_of_the_contract_is_in_the_help() {
    let folder = Folder::new();
    let help = folder.done("render --help").text().to_owned();
    let options = "--output --format --engine --precision --numerics --width --height --max-depth \
        --min-weight --samples --crop --threads --memory-limit --stats --progress --quiet \
        --transfer CATOPTRIC_ISA";
    for option in options.split_whitespace() {
        assert!(help.contains(option), "{option}");
    }
    let help = folder.done("compare --help").text().to_owned();
    for option in ["--json", "--diff", "--tolerance", "--allow", "--memory-limit"] {
        assert!(help.contains(option), "{option}");
    }
}

#[test]
fn the_help_s_examples_work() {
    let folder = Folder::new();
    folder.write("exact.pfm", []);
    folder.done("render scene.toml -o exact.pfm");
    folder.done("render scene.toml -o packet.pfm");
    folder.done("render scene.toml -o recursive.pfm");
    folder.done("render scene.toml -o before.png");
    folder.done("render scene.toml -o after.ppm");
    folder.done("render scene.toml -o expected.png");
    folder.done("render scene.toml -o student.ppm");
    // The repository's own scenes, at their names.
    let scenes = concat!(env!("CARGO_MANIFEST_DIR"), "/../../scenes");
    std::os::unix::fs::symlink(scenes, folder.path("scenes")).expect("a link");
    let mut tried = 0;
    for command in ["render --help", "compare --help", "explain --help"] {
        let help = folder.done(command).text().to_owned();
        let examples = help.split_once("Examples:").expect("examples").1.lines();
        for example in examples.map(str::trim).filter(|line| !line.is_empty()) {
            // The scene is smaller than the example's crop.
            let example = example.replace("0,0,64,48", "0,0,6,4");
            let program = example.replace("catoptric", crate::program::CATOPTRIC);
            let status = std::process::Command::new("sh")
                .args(["-c", &program])
                .current_dir(folder.path("."))
                .output()
                .expect("a shell");
            let stderr = String::from_utf8_lossy(&status.stderr);
            assert_eq!(status.status.code(), Some(0), "{example}: {stderr}");
            tried += 1;
        }
    }
    assert_eq!(tried, 14);
}
