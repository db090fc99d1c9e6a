//! The pages that the program writes, in a headless browser.

use std::fs;
use std::io::Write;
use std::process::Command;

use crate::program::{Folder, reference};

/// Names under which Chromium is installed.
const BROWSERS: [&str; 4] = ["chromium", "chromium-browser", "google-chrome", "chrome"];

/// What a browser made of a page.
pub(crate) struct Opened {
    /// The document after it was loaded, as HTML.
    pub(crate) document: String,
    /// What the browser had to say about it: errors, and requests that the page's own policy
    /// refuses.
    pub(crate) console: Vec<String>,
    /// What it looks like.
    pub(crate) screen: image::RgbImage,
}

/// Opens a page; `None` where there is no browser, which is said.
pub(crate) fn open(folder: &Folder, page: &str) -> Option<Opened> {
    let has = |name: &&&str| Command::new(name).arg("--version").output().is_ok();
    let Some(browser) = BROWSERS.iter().find(has) else {
        let required = std::env::var_os("CATOPTRIC_REQUIRE_TOOLS").is_some();
        assert!(!required, "a browser is required here: one of {BROWSERS:?}");
        // Not by `println!`, which the test runner keeps to itself where a test passes.
        let why = format!("skipped {page} in a browser: none of {BROWSERS:?} is there\n");
        let _ = std::io::stderr().write_all(why.as_bytes());
        return None;
    };
    let run = |what: &[&str]| {
        let profile = folder.path("profile");
        let output = Command::new(browser)
            .args(["--headless", "--no-sandbox", "--disable-gpu", "--hide-scrollbars"])
            .args(["--enable-logging=stderr", "--window-size=1000,3000"])
            .arg(format!("--user-data-dir={}", profile.display()))
            .args(what)
            .arg(format!("file://{}", folder.path(page).display()))
            .output()
            .expect("the browser runs");
        let text = |bytes: &[u8]| String::from_utf8_lossy(bytes).into_owned();
        (text(&output.stdout), text(&output.stderr))
    };
    let (document, log) = run(&["--dump-dom"]);
    let console = log.lines().filter(|line| line.contains("CONSOLE")).map(str::to_owned).collect();
    let picture = folder.path("screen.png");
    run(&[&format!("--screenshot={}", picture.display())]);
    let screen = image::load_from_memory(&fs::read(picture).expect("a screenshot"));
    Some(Opened { document, console, screen: screen.expect("a PNG").into_rgb8() })
}

#[test]
fn a_study_s_page_shows_its_plots_and_asks_for_nothing() {
    let folder = Folder::new();
    folder.done("study depth scene.toml --depths 0,1,2 --repeat 1 -o deep --quiet");
    let Some(opened) = open(&folder, "deep/index.html") else { return };
    assert_eq!(opened.console, [""; 0]);
    assert_eq!(opened.document.matches("<svg").count(), 4);
    assert!(opened.document.contains("Cost against depth"));
    // The first curve's colour is on the screen.
    let blue = opened.screen.pixels().filter(|pixel| pixel.0 == [0x00, 0x72, 0xb2]).count();
    assert!(blue > 100, "{blue} pixels of the first curve");
}

#[test]
fn what_a_page_asks_for_is_seen() {
    let folder = Folder::new();
    folder.done("study depth scene.toml --depths 0 --repeat 1 -o deep --quiet");
    let page = String::from_utf8(folder.read("deep/index.html")).expect("text");
    let asks = "<body><img src=\"http://127.0.0.1:9/asked.png\">";
    folder.write("deep/index.html", page.replace("<body>", asks));
    let Some(opened) = open(&folder, "deep/index.html") else { return };
    assert!(opened.console.iter().any(|line| line.contains("asked.png")), "{:?}", opened.console);
}

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
    assert!(opened.document.contains("id=\"to-next\" title=\"Right arrow\" disabled"));
}

/// To the end and back by keys and by buttons; what is shown is what the document says.
#[test]
fn a_ray_is_stepped_both_ways() {
    let folder = Folder::new();
    page_of_a_ray(&folder);
    let page = String::from_utf8(folder.read("ray.html")).expect("text");
    let script = include_str!("browser/walk.js");
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
    assert!(stack.matches("<li").count() < 15 && stack.contains(" more"), "{stack}");
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
