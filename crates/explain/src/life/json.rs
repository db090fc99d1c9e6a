//! A ray's life as one JSON document.

use catoptric_ladder::Event;
use serde::ser::SerializeStruct;
use serde::{Serialize, Serializer};

use super::{Last, Life, Roles};
use crate::words::numerics;

/// Points are relative to the eye; colours are linear RGB; what is
/// infinite or NaN is null.
impl Serialize for Life<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let mut map = to.serialize_struct("life", 17)?;
        map.serialize_field("schema", "catoptric-explain-pixel")?;
        map.serialize_field("version", &1)?;
        map.serialize_field("scene", self.name)?;
        map.serialize_field("width", &self.scene.image.width)?;
        map.serialize_field("height", &self.scene.image.height)?;
        map.serialize_field("x", &self.pixel.x)?;
        map.serialize_field("y", &self.pixel.y)?;
        map.serialize_field("numerics", numerics(self.scene))?;
        map.serialize_field("max_depth", &self.scene.render.max_depth)?;
        map.serialize_field("min_weight", &self.scene.render.min_weight)?;
        map.serialize_field("eye", &self.scene.camera.position)?;
        map.serialize_field("rungs", &[self.recursion.name, self.engine.name])?;
        map.serialize_field("engine_forms_weights", &self.engine_forms_weights)?;
        map.serialize_field("deepest", &self.deepest())?;
        map.serialize_field("colour", &self.colour)?;
        map.serialize_field("levels", &self.levels(self.colour))?;
        map.serialize_field("steps", &Steps(self))?;
        map.end()
    }
}

struct Steps<'a>(&'a Life<'a>);

impl Serialize for Steps<'_> {
    fn serialize<S: Serializer>(&self, to: S) -> Result<S::Ok, S::Error> {
        let life = self.0;
        to.collect_seq(life.events.iter().enumerate().map(|(index, event)| Step {
            step: index + 1,
            depth: event.depth(),
            roles: life.roles(index),
            numbers: Numbers::of(life, event),
        }))
    }
}

#[derive(Serialize)]
struct Step {
    step: usize,
    depth: u32,
    #[serde(flatten)]
    roles: Roles,
    #[serde(flatten)]
    numbers: Numbers,
}

/// Numbers that are the same for both, but that a weight may be the recursion's alone, and k of
/// a hit that is not followed is.
#[derive(Serialize)]
#[serde(untagged)]
enum Numbers {
    Call {
        origin: [f32; 3],
        direction: [f32; 3],
        weight: Option<f32>,
    },
    Hit {
        /// The place where the scene states the primitive.
        primitive: String,
        distance: f32,
        local: [f32; 3],
        k: f32,
        followed: bool,
        /// Why a hit is not followed; null where it is.
        last: Option<Last>,
    },
    Fold {
        local: [f32; 3],
        k: f32,
        back: [f32; 3],
        colour: [f32; 3],
    },
    Return {
        colour: [f32; 3],
    },
}

impl Numbers {
    fn of(life: &Life, event: &Event) -> Self {
        match *event {
            Event::Call { origin, direction, weight, .. } => {
                Self::Call { origin: origin.into(), direction: direction.into(), weight }
            }
            Event::Hit { primitive, distance, local, k, followed, .. } => {
                let last = (!followed).then(|| life.last(event.depth(), k));
                let (primitive, local) = (life.stated(primitive), local.into());
                Self::Hit { primitive, distance, local, k, followed, last }
            }
            Event::Fold { local, k, back, colour, .. } => {
                Self::Fold { local: local.into(), k, back: back.into(), colour: colour.into() }
            }
            Event::Return { colour, .. } => Self::Return { colour: colour.into() },
        }
    }
}
