//! The steps that a page holds: all of a path, or both ends of a very deep one.

use catoptric_ladder::Event;
use serde::Serialize;

use crate::life::Life;
use crate::life::text::{Told, number, rgb, tell};

/// Levels at either end of a path that the page holds.
const LEVELS: u32 = 200;

/// A step as the page's script reads it.
#[derive(Serialize)]
pub(super) struct Step {
    /// Number of the step from 1, counting what the page leaves out.
    pub(super) number: usize,
    pub(super) depth: u32,
    /// What the recursion does, in a word; `gap` for steps that the page leaves out.
    pub(super) kind: &'static str,
    #[serde(skip)]
    pub(super) recursion: String,
    #[serde(skip)]
    pub(super) engine: String,
    pub(super) numbers: Vec<(&'static str, String)>,
    /// A hit whose mirror is followed.
    pub(super) owed: Option<Owed>,
    /// The colour at hand after the step.
    pub(super) colour: Option<Colour>,
    pub(super) gap: Option<Gap>,
}

/// What is put on the stack.
#[derive(Serialize)]
pub(super) struct Owed {
    k: String,
    local: String,
    css: String,
}

/// A colour that has come back.
#[derive(Serialize)]
pub(super) struct Colour {
    text: String,
    /// Levels in an 8-bit picture.
    levels: [u8; 3],
    pub(super) css: String,
}

/// Levels in the middle of the path.
#[derive(Serialize)]
pub(super) struct Gap {
    down: bool,
    levels: u32,
    /// The deepest of them.
    deepest: u32,
}

/// The steps of the page, and how many of the ray's are left out.
pub(super) fn steps(life: &Life) -> (Vec<Step>, usize) {
    let deepest = life.deepest();
    // Levels that are left out; none of a path that is a little longer than both ends.
    let middle = if deepest > 2 * LEVELS + 10 { LEVELS..deepest - LEVELS } else { 0..0 };
    let (mut steps, mut hidden) = (Vec::new(), 0);
    for (index, event) in life.events.iter().enumerate() {
        if !middle.contains(&event.depth()) {
            steps.push(step(life, index));
            continue;
        }
        hidden += 1;
        if steps.last().is_none_or(|last: &Step| last.gap.is_none()) {
            let down = matches!(event, Event::Call { .. });
            let levels = middle.end - middle.start;
            steps.push(gap(index, Gap { down, levels, deepest: middle.end - 1 }));
        }
    }
    (steps, hidden)
}

fn step(life: &Life, index: usize) -> Step {
    let Told { recursion, engine, numbers } = tell(life, index);
    let event = &life.events[index];
    let owed = match *event {
        Event::Hit { local, k, followed: true, .. } => {
            Some(Owed { k: number(k), local: rgb(local), css: css(life, local.into()) })
        }
        _ => None,
    };
    let colour = match *event {
        Event::Fold { colour, .. } | Event::Return { colour, .. } => {
            let levels = life.levels(colour.into());
            Some(Colour { text: rgb(colour), levels, css: css(life, colour.into()) })
        }
        _ => None,
    };
    let kind = life.roles(index).recursion;
    let depth = event.depth();
    Step { number: index + 1, depth, kind, recursion, engine, numbers, owed, colour, gap: None }
}

fn gap(index: usize, gap: Gap) -> Step {
    let (first, last) = (gap.deepest + 1 - gap.levels, gap.deepest);
    Step {
        number: index + 1,
        depth: if gap.down { first } else { last },
        kind: "gap",
        recursion: format!("... depths {first} to {last} are left out here"),
        engine: format!("... levels {first} to {last}"),
        numbers: Vec::new(),
        owed: None,
        colour: None,
        gap: Some(gap),
    }
}

/// A colour as it is in the 8-bit picture.
pub(super) fn css(life: &Life, colour: [f32; 3]) -> String {
    let [r, g, b] = life.levels(colour);
    format!("rgb({r},{g},{b})")
}
