//! `generate`: scene files of the families.

use std::process::Command;

use catoptric_scene::family::{Corridor, Kissing, Lattice, Random, Room, Sphereflake};
use catoptric_scene::{Body, Document, Draft, Scene, SceneFormat};

use crate::program::{CATOPTRIC, Folder};
use crate::refusals::refused;

/// The families with the drafts that the library makes of their defaults.
fn families() -> [(&'static str, Draft); 6] {
    [
        ("corridor", Corridor::default().draft()),
        ("room", Room::default().draft()),
        ("kissing", Kissing::default().draft()),
        ("random", Random::default().draft()),
        ("lattice", Lattice::default().draft()),
        ("sphereflake", Sphereflake::default().draft()),
    ]
    .map(|(name, draft)| (name, draft.expect("defaults are in range")))
}

/// A family with every option of its own, away from its default, and some that all have.
const FULL: [&str; 8] = [
    "corridor --balls 7 --reflect 0.5 --mirror-radius 1e12 --seed 18446744073709551615",
    "room --radius 0.25 --balls 9 --reflect 1 --seed 5 --max-depth 4294967295",
    "kissing --arrangement ring --spheres 9 --radius 1e-6 --reflect 0.3 --seed 6 --width 65535",
    "kissing --arrangement chain --spheres 3 --radius 123456.789 --height 1",
    "kissing --arrangement cluster --spheres 3",
    "random --balls 30 --min-radius 1e-9 --max-radius 0.1 --overlap --reflect 0 --seed 7",
    "lattice --edge 3 --radius 0.125 --reflect 0.1 --seed 8 --width 1 --height 65535",
    "sphereflake --levels 1 --reflect 0.9 --ground-radius 1e4 --seed 9 --max-depth 0",
];

fn scene(name: &str, bytes: &[u8], format: SceneFormat) -> Draft {
    let document = Document::parse(name, bytes, format);
    let scene = document.and_then(Document::into_scene).unwrap_or_else(|e| panic!("{e}"));
    scene.into_draft()
}

/// What a draft says, with each body's material in place of its number: a file numbers materials in
/// the order in which it states them.
fn stated(draft: &Draft) -> String {
    let Draft { image, camera, render, lights, .. } = draft;
    format!("{image:?} {camera:?} {render:?} {lights:?} {}", bodies(draft))
}

fn bodies(draft: &Draft) -> String {
    let material = |body: Body| draft.materials.get(body.material()).copied();
    let materials: Vec<_> = draft.bodies().map(material).collect();
    let spheres: Vec<_> = draft.spheres.iter().map(|s| (s.center, s.radius)).collect();
    let planes: Vec<_> = draft.planes.iter().map(|p| (p.point, p.normal)).collect();
    format!("{spheres:?} {planes:?} {materials:?}")
}

#[test]
fn defaults_are_the_library_s() {
    for (family, expected) in families() {
        let folder = Folder::new();
        let ran = folder.done(&format!("generate {family}"));
        assert_eq!((ran.text(), ran.stderr.lines().count()), ("", 1), "{family}");
        let made = folder.read(&format!("{family}.toml"));
        let made = scene(family, &made, SceneFormat::Toml);
        assert!(stated(&made) == stated(&expected), "{family}");
        assert_eq!(folder.contents().len(), 2, "{family} left something");
    }
}

#[test]
fn formats_and_places_hold_the_same_scene() {
    for (family, _) in families() {
        let folder = Folder::new();
        let toml = folder.done(&format!("generate {family} --seed 4 -o - --quiet"));
        assert_eq!(toml.stderr, "", "{family}");
        let expected = scene(family, &toml.stdout, SceneFormat::Toml);
        let text = Scene::new(expected.clone()).expect("valid").to_text(SceneFormat::Toml);
        assert!(toml.text().ends_with(&format!("\n\n{text}")), "{family}");

        folder.done(&format!("generate {family} --seed 4 -q --format json"));
        let json = folder.read(&format!("{family}.json"));
        let from_json = scene(family, &json, SceneFormat::Json);
        assert!(stated(&from_json) == stated(&expected), "{family}");
        folder.done(&format!("generate {family} --seed 4 -o A.TOML"));
        assert_eq!(folder.read("A.TOML"), toml.stdout, "{family}");
        folder.done(&format!("generate {family} --seed 4 -o b.json"));
        assert_eq!(folder.read("b.json"), json, "{family}");
        folder.done(&format!("generate {family} --seed 4 -o c --format toml"));
        assert_eq!(folder.read("c"), toml.stdout, "{family}");
    }
}

#[test]
fn another_seed_is_another_file_and_options_stand_above_the_family() {
    for (family, draft) in families() {
        let folder = Folder::new();
        let options = "--seed 1 --width 31 --height 17 --max-depth 9 -o -";
        let made = folder.done(&format!("generate {family} {options}"));
        let made = scene(family, &made.stdout, SceneFormat::Toml);
        assert_eq!((made.image.width, made.image.height, made.render.max_depth), (31, 17, 9));
        assert_eq!(made.camera, draft.camera, "{family}");
        assert!(bodies(&made) != bodies(&draft), "{family}");
    }
}

/// The comment's command makes the same file, so no option is missing in it.
#[test]
fn a_file_says_how_it_was_made() {
    for asked in FULL {
        let folder = Folder::new();
        folder.done(&format!("generate {asked} -o first.toml"));
        let first = folder.read("first.toml");
        let text = std::str::from_utf8(&first).expect("text");
        let (head, _) = text.split_once("\n\n").expect("a head");
        let family = asked.split(' ').next().expect("a family");
        assert!(head.starts_with(&format!("# Family {family}, seed ")), "{head}");
        let command = head.lines().last().expect("a command").trim_start_matches(['#', ' ']);
        let again = command.strip_prefix("catoptric ").expect("the program");
        folder.done(&format!("{again} -o again.toml"));
        assert_eq!(folder.read("again.toml"), first, "{asked}");
        // Nothing that was asked is a default, or the comparison would not see it missing.
        let defaults = folder.done(&format!("generate {family} -o -"));
        assert_ne!(defaults.stdout, first, "{asked}");
    }
}

#[test]
fn generated_scenes_render() {
    for asked in FULL {
        let folder = Folder::new();
        folder.done(&format!("generate {asked} -o a.toml"));
        folder.done("render a.toml -o a.pfm --width 5 --height 4 --max-depth 9");
        assert!(!folder.read("a.pfm").is_empty());
    }
}

#[test]
fn wrong_use_is_2() {
    let folder = Folder::new();
    let cases: &[(&str, &[&str])] = &[
        ("generate", &["corridor", "room", "kissing", "random", "lattice", "sphereflake"]),
        ("generate cornell", &["cornell"]),
        ("generate room --balls 1000001", &["--balls: found 1000001", "0 to 1000000"]),
        ("generate room --balls -1", &["--balls", "-1"]),
        ("generate room --balls 5000000000", &["--balls", "4294967295"]),
        ("generate room --radius 0", &["--radius: found 0", "0.001 to 1000000000"]),
        ("generate room --radius NaN", &["--radius: found nan", "0.001"]),
        ("generate room --reflect 1.01", &["--reflect: found 1.01", "0 to 1"]),
        ("generate corridor --mirror-radius 9", &["--mirror-radius: found 9", "10 to 1000"]),
        ("generate kissing --spheres 5", &["--spheres: found 5", "2 to 4"]),
        ("generate kissing --arrangement ring --spheres 2", &["--spheres: found 2", "from 3"]),
        ("generate kissing --arrangement heap", &["heap", "cluster", "ring", "chain"]),
        (
            "generate random --min-radius 2",
            &["--min-radius: found 2", "largest radius, which is 1"],
        ),
        ("generate random --max-radius -1", &["--max-radius: found -1", "1e-9"]),
        ("generate lattice --edge 101", &["--edge: found 101", "1 to 100"]),
        ("generate lattice --edge 0", &["--edge: found 0"]),
        ("generate sphereflake --levels 7", &["--levels: found 7", "0 to 6"]),
        ("generate sphereflake --ground-radius inf", &["--ground-radius: found inf"]),
        ("generate room --seed -1", &["--seed", "-1"]),
        ("generate room --seed 18446744073709551616", &["--seed"]),
        ("generate room --width 0", &["--width", "from 1 to 65535"]),
        ("generate room --height 65536", &["--height", "from 1 to 65535"]),
        ("generate room --max-depth 4294967296", &["--max-depth", "4294967295"]),
        ("generate room -o picture.png", &["picture.png", ".toml", ".json", "--format"]),
        ("generate room -o room", &["-o room", "--format"]),
        ("generate room --format yaml", &["yaml", "toml", "json"]),
    ];
    for (arguments, parts) in cases {
        // The help of a missing subcommand is clap's, and starts otherwise.
        if *arguments == "generate" {
            let ran = folder.run(arguments);
            assert_eq!((ran.code, ran.stdout.len()), (Some(2), 0));
            assert!(parts.iter().all(|part| ran.stderr.contains(part)), "{}", ran.stderr);
        } else {
            refused(&folder, arguments, 2, parts);
        }
    }
}

#[test]
fn places_that_cannot_be_written_are_4() {
    let folder = Folder::new();
    for output in ["missing/room.toml", "/dev/full --format toml", "/proc/room.toml"] {
        let place = output.split(' ').next().expect("a place");
        refused(&folder, &format!("generate room -o {output}"), 4, &[place]);
    }
    // A reader that leaves early is a failure too.
    let piped =
        format!("{CATOPTRIC} generate lattice --edge 20 -o - | true; exit ${{PIPESTATUS[0]}}");
    let ran = Command::new("bash").args(["-c", &piped]).output().expect("a shell");
    assert_eq!(ran.status.code(), Some(4), "{}", String::from_utf8_lossy(&ran.stderr));
}

#[test]
fn what_is_there_is_replaced_only_by_a_whole_scene() {
    let folder = Folder::new();
    folder.write("room.toml", "kept");
    refused(&folder, "generate room --reflect 2", 2, &["--reflect"]);
    folder.done("generate room");
    assert_ne!(folder.read("room.toml"), b"kept");
}

#[test]
fn the_help_s_examples_work() {
    let mut tried = 0;
    let commands = families().map(|(family, _)| format!("generate {family} --help"));
    for command in commands.iter().map(String::as_str).chain(["generate --help"]) {
        let folder = Folder::new();
        let help = folder.done(command).text().to_owned();
        for option in ["--seed", "--width", "--height", "--max-depth", "--output", "--format"] {
            assert!(command == "generate --help" || help.contains(option), "{command}: {option}");
        }
        assert!(!help.contains("own options"), "a comment for programmers: {help}");
        let examples = help.split_once("Examples:").expect("examples").1.lines();
        for example in examples.map(str::trim).filter(|line| !line.is_empty()) {
            let before = folder.contents();
            let status = Command::new("sh")
                .args(["-c", &example.replace("catoptric", CATOPTRIC)])
                .current_dir(folder.path("."))
                .output()
                .expect("a shell");
            let stderr = String::from_utf8_lossy(&status.stderr);
            assert_eq!(status.status.code(), Some(0), "{example}: {stderr}");
            let made = folder.contents() != before || !status.stdout.is_empty();
            assert!(made, "{example} made nothing new");
            tried += 1;
        }
    }
    assert_eq!(tried, 22);
}

/// Haines' Standard Procedural Databases publish the counts of `balls`, good to "about 10 %":
/// 513 x 513 eye rays through pixel corners, trace depth 5 with the eye ray as its first,
/// 175 095 reflection rays and 954 368 shadow rays. A plain tracer's hits by depth were
/// 263 169, 59 128, 33 210, 20 891, 13 524. Here the ground does not end, so a few more
/// reflections meet it, and every third pixel of a row and column is taken.
#[test]
fn sphereflake_has_the_published_ray_counts() {
    let folder = Folder::new();
    folder.done("generate sphereflake --width 171 --height 171 --max-depth 4");
    let stats = folder.done("render sphereflake.toml -o a.ppm --stats - --quiet").json();
    let hits = [263_169.0, 59_128.0, 33_210.0, 20_891.0, 13_524.0];
    assert_eq!(stats["depths"].as_array().map(Vec::len), Some(hits.len()));
    let hits =
        (0..).zip(hits).map(|(depth, hits): (usize, f64)| (&stats["depths"][depth]["hits"], hits));
    let rays = [(&stats["rays"]["reflection"], 175_095.0), (&stats["rays"]["shadow"], 954_368.0)];
    for (count, published) in hits.chain(rays) {
        let ratio = count.as_f64().expect("a count") * 9.0 / published;
        assert!((0.96..1.04).contains(&ratio), "{count} against {published}: {ratio}");
    }
}
