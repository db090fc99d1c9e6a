//! `study` from outside: rows, files, refusals, interruption.

use serde_json::Value;

use crate::browser::open;
use crate::program::{Folder, Ran};

const PAGE: &str = "index.html";

fn rows(ran: &Ran) -> Vec<Value> {
    let json = ran.json();
    assert_eq!((&json["schema"], &json["version"]), (&"catoptric-study".into(), &2.into()));
    json["rows"].as_array().expect("rows").clone()
}

#[test]
fn depth_rows_have_what_the_contract_names() {
    let folder = Folder::new();
    let asked = "study depth scene.toml --depths 0,3 --repeat 2 --threads 2 --json";
    let ran = folder.done(asked);
    let rows = rows(&ran);
    let key = |row: &Value| (row["engine"].clone(), row["depth"].as_u64(), row["threads"].as_u64());
    let mut expected = Vec::new();
    for depth in [0, 3] {
        for engine in ["recursive", "packet"] {
            for threads in [1, 2] {
                expected.push((engine.into(), Some(depth), Some(threads)));
            }
        }
    }
    assert_eq!(rows.iter().map(key).collect::<Vec<_>>(), expected);
    for row in &rows {
        assert_eq!(row["scene"], "scene");
        let number = |key: &str| row[key].as_f64().unwrap_or_else(|| panic!("{key} of {row}"));
        assert!(number("min_ms") > 0.0 && number("min_ms") <= number("median_ms"), "{row}");
        let ns = number("min_ms") * 1e6 / number("rays");
        assert!((number("ns_per_ray") / ns - 1.0).abs() < 1e-9, "{row}");
        assert!(number("speedup") > 0.0);
        assert_eq!(row["runs"], 2);
    }
    assert_eq!(rows[0]["speedup"], 1.0);

    // The rays are those that `render` counts.
    let stats = folder.done("render scene.toml -o a.pfm --max-depth 3 --stats -").json();
    let rays = ["primary", "reflection", "shadow"].map(|kind| stats["rays"][kind].as_u64());
    let sum: u64 = rays.into_iter().flatten().sum();
    assert_eq!(rows[7]["rays"].as_u64(), Some(sum));

    let json = ran.json();
    for key in ["date", "commit", "processor", "isa", "threads", "command"] {
        assert!(!json["made"][key].is_null(), "{key}");
    }
    let command = json["made"]["command"].as_str().expect("the command line");
    assert!(command.ends_with(asked), "{command}");
}

#[test]
fn a_folder_holds_the_page_and_every_table_plot_and_row() {
    let folder = Folder::new();
    let ran = folder.done("study depth scene.toml scene.toml --depths 2 --repeat 1 -o new/deep");
    assert_eq!(ran.text(), "", "rows go to stdout only where asked");
    let deep = |name: &str| String::from_utf8(folder.read(&format!("new/deep/{name}")));
    for name in [PAGE, "depth.json", "depth.csv", "depth.md", "depth-levels.csv"] {
        assert!(!deep(name).expect(name).is_empty(), "{name}");
    }
    // Two scenes of one name have plots of their own.
    for name in ["depth-scene-time.svg", "depth-scene-2-time.svg"] {
        assert!(deep(name).expect(name).contains("<svg"), "{name}");
    }
    let csv = deep("depth.csv").expect("text");
    let first = csv.lines().next().expect("a line of keys");
    assert!(
        first.starts_with("scene,engine,depth,threads,min_ms,median_ms,rays,ns_per_ray,speedup")
    );
    assert_eq!(csv.lines().filter(|line| line.starts_with("scene-2,")).count(), 4);
    // Once more into the same folder: replaced, nothing left beside.
    folder.done("study depth scene.toml --depths 2 --repeat 1 -o new/deep --quiet");
    let names = std::fs::read_dir(folder.path("new/deep")).expect("the folder");
    let unfinished = names.filter(|entry| {
        let entry = entry.as_ref().expect("an entry");
        entry.file_name().to_string_lossy().contains("unfinished")
    });
    assert_eq!(unfinished.count(), 0);
}

#[test]
fn a_path_deeper_than_the_stack_is_a_row_with_a_note() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 1 --height 1 -o room.toml");
    let ran = folder.done("study depth room.toml --depths 10,100001 --repeat 1 --threads 1 --json");
    let rows = rows(&ran);
    let deep: Vec<_> = rows.iter().filter(|row| row["depth"] == 100_001).collect();
    assert_eq!(deep[0]["engine"], "recursive");
    assert!(deep[0]["min_ms"].is_null());
    assert_eq!(deep[0]["note"], "a path is deeper than the stack");
    assert!(deep[1]["min_ms"].as_f64().is_some(), "{}", deep[1]);
}

/// Every depth and engine once, by default on 1 and on 2 threads.
#[test]
fn what_is_asked_for_twice_is_measured_once() {
    let folder = Folder::new();
    let asked = "study depth scene.toml --depths 2,0,2 --engines packet,packet --repeat 1 --json";
    let rows = rows(&folder.done(asked));
    let key = |row: &Value| (row["depth"].as_u64(), row["threads"].as_u64());
    let keys: Vec<_> = rows.iter().map(key).collect();
    let expected = [(2, 1), (2, 2), (0, 1), (0, 2)].map(|(depth, n)| (Some(depth), Some(n)));
    assert_eq!(keys, expected);
}

/// The portable engine is compared with the loop, not with itself.
#[test]
fn past_the_recursion_s_stack_the_loop_says_what_is_right() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 1 --height 1 -o room.toml");
    let asked = "study depth room.toml --depths 100001 --engines packet --repeat 1 --json";
    let ran = folder.run_with(asked, "", &[("CATOPTRIC_ISA", "portable")]);
    for row in rows(&ran) {
        assert_eq!(row["note"], "compared with the ladder's loop: too deep for the recursion");
        assert!(row["min_ms"].as_f64().is_some(), "{row}");
    }
}

/// Arguments that a shell would split are quoted; what is no text does not stop the study.
#[test]
fn the_command_line_is_that_of_a_shell() {
    let folder = Folder::new();
    let asked = "study depth 'my scene.toml' --depths 0 --repeat 1 --engines packet --json";
    let ran = folder.shell(&format!("cp scene.toml 'my scene.toml' && catoptric {asked}"));
    let command = ran.json()["made"]["command"].as_str().expect("the command line").to_owned();
    assert!(command.ends_with(asked), "{command}");

    let name = "\"$(printf 'a\\377.toml')\"";
    let line = format!(
        "cp scene.toml {name} && catoptric study depth {name} --depths 0 --repeat 1 --json"
    );
    let ran = folder.shell(&line);
    assert_eq!(ran.code, Some(0), "{}", ran.stderr);
    let command = ran.json()["made"]["command"].as_str().expect("the command line").to_owned();
    assert!(command.contains("study depth a\u{fffd}.toml --depths"), "{command}");
}

/// Files of the earlier report that are not written again go, others stay.
#[test]
fn a_folder_written_twice_holds_one_report() {
    let folder = Folder::new();
    folder.done("generate room --width 4 --height 4 -o room.toml");
    let asked = "--depths 1 --repeat 1 --threads 1 -q -o deep";
    folder.done(&format!("study depth room.toml scene.toml {asked}"));
    folder.write("deep/notes.txt", "mine");
    folder.write("deep/mine.json", "{}");
    let has = |name: &str| folder.path(&format!("deep/{name}")).exists();
    assert!(has("depth-room-time.svg") && has("depth-scene-time.svg"));
    folder.done(&format!("study depth scene.toml {asked}"));
    assert!(!has("depth-room-time.svg") && has("depth-scene-time.svg"));
    assert!(has("notes.txt") && has("mine.json") && has("depth.csv"));

    // Another study's page would take the place of this one's.
    let page = folder.read("deep/index.html");
    let ran = folder.run("study ladder scene.toml --repeat 1 -o deep");
    assert_eq!(ran.code, Some(4), "{}", ran.stderr);
    assert!(ran.stderr.contains("holds a report of study depth"), "{}", ran.stderr);
    assert_eq!(folder.read("deep/index.html"), page);

    // A list that names files elsewhere is not followed.
    let json = String::from_utf8(folder.read("deep/depth.json")).expect("text");
    let elsewhere = json.replace("\"depth.csv\"", "\"../depth.csv\"");
    assert_ne!(json, elsewhere);
    folder.write("depth.csv", folder.read("deep/depth.csv"));
    folder.write("deep/depth.json", elsewhere);
    folder.done(&format!("study depth room.toml {asked}"));
    assert!(folder.path("depth.csv").exists());
}

#[test]
fn error_rows_fall_to_the_floor_and_stay_below_their_bounds() {
    let folder = Folder::new();
    let ran =
        folder.done("study error scene.toml --repeat 1 --threads 1 --json --target-error 0.01");
    let rows = rows(&ran);
    let number = |row: &Value, key: &str| row[key].as_f64();
    for row in rows.iter().filter(|row| row["sweep"] != "samples") {
        let known = |key: &str| number(row, key).unwrap_or_else(|| panic!("{key} of {row}"));
        assert!(known("truncation") <= known("bound_truncation"), "{row}");
        assert!(known("max_unflipped") <= known("bound"), "{row}");
        assert_eq!(known("bound"), known("bound_truncation") + known("floor"), "{row}");
        assert_eq!(row["not_finite"], 0);
        assert!(row["front"].is_boolean(), "{row}");
    }
    assert!(rows.iter().all(|row| row["sweep"] != "samples" || row["front"].is_null()));
    let robust = |formula: &str| {
        let depths = rows.iter().filter(|r| r["sweep"] == "depth" && r["formula"] == formula);
        let errors = depths.map(|row| number(row, "max").expect("a number"));
        errors.collect::<Vec<f64>>()
    };
    let (single, double) = (robust("robust f32"), robust("robust f64"));
    assert!(single[0] > 0.01 && *single.last().expect("rows") < 1e-4, "{single:?}");
    assert!(*double.last().expect("rows") < 1e-10, "{double:?}");
    let notes = ran.json()["notes"].to_string();
    assert!(notes.contains("scene: RMSE at most 1e-2, as asked: cheapest is "), "{notes}");
    assert!(rows.iter().any(|row| row["front"] == true));
}

#[test]
fn the_error_study_s_page_holds_its_plots_and_asks_for_nothing() {
    let folder = Folder::new();
    folder.done("study error scene.toml --repeat 1 -o error --quiet");
    let Some(opened) = open(&folder, "error/index.html") else { return };
    assert_eq!(opened.console, [""; 0]);
    assert_eq!(opened.document.matches("<svg").count(), 4);
    for words in ["Error against run time", "The front, which nothing cheaper beats: "] {
        assert!(opened.document.contains(words), "{words}");
    }
    // Each plot but that of samples has its curves: three formulas, each in its colour.
    for plot in ["work-precision", "depth", "weight"] {
        let drawing = opened.document.split_once(&format!("id=\"error-scene-{plot}\""));
        let drawing = drawing.and_then(|(_, rest)| rest.split_once("</svg>")).expect(plot).0;
        for colour in ["#0072b2", "#d55e00", "#009e73"] {
            assert!(drawing.matches(colour).count() > 3, "{plot}: {colour}");
        }
    }
}

#[test]
fn every_rung_of_the_ladder_is_checked_and_timed() {
    let folder = Folder::new();
    let ran = folder.done("study ladder scene.toml --repeat 2 --json");
    let all = rows(&ran);
    let names: Vec<&str> = all.iter().filter_map(|row| row["rung"].as_str()).collect();
    assert_eq!(names, ["r0", "r1", "r2", "r3", "r4", "r5", "forward"]);
    let number = |row: &Value, key: &str| row[key].as_f64().unwrap_or_else(|| panic!("{key}"));
    for (i, row) in all.iter().enumerate() {
        assert_eq!(row["bit_identical"] == true, number(row, "different") == 0.0, "{row}");
        assert!(row["rung"] == "forward" || row["bit_identical"] == true, "{row}");
        assert_eq!(row["runs"], 2);
        assert!(number(row, "lines") > 5.0 && number(row, "ns_per_ray") > 0.0, "{row}");
        let (native, own) = (number(row, "native_stack_bytes"), number(row, "own_stack_bytes"));
        // The scene's deepest path has four mirrors.
        assert_eq!(own, 4.0 * number(row, "level_bytes"), "{row}");
        assert!(native > 0.0 && number(row, "peak_stack_bytes") == native + own, "{row}");
        assert!(row["note"].is_null(), "{row}");
        let over = |other: &Value| number(other, "min_ms") / number(row, "min_ms");
        assert!((number(row, "over_r0") / over(&all[0]) - 1.0).abs() < 1e-9, "{row}");
        match i {
            0 | 6 => assert!(row["over_previous"].is_null(), "{row}"),
            _ => {
                let previous = over(&all[i - 1]);
                assert!((number(row, "over_previous") / previous - 1.0).abs() < 1e-9, "{row}");
            }
        }
    }
    let native = |i: usize| number(&all[i], "native_stack_bytes");
    assert!(native(1) > native(0), "continuations take more than calls");
    assert_eq!(ran.json()["made"]["threads"], 1);
}

#[test]
fn deep_paths_show_which_rungs_stand_on_the_native_stack() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 2 --height 2 --max-depth 3000 -o room.toml");
    let rows = rows(&folder.done("study ladder room.toml --repeat 1 --json"));
    for row in &rows {
        let grows = ["r0", "r1", "r2"].contains(&row["rung"].as_str().expect("a name"));
        let bytes = row["native_stack_bytes"].as_u64().expect("a number");
        assert_eq!(bytes > 3000 * 100, grows, "{row}");
        assert!(grows || bytes < 32 << 10, "{row}");
        let [own, level] = ["own_stack_bytes", "level_bytes"].map(|key| row[key].as_u64());
        assert_eq!(own, level.map(|level| 3000 * level), "{row}");
    }
    // Associativity fails for most of such sums.
    assert_eq!(rows[6]["bit_identical"], false);

    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 100001 -o room.toml");
    let ran = folder.done("study ladder room.toml --repeat 1 --json");
    let rows = self::rows(&ran);
    for row in &rows[..3] {
        assert!(row["min_ms"].is_null() && row["bit_identical"].is_null(), "{row}");
        assert_eq!(row["note"], "a path is deeper than its stack");
    }
    // Nobody can be compared with the recursion then, and r3 not with itself.
    assert!(rows[3]["bit_identical"].is_null() && rows[3]["note"].is_null(), "{}", rows[3]);
    for row in &rows[4..] {
        assert_eq!(row["bit_identical"] == true, row["rung"] != "forward", "{row}");
        let note = row["note"].as_str().expect("a note");
        assert_eq!(note, "compared with r3: the recursion's stack does not hold a path");
    }
    let notes = ran.json()["notes"].to_string();
    assert!(notes.contains("are compared with r3"), "{notes}");
}

#[test]
fn the_waterfall_goes_over_the_loop() {
    let folder = Folder::new();
    let json = folder.done("study depth scene.toml --depths 1 --repeat 1 --json").json();
    let tables = json["tables"].as_array().expect("tables");
    let waterfall = tables.iter().find(|table| table["name"] == "waterfall").expect("it");
    let steps: Vec<&str> = waterfall["rows"]
        .as_array()
        .expect("rows")
        .iter()
        .filter_map(|row| row["step"].as_str())
        .collect();
    let first = [
        "the recursion",
        "a scalar loop with an explicit stack",
        "eight rays in turn, with masks",
        "eight portable lanes, nothing left out",
    ];
    assert_eq!(steps[..4], first);
    let last = ["directions that nobody asks for left out", "2 threads"];
    assert!(steps.ends_with(&last), "{steps:?}");
}

#[test]
fn what_cannot_be_meant_is_refused_before_anything_is_measured() {
    let folder = Folder::new();
    folder.write("file", "in the way");
    for (arguments, code, says) in [
        ("study", 2, "depth"),
        ("study depth", 2, "study depth needs a scene"),
        ("study error", 2, "study error needs a scene"),
        ("study ladder", 2, "study ladder needs a scene"),
        ("study ladder scene.toml --threads 2", 2, "--threads"),
        ("study width scene.toml", 2, "width"),
        ("study depth scene.toml --depths 1,x", 2, "'x'"),
        ("study depth scene.toml --depths -1", 2, "-1"),
        ("study depth scene.toml --engines fast", 2, "fast"),
        ("study depth scene.toml --repeat 0", 2, "--repeat"),
        ("study error scene.toml --target-error 0", 2, "--target-error"),
        ("study depth missing.toml", 3, "missing.toml"),
        ("study depth missing.toml -o new", 3, "missing.toml"),
        ("study depth scene.toml -o -", 2, "--json"),
        ("study depth -o new", 2, "study depth needs a scene"),
        ("study depth scene.toml -o file", 4, "file"),
        ("study depth scene.toml -o file/deep", 4, "file/deep"),
    ] {
        let ran = folder.run(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {}", ran.stderr);
        assert!(ran.stderr.contains(says), "{arguments}: {}", ran.stderr);
        assert!(ran.stdout.is_empty(), "{arguments}");
        let names: Vec<String> = folder.contents().into_keys().collect();
        assert_eq!(names, ["file", "scene.toml"], "{arguments}");
    }
}

#[test]
fn stability_of_a_scene_is_judged_with_every_formula() {
    let folder = Folder::new();
    let ran = folder.done("study stability scene.toml --json --threads 1");
    let rows = rows(&ran);
    let formulas: Vec<_> = rows.iter().map(|row| row["formula"].clone()).collect();
    assert_eq!(formulas, ["textbook f32", "robust f32", "robust f64"]);
    let number = |row: &Value, key: &str| row[key].as_f64().expect("a number");
    assert!(number(&rows[1], "backward_by_input") <= 4.0, "{}", rows[1]);
    assert!(number(&rows[2], "max") < 1e-10, "{}", rows[2]);
    let json = ran.json();
    let tables = json["tables"].as_array().expect("tables");
    let names: Vec<_> = tables.iter().map(|table| table["name"].clone()).collect();
    assert_eq!(names, ["path-agreement", "error-by-cause", "input-rounding", "condition"]);
}
