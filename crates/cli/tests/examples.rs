//! The programs of `tests/examples` do what their first lines say.

use std::process::Command;

use crate::program::{CATOPTRIC, Folder, Ran, ppm};

/// Runs an example in the folder; `None` where python3 or a module is missing.
fn run(folder: &Folder, example: &str, modules: &str, arguments: &[&str]) -> Option<Ran> {
    let import = format!("import {modules}");
    let found = Command::new("python3").args(["-c", &import]).output();
    if !found.is_ok_and(|found| found.status.success()) {
        let required = std::env::var_os("CATOPTRIC_REQUIRE_TOOLS").is_some();
        assert!(!required, "python3 with {modules} is required here");
        println!("skipped {example}: python3 with {modules} is missing");
        return None;
    }
    let path = concat!(env!("CARGO_MANIFEST_DIR"), "/../../tests/examples/");
    let output = Command::new(format!("{path}{example}"))
        .args(arguments)
        .current_dir(folder.path("."))
        .env("CATOPTRIC", CATOPTRIC)
        .env_remove("CATOPTRIC_ISA")
        .output()
        .expect("the example runs");
    Some(Ran {
        code: output.status.code(),
        stdout: output.stdout,
        stderr: String::from_utf8_lossy(&output.stderr).into_owned(),
    })
}

#[test]
fn depths_prints_a_line_for_each_depth() {
    let folder = Folder::new();
    let before = folder.contents();
    let Some(ran) = run(&folder, "depths.sh", "json", &["scene.toml", "0", "1", "3"]) else {
        return;
    };
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    let rows: Vec<Vec<&str>> =
        ran.text().lines().map(|line| line.split_whitespace().collect()).collect();
    assert_eq!(rows.len(), 4, "{}", ran.text());
    assert_eq!(rows[0], ["depth", "rays", "trace", "ms"]);
    let column = |at: usize| rows[1..].iter().map(move |row| row[at].parse::<f64>());
    assert!(column(0).eq([0.0, 1.0, 3.0].map(Ok)), "{}", ran.text());
    let rays: Vec<f64> = column(1).map(|rays| rays.expect("a number")).collect();
    assert!(rays[0] > 90.0 && rays.is_sorted_by(|a, b| a < b), "{}", ran.text());
    assert!(column(2).all(|ms| ms.is_ok_and(|ms| ms >= 0.0)), "{}", ran.text());
    assert_eq!(folder.contents(), before, "the pictures are not kept");

    let failed = run(&folder, "depths.sh", "json", &["missing.toml"]).expect("python3 is there");
    assert_eq!(failed.code, Some(3), "{}", failed.stderr);
    assert!(failed.stderr.contains("missing.toml"), "{}", failed.stderr);
}

#[test]
fn numpy_render_gets_an_array() {
    let folder = Folder::new();
    let before = folder.contents();
    let Some(ran) = run(&folder, "numpy_render.py", "numpy", &[]) else {
        return;
    };
    assert_eq!((ran.code, ran.stderr.as_str()), (Some(0), ""));
    let text = ran.text();
    assert!(text.starts_with("(90, 160, 3) float32, mean ["), "{text}");
    assert!(text.ends_with("\nboth engines give the same bits\n"), "{text}");
    assert_eq!(folder.contents(), before);
}

#[test]
fn grade_passes_fails_and_refuses() {
    let folder = Folder::new();
    let mut levels = [[50, 60, 70]; 2000];
    folder.write("expected.ppm", ppm(50, &levels));
    // One level everywhere, and two pixels of 2000 that are far off.
    levels.iter_mut().for_each(|pixel| pixel[0] += 1);
    (levels[7], levels[9]) = ([0; 3], [0; 3]);
    folder.write("edges.ppm", ppm(50, &levels));
    levels[500] = [0; 3];
    folder.write("wrong.ppm", ppm(50, &levels));
    folder.write("small.ppm", ppm(49, &levels[..49]));
    let cases = [
        ("expected.ppm", 0, "passed: equal\n"),
        ("edges.ppm", 0, "passed: 2 pixels are off by more than one level"),
        ("wrong.ppm", 1, "failed: 3 pixels (0.1%) are off by more than one level; the first"),
        ("wrong.ppm", 1, "at (0, 0): expected [50.0, 60.0, 70.0], found [51.0, 60.0, 70.0]\n"),
        ("small.ppm", 2, "cannot be graded\n"),
        ("missing.ppm", 2, "cannot be graded\n"),
    ];
    for (student, code, words) in cases {
        let Some(ran) = run(&folder, "grade.py", "json", &["expected.ppm", student]) else {
            return;
        };
        assert_eq!(ran.code, Some(code), "{student}: {}", ran.stderr);
        assert!(ran.text().contains(words), "{student}: {}", ran.text());
    }
}
