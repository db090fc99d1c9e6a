//! The account of a scene.

use serde_json::Value;

use super::numbers;
use crate::program::Folder;

#[test]
fn a_scene_is_counted() {
    let folder = Folder::new();
    let told = folder.done("explain scene.toml --json").json();
    assert_eq!((&told["schema"], &told["version"]), (&"catoptric-explain".into(), &1.into()));
    assert_eq!((&told["scene"], &told["width"]), (&"scene.toml".into(), &13.into()));
    let has = &told["has"];
    let primitives = &has["primitives"];
    for (key, count) in [("spheres", 2), ("planes", 1), ("balls", 2), ("around", 0)] {
        assert_eq!(primitives[key], count, "{key}");
    }
    // A sphere's k is its specular factor, the plane's is stated.
    let mirrors: Vec<f64> = has["mirrors"]
        .as_array()
        .expect("mirrors")
        .iter()
        .filter_map(|m| m["k"].as_f64())
        .collect();
    assert_eq!(mirrors, [0.6, 0.5, 0.2]);
    assert_eq!(
        (&has["highlights"]["whole"], &has["highlights"]["fractional"]),
        (&2.into(), &0.into())
    );
    assert_eq!((&has["lamps"]["stated"], &has["lamps"]["coloured"]), (&1.into(), &1.into()));
    assert_eq!(numbers(&has["background"]), [0.2, 0.4, 1.7]);
    let plan = &told["plan"];
    let names: Vec<&str> = plan["omitted"]
        .as_array()
        .expect("omissions")
        .iter()
        .filter_map(|omitted| omitted["name"].as_str())
        .collect();
    // The plane has no highlight.
    assert_eq!(names, ["tiles", "occluders", "directions"]);
    assert_eq!(plan["depth"], 4);
    assert!(
        plan["omitted"]
            .as_array()
            .expect("omissions")
            .iter()
            .all(|omitted| { omitted["saves"].as_f64().is_some_and(|share| share < 1.0) })
    );
    let occluders = plan["occluders"].as_f64().expect("a number");
    assert!(occluders > 0.0 && occluders < 3.0, "{occluders}");
    let tried = plan["tried_a_tile"].as_f64().expect("a number");
    assert!(tried > 0.0 && tried <= 3.0, "{tried}");

    // The rays are those that `render` counts.
    let stats = folder.done("render scene.toml -o a.pfm --stats -").json();
    for kind in ["primary", "reflection", "shadow"] {
        assert_eq!(told["rays"][kind], stats["rays"][kind], "{kind}");
    }
    let depths = told["rays"]["depths"].as_array().expect("depths");
    for (told, counted) in depths.iter().zip(stats["depths"].as_array().expect("depths")) {
        assert_eq!((&told["rays"], &told["hits"]), (&counted["rays"], &counted["hits"]));
    }
    assert_eq!(told["rays"]["deepest"], depths.len() - 1);
}

/// Each depth that is called enough is, and one less is not; no cap changes more than its bound.
#[test]
fn depths_that_are_enough_are_the_smallest_that_are() {
    let folder = Folder::new();
    folder.done("generate kissing --width 48 --height 36 --max-depth 12 -o kissing.toml");
    for scene in ["scene.toml", "kissing.toml"] {
        let told = folder.done(&format!("explain {scene} --json")).json();
        folder.done(&format!("render {scene} -o full.pfm --quiet"));
        folder.done(&format!("render {scene} -o full.png --quiet"));
        let against = |depth: u64, full: &str| {
            let (_, ending) = full.split_once('.').expect("an ending");
            folder.done(&format!("render {scene} -o cap.{ending} --max-depth {depth} --quiet"));
            folder.run(&format!("compare cap.{ending} {full} --json")).json()
        };
        let enough = |key: &str| told["enough"][key].as_u64().expect("a depth");
        let (bits, level) = (enough("same_bits"), enough("within_a_level"));
        assert!(0 < level && level <= bits, "{scene}: {level}, {bits}");
        assert_eq!(against(bits, "full.pfm")["pixels"], 0, "{scene}");
        assert_ne!(against(bits - 1, "full.pfm")["pixels"], 0, "{scene}");
        assert_eq!(against(level, "full.png")["level_pixels_over_one"], 0, "{scene}");
        assert_ne!(against(level - 1, "full.png")["level_pixels_over_one"], 0, "{scene}");

        let caps = told["caps"].as_array().expect("caps");
        assert!(caps.len() >= 4, "{scene}");
        for cap in caps {
            let bound = cap["bound"].as_f64().expect("every k is below 1");
            let depth = cap["max_depth"].as_u64().expect("a depth");
            let error = against(depth, "full.pfm")["max"].as_f64().expect("a number");
            // What f32 adds is a term of its own.
            assert!(error <= bound + 1e-6, "{scene} to {depth}: {error} and {bound}");
            assert!(cap["bound_endless"].as_f64().is_some_and(|endless| endless >= bound));
        }
    }
}

/// A single mirror cannot show itself; without one, depth 0 is all there is.
#[test]
fn depths_that_cannot_occur_are_told() {
    let folder = Folder::new();
    let one = crate::program::SCENE.replace("specular = 0.5\n", "").replace("reflect = 0.2\n", "");
    folder.write("one.toml", &one);
    folder.write("none.toml", one.replace("specular = 0.6\n", ""));
    for (scene, depth) in [("one.toml", 1), ("none.toml", 0)] {
        let told = folder.done(&format!("explain {scene} --json")).json();
        assert_eq!((&told["plan"]["depth"], &told["max_depth"]), (&depth.into(), &4.into()));
        assert_eq!(told["rays"]["deepest"], depth, "{scene}");
        let text = folder.done(&format!("explain {scene}"));
        let words = format!("no ray can have more than {depth} reflections");
        assert!(text.text().contains(&words), "{}", text.text());
    }
    folder.write("textbook.toml", one.replace("[render]\n", "[render]\nnumerics = \"textbook\"\n"));
    let told = folder.done("explain textbook.toml --json").json();
    assert!(!told["plan"]["omitted"].to_string().contains("tiles"), "{told}");
    assert!(told["has"]["primitives"]["around"].is_null());
}

/// A weight that falls below the cut ends paths, and the account says so.
#[test]
fn a_cut_by_weight_is_told() {
    let folder = Folder::new();
    folder.done("generate kissing --width 24 --height 18 --max-depth 40 -o kissing.toml");
    let kissing = String::from_utf8(folder.read("kissing.toml")).expect("text");
    let k = folder.done("explain kissing.toml --json").json()["has"]["mirrors"][0]["k"].as_f64();
    let k = k.expect("a factor");
    for reflections in [0, 1, 3] {
        // Between the weights of so many reflections and of one more.
        let weight = (0..reflections).fold(1.0, |weight, _| weight * k);
        let cut = weight * (k + 1.0) / 2.0;
        let scene = kissing.replace("[render]\n", &format!("[render]\nmin_weight = {cut}\n"));
        folder.write("cut.toml", &scene);
        let told = folder.done("explain cut.toml --json").json();
        let plan = &told["plan"];
        assert_eq!(
            (&plan["depth"], &plan["depth_set_by"]),
            (&reflections.into(), &"min_weight".into())
        );
        assert_eq!(told["rays"]["deepest"], reflections);
        assert_eq!(told["needs"]["reflection_rays"], reflections > 0);
        assert_eq!(told["caps"].as_array().expect("caps").last().expect("one")["bound"], 0.0);
        // The cut changes no more than it is said to.
        let bound = told["weight_cut_bound"].as_f64().expect("a bound");
        folder.done("render cut.toml -o cut.pfm --quiet");
        folder.done("render kissing.toml -o whole.pfm --quiet");
        let error = folder.run("compare cut.pfm whole.pfm --json").json()["max"].as_f64();
        assert!(error.is_some_and(|error| 0.0 < error && error < bound), "{error:?} {bound}");
        let text = folder.done("explain cut.toml");
        assert!(text.text().contains("below min_weight"), "{}", text.text());
    }
}

/// A lamp that is off, and mirrors that show no lamp's light, need no shadow rays.
#[test]
fn what_no_lamp_lights_needs_no_shadow_rays() {
    let folder = Folder::new();
    let dark = "[[lights]]\nposition = [0, 9, 0]\nintensity = 0\n[[spheres]]\ncenter = [0, 0, -9]\n\
        radius = 1\ncolor = [1, 1, 1]\n";
    folder.write("off.toml", dark);
    folder.write(
        "mirror.toml",
        dark.replace("intensity = 0", "intensity = 1") + "diffuse = 0\nreflect = 1\n",
    );
    folder.write("lit.toml", dark.replace("intensity = 0", "intensity = 1"));
    for (scene, needed) in [("off.toml", false), ("mirror.toml", false), ("lit.toml", true)] {
        let told = folder.done(&format!("explain {scene} --json")).json();
        assert_eq!(told["needs"]["shadow_rays"], needed, "{scene}");
        let omitted = told["plan"]["omitted"].to_string();
        assert_eq!(omitted.contains("shadows"), scene == "mirror.toml", "{scene}: {omitted}");
    }
}

#[test]
fn rays_end_by_themselves_or_go_on() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 2 --height 1 --max-depth 3 -o room.toml");
    let told = folder.done("explain room.toml --json").json();
    assert_eq!((&told["rays"]["deepest"], &told["rays"]["end"]), (&3.into(), &Value::Null));
    assert_eq!(told["has"]["primitives"]["around"], 1);
    assert!(told["caps"][0]["bound"].as_f64().is_some());
    assert!(told["caps"][0]["bound_endless"].is_null(), "light adds up without end");
    let text = folder.done("explain room.toml");
    assert!(text.text().contains("some still go on") && text.text().contains("no bound"));

    let told = folder.done("explain scene.toml --json").json();
    let end = told["rays"]["end"].as_u64().expect("an end");
    folder.done(&format!("render scene.toml -o a.pfm --max-depth {end} --quiet"));
    folder.done(&format!("render scene.toml -o b.pfm --max-depth {} --quiet", end + 10));
    assert_eq!(folder.read("a.pfm"), folder.read("b.pfm"));
}
