//! Crops of truth, result and difference, of the instructive cases.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_report::Picture;
use catoptric_scene::family::Room;
use catoptric_scene::{Document, Draft, Quantiser, SceneFormat, Transfer, View};

use super::cases::scenes::{sized, workshop};
use super::generic::placed;
use crate::formula::Formula;

const TINY_FAR: &str = include_str!("../../../../scenes/tiny-far.toml");

/// A case to look at.
pub(crate) struct Crop {
    name: &'static str,
    /// One sentence: what to look for.
    pub(crate) text: &'static str,
    draft: Draft,
    /// Left, top, width, height.
    part: [u32; 4],
    /// Times a difference is shown: textbook, robust.
    times: [f64; 2],
}

/// All crops.
pub(crate) fn all() -> Vec<Crop> {
    let tiny = Document::parse("tiny-far.toml", TINY_FAR.as_bytes(), SceneFormat::Toml);
    let tiny = tiny.expect("the scene of scenes/").draft().clone();
    let room = Room { balls: 3, ..Room::default() }.draft().expect("in range");
    vec![
        Crop {
            name: "workshop-shadows",
            text: "The workshop's shadows: the literal offset, 1.0 on the ground, moves them and opens the contacts.",
            draft: workshop(640, 480, 8, 0.3),
            part: [150, 340, 240, 140],
            times: [4.0, 10_000.0],
        },
        Crop {
            name: "tiny-far",
            text: "Balls of radius 1 ten thousand away: the plain quadratic loses their rims.",
            draft: sized(tiny, 240, 240, 6),
            part: [0, 0, 240, 240],
            times: [4.0, 100.0],
        },
        Crop {
            name: "closed-room",
            text: "A closed room, 64 reflections: a normal that is not turned lets the background in, magenta; rounding alone is amplified where paths meet the balls often.",
            draft: sized(placed(&room), 200, 150, 64),
            part: [0, 0, 200, 150],
            times: [1.0, 1000.0],
        },
    ]
}

impl Crop {
    /// Truth, then for both formulas the result and its amplified difference.
    pub(crate) fn pictures(&self) -> Vec<Picture> {
        let scene = Formula::RobustF32.scene(&self.draft);
        let truth = Truth::new(&scene, Precision::DoubleDouble);
        let truth = truth.render(&View::whole(&scene)).expect("at most 64 reflections").pixels;
        let mut pictures = vec![self.picture("truth", "truth".to_owned(), &truth)];
        for (formula, times) in Formula::F32.into_iter().zip(self.times) {
            let found = formula.picture(&self.draft).expect("packets go any depth");
            let name = formula.name().replace(' ', "-");
            pictures.push(self.picture(&name, formula.name().to_owned(), &found));
            let pairs = found.iter().zip(&truth);
            let difference: Vec<[f64; 3]> =
                pairs.map(|(a, b)| std::array::from_fn(|c| times * (a[c] - b[c]).abs())).collect();
            let caption = format!("{} against truth, difference times {times}", formula.name());
            pictures.push(self.picture(&format!("{name}-difference"), caption, &difference));
        }
        pictures
    }

    #[expect(clippy::cast_possible_truncation, reason = "levels are made of f32")]
    fn picture(&self, name: &str, caption: String, pixels: &[[f64; 3]]) -> Picture {
        let quantiser = Quantiser::new(Transfer::Linear);
        let [left, top, width, height] = self.part;
        let at = |x: u32, y: u32| pixels[(y * self.draft.image.width + x) as usize];
        let places = (top..top + height).flat_map(|y| (left..left + width).map(move |x| (x, y)));
        let pixels = places.map(|(x, y)| at(x, y).map(|value| quantiser.level(value as f32)));
        let name = format!("{}-{name}", self.name);
        Picture { name, caption, width, height, pixels: pixels.collect(), zoom: 2 }
    }
}
