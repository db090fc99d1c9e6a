//! A ray's life in words: what the recursion does beside what the engine does, and below it the
//! numbers of both. For a terminal of 80 columns, and for the page.

use std::io::{self, Write};

use catoptric_ladder::Event;

use super::{Last, Life};
use crate::pixel::Pixel;
use crate::words::{self, numerics};

/// One event as people read it.
pub(crate) struct Told {
    /// What the recursion does.
    pub(crate) recursion: String,
    /// What the engine does.
    pub(crate) engine: String,
    /// Names and values; no name goes on with the line before.
    pub(crate) numbers: Vec<(&'static str, String)>,
}

impl Life<'_> {
    /// Writes it in words, for a terminal of 80 columns.
    ///
    /// # Errors
    /// What `to` fails with.
    pub fn write(&self, to: &mut dyn Write) -> io::Result<()> {
        write(self, to)
    }
}

fn write(life: &Life, to: &mut dyn Write) -> io::Result<()> {
    for line in about(life) {
        writeln!(to, "{line}")?;
    }
    writeln!(to, "\n{:>6}  {:<34}  the engine", "step", "the recursion")?;
    for index in 0..life.steps() {
        let (number, told) = (index + 1, tell(life, index));
        let line = format!("{number:>6}  {:<34}  {}", told.recursion, told.engine);
        writeln!(to, "{}", line.trim_end())?;
        for (name, value) in told.numbers {
            writeln!(to, "{:8}{name:>11} {value}", "")?;
        }
    }
    let levels = life.levels(life.colour).map(|level| level.to_string()).join(" ");
    writeln!(to, "\nThe pixel: {}, 8-bit {levels}", rgb(life.colour))
}

/// What is told, and of what.
pub(crate) fn about(life: &Life) -> Vec<String> {
    let Pixel { x, y } = life.pixel;
    let image = life.scene.image;
    let [ex, ey, ez] = life.scene.camera.position;
    let render = life.scene.render;
    let limits = format!("max_depth {}, min_weight {}", render.max_depth, render.min_weight);
    vec![
        format!("{}, pixel {x},{y} of {}x{}", words::name(life.name), image.width, image.height),
        format!("numerics {}, {limits}; reflections: {}", numerics(life.scene), life.deepest()),
        format!("points are relative to the eye, which is at {ex} {ey} {ez}"),
        format!(
            "rungs {} ({}) and {} ({}) say the same, bit for bit",
            life.recursion.name, life.recursion.title, life.engine.name, life.engine.title
        ),
    ]
}

/// Puts an event in words.
pub(crate) fn tell(life: &Life, index: usize) -> Told {
    let told = |recursion: String, engine: String, numbers| Told { recursion, engine, numbers };
    match life.events[index] {
        // A call is one more frame; in the engine the next ray takes the place of the last.
        Event::Call { depth, origin, direction, weight } => told(
            format!("call trace, depth {depth}"),
            match depth {
                0 => "ray 0 sets out, stack empty".to_owned(),
                _ => format!("ray {depth} overwrites ray {}", depth - 1),
            },
            vec![
                ("origin", rgb(origin)),
                ("direction", rgb(direction)),
                ("weight", self::weight(life, weight)),
            ],
        ),
        // A hit either owes its mirror's part, which the engine pushes, or ends the path.
        Event::Hit { depth, primitive, distance, local, k, followed } => {
            let name = life.stated(primitive);
            let mut numbers = vec![("distance", number(distance)), ("local", rgb(local))];
            if followed {
                numbers.push(("k", number(k)));
                let recursion = format!("hit {name}, wait for mirror");
                return told(recursion, format!("push level {depth}: (local, k)"), numbers);
            }
            numbers.push(("k", format!("{} (the scene's: the engine keeps none)", number(k))));
            numbers.extend(why(life, depth, k).map(|why| ("", why)));
            told(format!("hit {name}, the last"), format!("level {depth} owes nothing"), numbers)
        }
        // A fold pays what was owed.
        Event::Fold { depth, local, k, back, colour } => told(
            format!("fold at depth {depth}"),
            format!("pop level {depth}: fold back"),
            vec![
                ("local", rgb(local)),
                ("+ k · back", format!("{} · ({})", number(k), rgb(back))),
                ("colour", rgb(colour)),
            ],
        ),
        // A ray that meets nothing returns the background, and others what was folded.
        Event::Return { depth, colour } if life.misses(index) => told(
            "meet nothing: return background".to_owned(),
            format!("level {depth} owes nothing"),
            vec![("colour", rgb(colour))],
        ),
        Event::Return { depth, colour } => told(
            match depth {
                0 => "return the pixel's colour".to_owned(),
                _ => format!("return to depth {}", depth - 1),
            },
            match depth {
                0 => "stack empty: the pixel's colour".to_owned(),
                _ => String::new(),
            },
            vec![("colour", rgb(colour))],
        ),
    }
}

/// A ray's weight, and whose it is.
fn weight(life: &Life, weight: Option<f32>) -> String {
    match weight {
        Some(weight) if life.engine_forms_weights => number(weight),
        Some(weight) => format!("{} (the recursion's: the engine forms none)", number(weight)),
        None => "none".to_owned(),
    }
}

/// Why a mirror is not followed, if it is one.
fn why(life: &Life, depth: u32, k: f32) -> Option<String> {
    let render = life.scene.render;
    match life.last(depth, k) {
        Last::NoMirror => None,
        Last::MaxDepth => Some(format!("not followed: max_depth is {}", render.max_depth)),
        Last::MinWeight => Some(format!("not followed: its weight is below {}", render.min_weight)),
    }
}

/// Three numbers.
pub(crate) fn rgb(values: impl Into<[f32; 3]>) -> String {
    values.into().map(number).join(" ")
}

/// Every digit that tells it from its neighbours.
pub(crate) fn number(x: f32) -> String {
    let size = x.abs();
    if x == 0.0 || (1e-4..1e7).contains(&size) || !x.is_finite() {
        format!("{x}")
    } else {
        format!("{x:e}")
    }
}
