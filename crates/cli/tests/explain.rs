//! `explain` from outside: what it says is what the picture is.

use serde_json::Value;

use crate::program::{Folder, reference};

/// The widest line that a terminal of 80 columns shows whole.
const COLUMNS: usize = 80;

/// A colour or a k, read back to its bits.
fn single(value: &Value) -> f32 {
    let digits = value.as_f64().unwrap_or_else(|| panic!("no number: {value}")).to_string();
    digits.parse().expect("a number")
}

/// Numbers of a list.
fn numbers(value: &Value) -> Vec<f32> {
    let list = value.as_array().unwrap_or_else(|| panic!("no list: {value}"));
    list.iter().map(single).collect()
}

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

/// Every pixel: the steps are a recursion's, they add up, and they end in the picture's colour.
#[test]
fn steps_end_in_the_pictures_colour() {
    let folder = Folder::new();
    let film = reference(None, 1);
    let mut deepest = 0;
    for (x, y) in (0..7).flat_map(|y| (0..13).map(move |x| (x, y))) {
        let told = folder.done(&format!("explain scene.toml --pixel {x},{y} --json")).json();
        assert_eq!(told["schema"], "catoptric-explain-pixel");
        let colour = film.pixels()[y * 13 + x];
        assert_eq!(numbers(&told["colour"]), colour, "{x},{y}");

        let steps = told["steps"].as_array().expect("steps");
        let mut pending: Vec<(Value, Value)> = Vec::new();
        let mut stack: Vec<(Value, Value)> = Vec::new();
        let mut back = Value::Null;
        for (i, step) in (1..).zip(steps) {
            assert_eq!(step["step"], i);
            let owed = (step["local"].clone(), step["k"].clone());
            match step["engine"].as_str() {
                Some("push") => stack.push(owed.clone()),
                Some("fold") => assert_eq!(stack.pop(), Some(owed.clone()), "{x},{y}"),
                _ => {}
            }
            match step["recursion"].as_str().expect("a word") {
                "call" => assert_eq!(step["depth"], pending.len()),
                "hit" if step["followed"] == true => pending.push(owed),
                "hit" => {}
                "fold" => {
                    assert_eq!(pending.pop(), Some(owed));
                    assert_eq!(step["back"], back, "{x},{y}: what has come back is folded");
                    assert_eq!(step["depth"], pending.len());
                    let (local, back) = (numbers(&step["local"]), numbers(&step["back"]));
                    let k = single(&step["k"]);
                    let sum: Vec<f32> = (0..3).map(|c| local[c] + k * back[c]).collect();
                    assert_eq!(numbers(&step["colour"]), sum, "{x},{y}");
                }
                "return" => back = step["colour"].clone(),
                other => panic!("{other}"),
            }
        }
        assert!(pending.is_empty() && stack.is_empty());
        assert_eq!(numbers(&back), colour, "{x},{y}: the last step returns the colour");
        deepest = deepest.max(told["deepest"].as_u64().expect("a depth"));
    }
    assert_eq!(deepest, 4, "some path is as deep as allowed");
}

#[test]
fn words_fit_a_terminal_and_hold_the_same_numbers() {
    let folder = Folder::new();
    let told = folder.done("explain scene.toml --pixel 4,3");
    let json = folder.done("explain scene.toml --pixel 4,3 --json").json();
    for colour in numbers(&json["colour"]) {
        let digits = colour.to_string();
        assert!(told.text().contains(&digits), "{digits} is not in {}", told.text());
    }
    for ran in [told, folder.done("explain scene.toml")] {
        let long = ran.text().lines().find(|line| line.chars().count() > COLUMNS);
        assert_eq!(long, None);
    }
}

/// Past the recursion's stack the loop tells its side; past the ladder's nothing is told.
#[test]
fn deep_paths_are_told_to_the_end() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 100001 -o deep.toml");
    let told = folder.done("explain deep.toml --pixel 0,0 --json").json();
    assert_eq!(told["rungs"], serde_json::json!(["r3", "r5"]));
    assert_eq!(told["deepest"], 100_001);
    assert_eq!(told["steps"].as_array().expect("steps").len(), 4 * 100_001 + 3);

    let page = "explain deep.toml --pixel 0,0 --html deep.html";
    folder.done(page);
    let page = String::from_utf8(folder.read("deep.html")).expect("text");
    assert!(page.len() < 2 << 20, "{} bytes", page.len());
    assert!(page.contains("steps, in the middle of the path, are not on this page"));
    assert!(page.contains("more are not"), "hits that are not drawn are counted");

    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 4294967295 -o e.toml");
    let ran = folder.run("explain e.toml --pixel 0,0");
    assert_eq!(ran.code, Some(1), "{}", ran.stderr);
    assert!(ran.stderr.contains("more than 1000000 reflections"), "{}", ran.stderr);
    assert!(ran.stdout.is_empty());
}

#[test]
fn a_page_is_one_file_with_nothing_to_fetch() {
    let folder = Folder::with(&crate::program::SCENE.replace("[image]", "# </script>\n[image]"));
    std::fs::rename(folder.path("scene.toml"), folder.path("a<b>&.toml")).expect("a name");
    let ran = folder.done("explain a<b>&.toml --pixel 3,4 --html page.html");
    assert!(ran.stdout.is_empty() && ran.stderr.contains("page.html"), "{}", ran.stderr);
    let page = String::from_utf8(folder.read("page.html")).expect("text");
    assert!(page.contains("<title>a&lt;b&gt;&amp;.toml, pixel 3,4 of 13x7</title>"));
    assert!(page.contains("default-src 'none'") && page.contains("data:image/png;base64,"));
    assert_eq!(page.matches("://").count(), page.matches("http://www.w3.org/2000/svg").count());
    assert!(!page.contains("{{"), "every place of the template is filled");
    // Both at once: the page to its file, the document to stdout.
    let ran = folder.done("explain a<b>&.toml --pixel 3,4 --html page.html --json");
    assert_eq!(ran.json()["x"], 3);
    let ran = folder.done("explain a<b>&.toml --pixel 3,4 --html -");
    assert_eq!(ran.text(), page);
}

/// A number of a drawn element.
fn attribute(element: &str, name: &str) -> f64 {
    let (_, rest) = element.split_once(&format!(" {name}=\"")).expect("that attribute");
    rest.split_once('"').expect("its end").0.parse().expect("a number")
}

/// A leg for each ray and a dot for each hit, in the drawing and on what was hit.
#[test]
fn the_path_is_drawn() {
    let folder = Folder::new();
    folder.done("generate kissing --max-depth 12 -o kissing.toml");
    let (mut reflected, mut on_spheres) = (0, 0);
    for (scene, x, y) in [
        ("scene.toml", 8, 5),
        ("scene.toml", 4, 5),
        ("scene.toml", 0, 0),
        ("kissing.toml", 320, 240),
        ("kissing.toml", 300, 220),
    ] {
        let told = folder.done(&format!("explain {scene} --pixel {x},{y} --json")).json();
        folder.done(&format!("explain {scene} --pixel {x},{y} --html page.html"));
        let page = String::from_utf8(folder.read("page.html")).expect("text");
        let drawn = page.split_once("<svg").and_then(|(_, rest)| rest.split_once("</svg>"));
        let drawn: Vec<&str> = drawn.expect("a drawing").0.split('<').collect();
        let of = |name: &str| {
            let kind = |element: &&&str| element.contains(&format!("class=\"{name}"));
            drawn.iter().filter(kind).copied().collect::<Vec<_>>()
        };
        let steps = told["steps"].as_array().expect("steps");
        let count = |word: &str| steps.iter().filter(|step| step["recursion"] == word).count();
        let (legs, dots) = (of("leg"), of("hit"));
        assert_eq!(legs.len(), count("call"), "{scene} {x},{y}");
        // The eye has one too.
        assert_eq!(dots.len(), count("hit") + 1, "{scene} {x},{y}");
        for leg in &legs {
            let (x, y) = (attribute(leg, "x2"), attribute(leg, "y2"));
            assert!((0.0..=640.0).contains(&x) && (0.0..=480.0).contains(&y), "{leg}");
        }
        let spheres = of("sphere").into_iter().filter(|element| element.contains(" r=\""));
        let spheres: Vec<&str> = spheres.collect();
        let hits = steps.iter().filter(|step| step["recursion"] == "hit");
        for (dot, hit) in dots[1..].iter().zip(hits) {
            if hit["primitive"].as_str().is_some_and(|name| name.starts_with("spheres")) {
                let within = |circle: &&str| {
                    let off = |name| attribute(dot, name) - attribute(circle, name);
                    off("cx").hypot(off("cy")) <= attribute(circle, "r") + 0.02
                };
                assert!(spheres.iter().any(within), "{scene} {x},{y}: {dot}");
                on_spheres += 1;
            }
        }
        reflected += legs.len() - 1;
    }
    assert!(reflected >= 8 && on_spheres >= 8, "{reflected}, {on_spheres}");
}

#[test]
fn what_cannot_be_meant_is_refused() {
    let folder = Folder::new();
    folder.write("bad.toml", "width = 3");
    let large =
        crate::program::SCENE.replace("width = 13\nheight = 7", "width = 65535\nheight = 65535");
    folder.write("large.toml", large);
    for (arguments, code, says) in [
        ("explain", 2, "SCENE"),
        ("explain scene.toml --pixel 13,0", 2, "X from 0 to 12 and Y from 0 to 6"),
        ("explain scene.toml --pixel 0,7", 2, "not in the image of 13x7"),
        ("explain scene.toml --pixel 1", 2, "two whole numbers"),
        ("explain scene.toml --pixel -1,2", 2, "two whole numbers"),
        ("explain scene.toml --pixel 1,2,3", 2, "two whole numbers"),
        ("explain scene.toml --html page.html", 2, "--pixel"),
        ("explain scene.toml --pixel 1,2 --json --html -", 2, "stdout"),
        ("explain scene.toml --pixel 1,2 --html scene.toml", 2, "the scene itself"),
        ("explain missing.toml", 3, "missing.toml"),
        ("explain bad.toml", 3, "width"),
        ("explain large.toml", 3, "image.width"),
        ("explain scene.toml --pixel 1,2 --html no/page.html", 4, "no/page.html"),
    ] {
        let before = folder.contents();
        let ran = folder.run(arguments);
        assert_eq!(ran.code, Some(code), "{arguments}: {}", ran.stderr);
        assert!(ran.stderr.contains(says), "{arguments}: {}", ran.stderr);
        assert!(ran.stdout.is_empty(), "{arguments}");
        assert_eq!(folder.contents(), before, "{arguments}");
    }
    // One pixel of a picture that is too large for two films, and a page of it.
    folder.done("explain large.toml --pixel 65534,65534");
    folder.done("explain large.toml --pixel 65534,0 --html large.html");
}

#[test]
fn a_reader_that_goes_is_4() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 1 --height 1 --max-depth 20000 -o deep.toml");
    let ran = folder.shell("catoptric explain deep.toml --pixel 0,0 | head -c 10; exit 0");
    assert!(ran.stderr.contains("cannot be written"), "{}", ran.stderr);
}
