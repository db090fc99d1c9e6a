//! The page of a ray, as text: what it holds and what it draws.

use crate::program::{Folder, SCENE};

#[test]
fn a_page_is_one_file_with_nothing_to_fetch() {
    let folder = Folder::with(&SCENE.replace("[image]", "# </script>\n[image]"));
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

/// Whether a drawn surface is where a point is, up to the digits that are written.
fn covers(surface: &str, [x, y]: [f64; 2]) -> bool {
    if surface.starts_with("circle") {
        let [cx, cy, r] = ["cx", "cy", "r"].map(|name| attribute(surface, name));
        return (x - cx).hypot(y - cy) <= r + 0.02;
    }
    if surface.starts_with("rect") {
        let [width, height] = ["width", "height"].map(|name| attribute(surface, name));
        return (0.0..=width).contains(&x) && (0.0..=height).contains(&y);
    }
    let (_, rest) = surface.split_once("points=\"").expect("a polygon");
    let corners: Vec<[f64; 2]> = rest
        .split_once('"')
        .expect("an end")
        .0
        .split(' ')
        .map(|corner| {
            let (x, y) = corner.split_once(',').expect("two numbers");
            [x, y].map(|number| number.parse().expect("a number"))
        })
        .collect();
    // The corners go round one way, so an inner point is on one side of all edges.
    let sides = (0..corners.len()).map(|i| {
        let ([ax, ay], [bx, by]) = (corners[i], corners[(i + 1) % corners.len()]);
        ((bx - ax) * (y - ay) - (by - ay) * (x - ax)) / (bx - ax).hypot(by - ay)
    });
    let sides: Vec<f64> = sides.collect();
    sides.iter().all(|side| *side > -0.02) || sides.iter().all(|side| *side < 0.02)
}

/// The scene with a ball of a planet's kind for its ground.
fn on_a_ball() -> String {
    let plane = "[[planes]]\npoint = [0, -1, 0]\nnormal = [0, 1, 0]\n";
    assert!(SCENE.contains(plane));
    SCENE.replace(plane, "[[spheres]]\ncenter = [0, -10001, 0]\nradius = 10000\n")
}

/// The drawing of a page, element by element.
fn elements(page: &str) -> Vec<&str> {
    let drawn = page.split_once("<svg").and_then(|(_, rest)| rest.split_once("</svg>"));
    drawn.expect("a drawing").0.split('<').collect()
}

/// From above, a ground far wider than the drawing is behind all of it; from the side it is
/// below its rim.
#[test]
fn a_wide_ground_is_under_what_stands_on_it() {
    let folder = Folder::new();
    folder.write("ground.toml", on_a_ball());
    let mut seen = Vec::new();
    for (x, y) in (0..7).flat_map(|y| (0..13).map(move |x| (x, y))) {
        folder.done(&format!("explain ground.toml --pixel {x},{y} --html page.html"));
        let page = String::from_utf8(folder.read("page.html")).expect("text");
        let ground = elements(&page)
            .into_iter()
            .find(|element| element.contains("class=\"sphere\"") && !element.starts_with("circle"));
        let Some(ground) = ground else { continue };
        let corners = [[0.0, 0.0], [640.0, 0.0], [0.0, 480.0], [640.0, 480.0]];
        let covered = corners.iter().filter(|corner| covers(ground, **corner)).count();
        let above = page.contains("The scene seen from above");
        assert_eq!(covered, if above { 4 } else { 2 }, "{x},{y}: {ground}");
        if !above {
            assert!(covers(ground, [640.0, 480.0]), "{x},{y}: below");
        }
        seen.push(above);
    }
    assert!(seen.contains(&true) && seen.contains(&false), "{seen:?}");
}

/// A hit on a plane is on its rim, or on a piece of it, or before it.
#[test]
fn hits_on_planes_do_not_float() {
    let folder = Folder::new();
    let planes = "\
[[planes]]
point = [0, 0, -4]
normal = [0.4, 0.2, 1]
color = [0.5, 0.5, 0.6]
reflect = 0.9
";
    let tilted = SCENE.replace("look_at = [0, 0.2, 0]", "look_at = [0.4, -0.3, 0]");
    folder.write("walls.toml", format!("{tilted}\n{planes}"));
    let [mut on_rims, mut on_pieces] = [0, 0];
    for (x, y) in (0..7).flat_map(|y| (0..13).map(move |x| (x, y))) {
        let told = folder.done(&format!("explain walls.toml --pixel {x},{y} --json")).json();
        folder.done(&format!("explain walls.toml --pixel {x},{y} --html page.html"));
        let page = String::from_utf8(folder.read("page.html")).expect("text");
        let elements = elements(&page);
        let steps = told["steps"].as_array().expect("steps");
        let hits = steps.iter().filter(|step| step["recursion"] == "hit");
        let dots = elements.iter().filter(|element| element.contains("class=\"hit\"")).skip(1);
        for (depth, (hit, dot)) in hits.zip(dots).enumerate() {
            if !hit["primitive"].as_str().is_some_and(|name| name.starts_with("planes")) {
                continue;
            }
            let at = ["cx", "cy"].map(|name| attribute(dot, name));
            let of_hit = format!("class=\"tangent\" data-depth=\"{depth}\"");
            if let Some(piece) = elements.iter().find(|element| element.contains(&of_hit)) {
                let middle = [("x1", "x2", at[0]), ("y1", "y2", at[1])];
                for (a, b, at) in middle {
                    let off = (attribute(piece, a) + attribute(piece, b)) / 2.0 - at;
                    assert!(off.abs() < 0.02, "{x},{y}: {piece} at {dot}");
                }
                on_pieces += 1;
                continue;
            }
            let surfaces = elements.iter().filter(|element| element.contains("class=\"sphere\""));
            let off = |(right, down): (f64, f64)| [at[0] + right, at[1] + down];
            let on_rim = surfaces.filter(|surface| !surface.starts_with("circle")).any(|surface| {
                // Covered on one side, not on the other; or it is all behind.
                let around = [(0.1, 0.0), (-0.1, 0.0), (0.0, 0.1), (0.0, -0.1)];
                let covered = around.into_iter().filter(|by| covers(surface, off(*by))).count();
                surface.starts_with("rect") || (covered > 0 && covered < 4)
            });
            assert!(on_rim, "{x},{y}: {dot} of {hit}");
            on_rims += 1;
        }
    }
    assert!(on_rims > 5 && on_pieces > 5, "{on_rims}, {on_pieces}");
}

/// Text on what it stands on, WCAG 2.1: at least 4.5 to 1, light and dark.
#[test]
fn text_stands_out() {
    let folder = Folder::new();
    folder.done("explain scene.toml --pixel 8,5 --html page.html");
    let page = String::from_utf8(folder.read("page.html")).expect("text");
    let schemes: Vec<&str> = page.split(":root").skip(1).collect();
    assert_eq!(schemes.len(), 2, "light and dark");
    for scheme in schemes {
        let luminance = |name: &str| {
            let (_, rest) = scheme.split_once(&format!("--{name}: #")).expect(name);
            let digits = rest.split_once(';').expect("an end").0;
            let digits: Vec<u32> = digits.chars().map(|c| c.to_digit(16).expect("hex")).collect();
            let level = |i: usize| match digits.len() {
                3 => digits[i] * 17,
                _ => digits[2 * i] * 16 + digits[2 * i + 1],
            };
            let linear = |i: usize| {
                let s = f64::from(level(i)) / 255.0;
                if s <= 0.04045 { s / 12.92 } else { ((s + 0.055) / 1.055).powf(2.4) }
            };
            0.2126 * linear(0) + 0.7152 * linear(1) + 0.0722 * linear(2)
        };
        for text in ["text", "soft"] {
            for behind in ["page", "now", "soft-fill"] {
                let [a, b] = [text, behind].map(|name| luminance(name) + 0.05);
                let contrast = if a > b { a / b } else { b / a };
                assert!(contrast >= 4.5, "{text} on {behind}: {contrast:.2}");
            }
        }
    }
}

/// A leg for each ray and a dot for each hit, in the drawing and on what was hit.
#[test]
fn the_path_is_drawn() {
    let folder = Folder::new();
    folder.done("generate kissing --max-depth 12 -o kissing.toml");
    folder.write("ground.toml", on_a_ball());
    let far = SCENE.replace("[0.3, 0.5, 6]", "[1, 2, 80]").replace("fov = 40", "fov = 3");
    folder.write("far.toml", far);
    let [mut reflected, mut on_spheres, mut eyes_outside, mut named] = [0; 4];
    for (scene, x, y) in [
        ("scene.toml", 8, 5),
        ("scene.toml", 4, 5),
        ("scene.toml", 0, 0),
        ("ground.toml", 4, 5),
        ("far.toml", 4, 5),
        ("kissing.toml", 320, 240),
        ("kissing.toml", 300, 220),
    ] {
        let told = folder.done(&format!("explain {scene} --pixel {x},{y} --json")).json();
        folder.done(&format!("explain {scene} --pixel {x},{y} --html page.html"));
        let page = String::from_utf8(folder.read("page.html")).expect("text");
        let drawn = elements(&page);
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
        let within = |x, y| (0.0..=640.0).contains(&x) && (0.0..=480.0).contains(&y);
        for leg in &legs {
            assert!(within(attribute(leg, "x2"), attribute(leg, "y2")), "{leg}");
        }
        let outside = !within(attribute(dots[0], "cx"), attribute(dots[0], "cy"));
        assert_eq!(page.contains("The eye is outside the drawing."), outside, "{scene} {x},{y}");
        eyes_outside += usize::from(outside);
        for (depth, hit) in steps.iter().filter(|step| step["recursion"] == "hit").enumerate() {
            let name = format!(">{depth} {}<", hit["primitive"].as_str().expect("a name"));
            named += usize::from(page.contains(&name));
        }
        let surfaces = of("sphere");
        let hits = steps.iter().filter(|step| step["recursion"] == "hit");
        for (dot, hit) in dots[1..].iter().zip(hits) {
            if hit["primitive"].as_str().is_some_and(|name| name.starts_with("spheres")) {
                let at = ["cx", "cy"].map(|name| attribute(dot, name));
                let drawn = surfaces.iter().any(|surface| covers(surface, at));
                assert!(drawn, "{scene} {x},{y}: {dot} {surfaces:?}");
                on_spheres += 1;
            }
        }
        reflected += legs.len() - 1;
    }
    assert!(reflected >= 8 && on_spheres >= 8, "{reflected}, {on_spheres}");
    assert!(eyes_outside > 0 && named >= 8, "{eyes_outside}, {named}");
}
