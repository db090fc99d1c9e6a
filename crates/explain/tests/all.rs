//! Explanations as a library gives them: documents, words, pages, and what is refused.

use catoptric_core::Isa;
use catoptric_explain::{Account, ExplainError, Life, Picture, Pixel, page};
use catoptric_scene::{Compiled, Film, Grid, Scene, View};
use catoptric_study::tracer::Tracer;
use catoptric_tests::scenes::{named, sized};
use serde_json::Value;

fn workshop(width: u32, height: u32) -> Scene {
    sized(&named("workshop"), width, height, 5)
}

fn document(explained: &impl serde::Serialize) -> Value {
    serde_json::to_value(explained).expect("a document")
}

fn single(value: &Value) -> f32 {
    value.as_f64().expect("a number") as f32
}

#[test]
fn every_life_ends_in_the_recursions_colour() {
    let scene = workshop(12, 9);
    let mut film = Film::new(12, 9);
    let grid = Grid::new(&View::whole(&scene));
    Tracer::Recursive.render(&Compiled::new(&scene), &grid, &mut film).expect("no deep path");
    for (index, colour) in (0..).zip(film.pixels()) {
        let pixel = Pixel { x: index % 12, y: index / 12 };
        let life = Life::new("a", &scene, pixel, Isa::Portable).expect("a life");
        let told = document(&life);
        let found: Vec<f32> = (0..3).map(|i| single(&told["colour"][i])).collect();
        assert_eq!(found, colour, "{pixel:?}");
        assert_eq!(told["steps"].as_array().map(Vec::len), Some(life.steps()));
    }
}

#[test]
fn a_pixel_outside_the_image_is_refused() {
    let scene = workshop(12, 9);
    for pixel in [Pixel { x: 12, y: 0 }, Pixel { x: 0, y: 9 }] {
        let refused = Life::new("a", &scene, pixel, Isa::Portable).map(|life| life.steps());
        assert!(matches!(refused, Err(ExplainError::NoPixel { .. })), "{refused:?}");
        assert!(pixel.check(&scene).is_err());
    }
    let error = Pixel { x: 12, y: 0 }.check(&scene).expect_err("outside");
    assert!(error.to_string().ends_with("allowed are X from 0 to 11 and Y from 0 to 8"), "{error}");
}

#[test]
fn an_account_says_the_same_in_words_and_as_a_document() {
    let scene = workshop(32, 24);
    let account = Account::new("bench.toml", &scene, Isa::Portable).expect("an account");
    let told = document(&account);
    let mut words = Vec::new();
    account.write(&mut words).expect("memory takes all");
    let words = String::from_utf8(words).expect("text");
    assert!(words.starts_with("bench.toml\n32x24 pixels, transfer "), "{words}");
    assert_eq!(told["schema"], "catoptric-explain");
    assert_eq!(told["scene"], "bench.toml");
    let enough = told["enough"]["same_bits"].as_u64().expect("a depth");
    assert!(words.contains(&format!("  {enough:<10} changes no bit of the picture")), "{words}");
    assert_eq!(Account::memory(&scene), 32 * 24 * 24);
}

#[test]
fn a_page_holds_the_picture_as_the_caller_makes_it_a_file() {
    for (width, height, side) in [(32, 24, (32, 24)), (1000, 10, (800, 8))] {
        let scene = workshop(width, height);
        let life = Life::new("a", &scene, Pixel { x: 3, y: 2 }, Isa::Portable).expect("a life");
        let png = |picture: &Picture| {
            assert_eq!((picture.width, picture.height), side);
            assert_eq!(picture.pixels.len() as u32, side.0 * side.1);
            b"a picture".to_vec()
        };
        let page = page(&life, Isa::Portable, png).expect("a page");
        assert!(page.contains("data:image/png;base64,YSBwaWN0dXJl"));
        assert!(!page.contains("{{"), "every value of the template is filled in");
    }
}
