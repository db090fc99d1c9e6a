//! The pages that the program writes, in a headless browser.

mod ray;

use std::fs;
use std::io::Write;
use std::process::Command;

use crate::program::Folder;

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
