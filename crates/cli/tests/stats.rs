//! `--stats`: the object that programs read.

use serde_json::Value;

use crate::program::{Folder, JSON_SCENE};

fn keys(value: &Value) -> Vec<&str> {
    value.as_object().expect("an object").keys().map(String::as_str).collect()
}

fn sorted<const N: usize>(mut names: [&str; N]) -> [&str; N] {
    names.sort_unstable();
    names
}

#[test]
fn the_keys_are_those_of_the_contract() {
    let folder = Folder::new();
    for engine in ["packet", "recursive"] {
        let ran =
            folder.done(&format!("render scene.toml --stats - --threads 2 --engine {engine}"));
        let stats = ran.json();
        let all = [
            "schema",
            "version",
            "scene",
            "engine",
            "numerics",
            "precision",
            "width",
            "height",
            "max_depth",
            "threads",
            "isa",
            "time_ms",
            "rays",
            "depths",
            "plan",
        ];
        assert_eq!(keys(&stats), sorted(all));
        assert_eq!(
            keys(&stats["time_ms"]),
            sorted(["load", "compile", "trace", "encode", "total"])
        );
        assert_eq!(keys(&stats["rays"]), sorted(["primary", "reflection", "shadow"]));
        assert_eq!(stats["schema"], "catoptric-stats");
        assert_eq!(stats["version"], 1);
        assert_eq!(stats["scene"], "scene.toml");
        assert_eq!(stats["engine"], engine);
        assert_eq!(stats["numerics"], "robust");
        assert_eq!(stats["precision"], "f32");
        assert_eq!((&stats["width"], &stats["height"]), (&13.into(), &7.into()));
        assert_eq!(stats["max_depth"], 4);
        assert_eq!(stats["threads"], 2);
        if engine == "recursive" {
            assert_eq!(stats["plan"], Value::Null);
        } else {
            assert_eq!(stats["plan"]["depth"], 4);
            let omitted = serde_json::json!(["tiles", "occluders", "directions"]);
            assert_eq!(stats["plan"]["omitted"], omitted);
            assert_eq!(stats["plan"]["film"], false, "a PNG needs none");
            let features = &stats["plan"]["features"];
            assert_eq!((&features["balls"], &features["planes"]), (&2.into(), &1.into()));
            assert_eq!((&features["mirrors"], &features["lamps"]), (&3.into(), &1.into()));
            assert_eq!(
                (&features["coloured_lamps"], &features["weight_cut"]),
                (&true.into(), &false.into())
            );
        }
    }
}

#[test]
fn counts_are_the_picture_s() {
    let folder = Folder::new();
    let options = "--width 40 --height 30 --samples 2 --crop 4,5,20,10 --engine recursive";
    let stats = folder.done(&format!("render scene.toml --stats - {options}")).json();
    assert_eq!((&stats["width"], &stats["height"]), (&20.into(), &10.into()));
    assert_eq!(stats["rays"]["primary"], 20 * 10 * 4);

    let depths = stats["depths"].as_array().expect("a list");
    assert!(depths.len() > 2, "the spheres mirror each other");
    let number = |value: &Value| value.as_u64().expect("a count");
    let mut reflections = 0;
    for (at, depth) in depths.iter().enumerate() {
        assert_eq!(keys(depth), sorted(["depth", "rays", "hits"]));
        assert_eq!(depth["depth"], at);
        assert!(number(&depth["hits"]) <= number(&depth["rays"]));
        reflections += if at == 0 { 0 } else { number(&depth["rays"]) };
    }
    assert_eq!(stats["rays"]["reflection"], reflections);
    assert!(number(&stats["rays"]["shadow"]) > 0);
}

#[test]
fn times_are_parts_of_the_total() {
    let folder = Folder::new();
    let size = "--width 200 --height 200 --engine recursive";
    let stats = folder.done(&format!("render scene.toml --stats - {size}")).json();
    let time = |name: &str| stats["time_ms"][name].as_f64().expect("a time");
    let parts = ["load", "compile", "trace", "encode"].map(time);
    assert!(parts.iter().all(|&ms| ms >= 0.0), "{stats}");
    assert!(time("trace") > 0.0 && time("encode") > 0.0, "{stats}");
    assert!(parts.iter().sum::<f64>() <= time("total") + 0.01, "{stats}");
}

#[test]
fn what_was_used_is_named() {
    let folder = Folder::new();
    let stats = |options: &str, isa: &str| {
        let env = [("CATOPTRIC_ISA", isa)];
        folder.run_with(&format!("render scene.toml --stats - {options}"), "", &env).json()
    };
    assert_eq!(stats("", "portable")["isa"], "portable");
    let best = catoptric_core::Isa::detected().name();
    assert_eq!(stats("", "avx2")["isa"], best);
    assert_eq!(stats("", "")["isa"], best);
    assert_eq!(stats("--engine recursive", "avx2")["isa"], Value::Null);

    assert_eq!(stats("--numerics textbook", "")["numerics"], "textbook");
    let truth = stats("--numerics textbook --engine recursive --precision dd", "");
    assert_eq!((&truth["precision"], &truth["numerics"]), (&"dd".into(), &"robust".into()));
    assert_eq!(truth["rays"]["primary"], 13 * 7);
}

#[test]
fn they_go_to_a_file_or_to_stdout() {
    let folder = Folder::new();
    let ran = folder.done("render scene.toml -o out.png --stats stats.json");
    assert!(ran.stdout.is_empty());
    let stats: Value = serde_json::from_slice(&folder.read("stats.json")).expect("JSON");
    assert_eq!(stats["schema"], "catoptric-stats");
    assert_eq!(folder.contents().len(), 3);

    let ran = folder.run_with("render - -o out.png --stats -", JSON_SCENE, &[]);
    assert_eq!(ran.json()["scene"], "-");
}
