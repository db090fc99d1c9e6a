//! One eye ray's whole life, as two rungs of the ladder have it: the recursion, and the engine.
//!
//! Both tell it in the ladder's events, which are compared one by one: what is shown is what
//! both did, but for two numbers, which are then the recursion's alone: weights without a cut by
//! weight, and k of a mirror that is not followed.

mod json;
pub(crate) mod text;

use catoptric_core::{Isa, Settings};
use catoptric_ladder::{Event, RUNGS, Rung, Watch};
use catoptric_scene::{
    CameraAxes, Compiled, Crop, DoubleDouble, Film, Grid, Quantiser, Scene, View,
};
use catoptric_study::tracer::{STACK_LIMIT, Tracer};
use serde::Serialize;

use crate::error::ExplainError;
use crate::pixel::Pixel;

/// The life of a pixel's eye ray.
pub struct Life<'a> {
    /// The scene as the command line named it; `-` for stdin.
    pub(crate) name: &'a str,
    pub(crate) scene: &'a Scene,
    pub(crate) compiled: Compiled,
    pub(crate) pixel: Pixel,
    /// Who told the recursion's side: r0, or past the depth of its stack r3, the loop.
    pub(crate) recursion: &'static Rung,
    /// Who told the engine's side.
    pub(crate) engine: &'static Rung,
    /// The recursion's log, in the world's axes; the engine's agrees.
    pub(crate) events: Vec<Event>,
    /// Whether the engine formed the weights too.
    pub(crate) engine_forms_weights: bool,
    /// Linear RGB, as the engine renders the pixel.
    pub(crate) colour: [f32; 3],
    pub(crate) quantiser: Quantiser,
}

impl<'a> Life<'a> {
    /// Follows the ray on rayon's current threads, which need the recursion's stacks.
    ///
    /// `name` is the scene's, as it is to be told.
    ///
    /// # Errors
    /// [`ExplainError::NoPixel`], [`ExplainError::LifeTooDeep`] and [`ExplainError::Differs`].
    pub fn new(
        name: &'a str,
        scene: &'a Scene,
        pixel: Pixel,
        isa: Isa,
    ) -> Result<Self, ExplainError> {
        pixel.check(scene)?;
        // One pixel is compiled as the whole picture is.
        let compiled = Compiled::new(scene);
        let crop = Crop { x: pixel.x, y: pixel.y, width: 1, height: 1 };
        let view = View::new(scene, Some(crop), 1).expect("one pixel of the image");
        let grid = Grid::new(&view);
        let [recursion, .., the_loop, _, engine] = &RUNGS;

        // Watch the recursion; where its stack is too small, the loop that does the same.
        let settings = Settings { isa, stack_limit: STACK_LIMIT };
        let watch = |rung: &Rung, watch: &mut dyn Watch| {
            (rung.watch)(&compiled, &grid, (0, 0), settings, watch).map(drop)
        };
        let log = |rung: &'static Rung| {
            let mut events = Vec::new();
            watch(rung, &mut events).map(|()| (rung, events))
        };
        let told = log(recursion).or_else(|_| log(the_loop));
        let (recursion, events) = told.map_err(|_| too_deep(scene))?;
        // Watch the engine's rung too, and render the pixel without a watcher.
        let mut same = Same { expected: events.iter(), differs: false, weights: false };
        watch(engine, &mut same).map_err(|_| too_deep(scene))?;
        let mut film = Film::new(1, 1);
        let rendered = Tracer::Packet(isa).render(&compiled, &grid, &mut film);
        rendered.map_err(|_| too_deep(scene))?;

        // All three must agree on events and bits, or the explanation would be wrong.
        let colour = film.pixels()[0];
        let Some(Event::Return { colour: returned, .. }) = events.last() else {
            unreachable!("the last thing that a ray does is to return")
        };
        let same_bits =
            |(a, b): (&f32, &f32)| a.to_bits() == b.to_bits() || (a.is_nan() && b.is_nan());
        let same_colour = colour.iter().zip(&returned.to_array()).all(same_bits);
        if same.differs || same.expected.next().is_some() || !same_colour {
            let Pixel { x, y } = pixel;
            return Err(ExplainError::Differs { x, y });
        }
        // Tell rays in the scene's axes; they were in the camera's.
        let engine_forms_weights = same.weights;
        let events = in_the_world(events, &compiled.axes);
        let quantiser = Quantiser::new(scene.image.transfer);
        Ok(Self {
            name,
            scene,
            compiled,
            pixel,
            recursion,
            engine,
            events,
            engine_forms_weights,
            colour,
            quantiser,
        })
    }

    /// How many calls, hits, folds and returns it has.
    #[must_use]
    pub fn steps(&self) -> usize {
        self.events.len()
    }

    /// Reflections behind the deepest ray.
    pub(crate) fn deepest(&self) -> u32 {
        self.events.iter().map(Event::depth).max().unwrap_or(0)
    }

    /// The place where the scene states a primitive: `spheres[2]`, as its error messages have it.
    pub(crate) fn stated(&self, primitive: usize) -> String {
        self.name_of(self.compiled.primitives[primitive].stated as usize)
    }

    /// Name of a place among the scene's spheres, as [`Self::stated`] has it; planes come after.
    pub(crate) fn name_of(&self, stated: usize) -> String {
        let spheres = self.scene.spheres.len();
        match stated.checked_sub(spheres) {
            None => format!("spheres[{stated}]"),
            Some(plane) => format!("planes[{plane}]"),
        }
    }

    /// Levels of a colour in an 8-bit picture.
    pub(crate) fn levels(&self, colour: [f32; 3]) -> [u8; 3] {
        colour.map(|channel| self.quantiser.level(channel))
    }

    /// Whether an event is the return of a ray that met nothing.
    pub(crate) fn misses(&self, index: usize) -> bool {
        let before = index.checked_sub(1).map(|before| &self.events[before]);
        matches!(before, Some(Event::Call { .. }))
    }

    /// Why the mirror of a hit that is not followed is not.
    pub(crate) fn last(&self, depth: u32, k: f32) -> Last {
        if k.is_nan() || k <= 0.0 {
            Last::NoMirror
        } else if depth >= self.scene.render.max_depth {
            Last::MaxDepth
        } else {
            Last::MinWeight
        }
    }

    /// What an event is to the two.
    pub(crate) fn roles(&self, index: usize) -> Roles {
        let (recursion, engine) = match self.events[index] {
            Event::Call { .. } => ("call", Some("ray")),
            Event::Hit { followed: true, .. } => ("hit", Some("push")),
            Event::Hit { followed: false, .. } => ("hit", Some("end")),
            Event::Fold { .. } => ("fold", Some("fold")),
            Event::Return { .. } if self.misses(index) => ("return", Some("end")),
            Event::Return { .. } => ("return", None),
        };
        Roles { recursion, engine }
    }
}

/// Why a hit is the last.
#[derive(Clone, Copy, Serialize)]
#[serde(rename_all = "snake_case")]
pub(crate) enum Last {
    /// The surface reflects nothing, so the hit owes nothing.
    NoMirror,
    MaxDepth,
    MinWeight,
}

/// One event, in a word each.
#[derive(Serialize)]
pub(crate) struct Roles {
    /// `call`, `hit`, `fold` or `return`.
    pub(crate) recursion: &'static str,
    /// `ray`: in flight; `push`: a level is put on the stack; `end`: nothing is owed; `fold`: the
    /// level is taken off and paid. Null: nothing happens, what the recursion returns is at hand.
    pub(crate) engine: Option<&'static str>,
}

/// Turns a log, which is in the camera's axes, into the world's. Points stay relative to the eye;
/// coordinates are rounded once more, unless the two have the same axes.
fn in_the_world(mut events: Vec<Event>, axes: &CameraAxes) -> Vec<Event> {
    let turned = |v: [f32; 3]| {
        axes.turned_back(v.map(|x| DoubleDouble::from(f64::from(x)))).map(DoubleDouble::to_f32)
    };
    for event in &mut events {
        if let Event::Call { origin, direction, .. } = event {
            *origin = turned(origin.to_array()).into();
            *direction = turned(direction.to_array()).into();
        }
    }
    events
}

fn too_deep(scene: &Scene) -> ExplainError {
    ExplainError::LifeTooDeep { max_depth: scene.render.max_depth }
}

/// Compares a log with another one as it is told.
struct Same<'a> {
    expected: std::slice::Iter<'a, Event>,
    differs: bool,
    /// Whether it tells any.
    weights: bool,
}

impl Watch for Same<'_> {
    fn see(&mut self, event: Event) {
        self.differs |= self.expected.next().is_none_or(|expected| !expected.agrees(&event));
        self.weights |= matches!(event, Event::Call { weight: Some(_), .. });
    }
}
