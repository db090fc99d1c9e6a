//! The page of a ray's life: stepped, looked at, and without its script.

use super::open;
use crate::program::{Folder, reference};

/// What an element of a document holds that begins with these words.
fn held<'d>(document: &'d str, element: &str) -> &'d str {
    let (_, rest) = document.split_once(element).unwrap_or_else(|| panic!("no {element}"));
    let (_, rest) = rest.split_once('>').expect("a tag ends");
    rest.split_once("</").expect("an element ends").0
}

/// A page of the pixel of [`crate::program::SCENE`] whose path is the longest.
fn page_of_a_ray(folder: &Folder) {
    folder.done("explain scene.toml --pixel 8,5 --html ray.html");
}

#[test]
fn the_last_step_of_a_ray_shows_the_rendered_pixel() {
    let folder = Folder::new();
    page_of_a_ray(&folder);
    let Some(opened) = open(&folder, "ray.html#last") else { return };
    assert_eq!(opened.console, [""; 0]);
    folder.done("render scene.toml -o a.png --quiet");
    let picture = image::load_from_memory(&folder.read("a.png")).expect("a PNG").into_rgb8();
    let levels = picture.get_pixel(8, 5).0;
    let shown = levels.map(|level| level.to_string()).join(" ");
    assert!(opened.document.contains(&format!("id=\"colour\" data-levels=\"{shown}\"")), "{shown}");
    let linear = reference(None, 1).pixels()[5 * 13 + 8].map(|x| x.to_string()).join(" ");
    assert_eq!(held(&opened.document, "id=\"colour\""), linear);
    // Swatches of that colour are on the screen: of the step, of the log, of the pixel.
    let swatch = opened.screen.pixels().filter(|pixel| pixel.0 == levels).count();
    assert!(swatch > 500, "{swatch} pixels of the colour");
    assert!(
        opened.document.contains("id=\"to-next\" title=\"Right arrow\" aria-disabled=\"true\"")
    );
    assert!(
        opened.document.contains("id=\"to-back\" title=\"Left arrow\" aria-disabled=\"false\"")
    );
    // What a screen reader is told.
    let spoken = held(&opened.document, "id=\"spoken\"");
    assert!(spoken.contains("Calls: 0, levels on the stack: 0"), "{spoken}");
    assert!(spoken.contains(&linear), "{spoken}");
    assert!(opened.document.contains("pixel 8,5 is marked\" width=\"312\""), "24 times enlarged");
}

/// To the end and back by keys and by buttons; what is shown is what the document says.
#[test]
fn a_ray_is_stepped_both_ways() {
    let folder = Folder::new();
    page_of_a_ray(&folder);
    let page = String::from_utf8(folder.read("ray.html")).expect("text");
    let script = include_str!("walk.js");
    let walk = format!("<pre id=\"walked\"></pre><script>{script}</script></body>");
    folder.write("walk.html", page.replace("</body>", &walk));
    let Some(opened) = open(&folder, "walk.html") else { return };
    assert_eq!(opened.console, [""; 0]);

    let told = folder.done("explain scene.toml --pixel 8,5 --json").json();
    let steps = told["steps"].as_array().expect("steps");
    let (mut colour, mut levels) = ("none yet".to_owned(), 0);
    let mut expected = Vec::new();
    for (i, step) in (1..).zip(steps) {
        levels += i32::from(step["engine"] == "push") - i32::from(step["recursion"] == "fold");
        if let Some(back) = step["colour"].as_array() {
            let back = back.iter().map(|x| x.as_f64().expect("a number").to_string());
            colour = back.collect::<Vec<_>>().join(" ");
        }
        let word = step["recursion"].as_str().expect("a word").to_owned();
        expected.push((format!("step {i} of {}", steps.len()), word, colour.clone(), levels));
    }
    assert!(
        expected.iter().any(|(_, word, _, levels)| word == "fold" && *levels > 0),
        "two mirrors"
    );
    // A button at the end keeps the focus, the drawing stays, the log follows inside its box.
    let said = "data-focus=\"to-next\" data-tops=\"1\" data-unseen=\"0\" data-page=\"0\"";
    assert!(
        opened.document.contains(said),
        "{}",
        opened.document.split("id=\"walked\"").last().unwrap_or_default()
    );
    let there_and_back: Vec<_> = expected.iter().chain(expected.iter().rev().skip(1)).collect();
    let walked: Vec<&str> = held(&opened.document, "id=\"walked\"").lines().collect();
    assert_eq!(walked.len(), there_and_back.len());
    for (line, (at, word, colour, levels)) in walked.into_iter().zip(there_and_back) {
        let parts: Vec<&str> = line.split("; ").collect();
        let [status, recursion, shown, stack] = parts[..] else { panic!("{line}") };
        assert_eq!((status, shown), (at.as_str(), colour.as_str()));
        assert_eq!(stack, levels.to_string(), "{line}");
        assert!(recursion.starts_with(word) || recursion.starts_with("meet"), "{line}: {word}");
    }
}

#[test]
fn a_very_deep_ray_has_a_page_too() {
    let folder = Folder::new();
    folder.done("generate room --reflect 1 --width 8 --height 6 --max-depth 5000 -o deep.toml");
    folder.done("explain deep.toml --pixel 3,2 --html deep.html");
    let Some(opened) = open(&folder, "deep.html#last") else { return };
    assert_eq!(opened.console, [""; 0]);
    let told = folder.done("explain deep.toml --pixel 3,2 --json").json();
    let levels = told["levels"].as_array().expect("levels").iter().map(ToString::to_string);
    let levels = levels.collect::<Vec<_>>().join(" ");
    assert!(opened.document.contains(&format!("id=\"colour\" data-levels=\"{levels}\"")));
    assert_eq!(held(&opened.document, "id=\"status\""), "step 20003 of 20003");
    assert!(held(&opened.document, "id=\"stack\"").contains("stack empty"));
    // At the deepest ray everything waits, and most of it as one line.
    let opened = open(&folder, "deep.html#step=10001").expect("a browser");
    let stack = opened.document.split_once("id=\"stack\"").expect("a stack").1;
    let stack = stack.split_once("</ol>").expect("an end").0;
    assert_eq!(stack.matches("<li").count(), 6 + 1 + 3, "{stack}");
    assert!(stack.contains("… 4991 more"), "5000 levels in all: {stack}");
    let calls = opened.document.split_once("id=\"calls\"").expect("calls").1;
    assert!(calls.split_once("</ol>").expect("an end").0.contains("… 4992 more"), "5001 calls");
}

/// The log stands in the page itself.
#[test]
fn without_scripts_the_log_is_there() {
    let folder = Folder::new();
    page_of_a_ray(&folder);
    let page = String::from_utf8(folder.read("ray.html")).expect("text");
    folder.write("plain.html", page.replace("script-src 'unsafe-inline'; ", ""));
    let Some(opened) = open(&folder, "plain.html") else { return };
    assert!(opened.console.iter().all(|line| line.contains("script")), "{:?}", opened.console);
    assert!(opened.document.contains("<nav id=\"controls\" hidden"));
    assert!(opened.document.matches("<tr><td>").count() >= 6);
    assert!(held(&opened.document, "<tbody>").contains('1'));
    assert!(opened.document.contains("class=\"leg") && opened.document.contains("class=\"mark\""));
}
