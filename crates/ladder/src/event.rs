//! What happens to an eye ray, in one vocabulary for all rungs.
//!
//! A rung without recursion calls nothing and returns nothing, but it goes through the same
//! states, in the same order, with the same numbers. The events show this.

use glam::Vec3;

/// One event in the life of an eye ray. `depth` counts the mirrors on the way, 0 for the
/// eye ray itself.
///
/// Order: `Call` 0, `Hit` 0, `Call` 1, ... down to the ray that ends; its `Return`; then from
/// the deepest mirror up, each mirror's `Fold` and `Return`. A `Call` without a `Hit` met
/// nothing.
#[derive(Clone, Copy, Debug)]
pub enum Event {
    /// A ray sets out.
    Call {
        /// Mirrors on the way.
        depth: u32,
        /// Start, relative to the eye.
        origin: Vec3,
        /// Direction; |direction| is 1.
        direction: Vec3,
        /// The product of the mirror factors on the way. `None` where the rung forms none: the
        /// engine forms it only for a cut by weight, a `min_weight` above 0.
        weight: Option<f32>,
    },
    /// The ray meets a primitive.
    Hit {
        /// Mirrors on the way.
        depth: u32,
        /// Index in [`Compiled::primitives`](catoptric_scene::Compiled::primitives).
        primitive: usize,
        /// Distance from the ray's origin, in multiples of |direction|.
        distance: f32,
        /// The light that the hit itself sends back along the ray.
        local: Vec3,
        /// The mirror factor.
        k: f32,
        /// Whether the mirrored ray sets out.
        followed: bool,
    },
    /// A mirror folds what came back: colour = local + k · back.
    Fold {
        /// Mirrors on the way.
        depth: u32,
        /// What the hit itself sends.
        local: Vec3,
        /// The mirror factor.
        k: f32,
        /// What came back from the mirror.
        back: Vec3,
        /// The sum.
        colour: Vec3,
    },
    /// The light that comes back along the ray is known.
    Return {
        /// Mirrors on the way.
        depth: u32,
        /// Linear RGB.
        colour: Vec3,
    },
}

impl Event {
    /// Mirrors on the way of the event's ray.
    #[must_use]
    pub fn depth(&self) -> u32 {
        let (Self::Call { depth, .. }
        | Self::Hit { depth, .. }
        | Self::Fold { depth, .. }
        | Self::Return { depth, .. }) = *self;
        depth
    }

    /// Whether two rungs' events are equal, except that one of them may form no weight.
    #[must_use]
    pub fn agrees(&self, other: &Self) -> bool {
        let formed = |event: &Self| !matches!(event, Self::Call { weight: None, .. });
        if formed(self) && formed(other) {
            self == other
        } else {
            self.without_weight() == other.without_weight()
        }
    }

    fn without_weight(self) -> Self {
        match self {
            Self::Call { depth, origin, direction, .. } => {
                Self::Call { depth, origin, direction, weight: None }
            }
            other => other,
        }
    }

    /// The event as kind and whole numbers, then the bits of all floats; every NaN as the same
    /// bits.
    fn bits(&self) -> ([usize; 4], [u32; 11]) {
        const NONE: Vec3 = Vec3::ZERO;
        let (whole, vectors, numbers) = match *self {
            Self::Call { depth, origin, direction, weight } => {
                let whole = [0, depth as usize, usize::from(weight.is_some()), 0];
                (whole, [origin, direction, NONE], [weight.unwrap_or(0.0), 0.0])
            }
            Self::Hit { depth, primitive, distance, local, k, followed } => {
                let whole = [1, depth as usize, primitive, usize::from(followed)];
                (whole, [local, NONE, NONE], [distance, k])
            }
            Self::Fold { depth, local, k, back, colour } => {
                ([2, depth as usize, 0, 0], [local, back, colour], [k, 0.0])
            }
            Self::Return { depth, colour } => {
                ([3, depth as usize, 0, 0], [colour, NONE, NONE], [0.0, 0.0])
            }
        };
        let [[a, b, c], [d, e, f], [g, h, i]] = vectors.map(|v| v.to_array());
        let [j, k] = numbers;
        let bits = |x: f32| if x.is_nan() { f32::NAN.to_bits() } else { x.to_bits() };
        (whole, [a, b, c, d, e, f, g, h, i, j, k].map(bits))
    }
}

/// Equal bits, but a NaN equals any other: no processor promises its payload.
impl PartialEq for Event {
    fn eq(&self, other: &Self) -> bool {
        self.bits() == other.bits()
    }
}

/// An observer of events. `()` sees nothing and costs nothing.
pub trait Watch {
    /// Sees one event.
    fn see(&mut self, event: Event);
}

impl Watch for () {
    #[inline(always)]
    fn see(&mut self, _: Event) {}
}

/// The event log.
impl Watch for Vec<Event> {
    fn see(&mut self, event: Event) {
        self.push(event);
    }
}

impl Watch for &mut dyn Watch {
    fn see(&mut self, event: Event) {
        (**self).see(event);
    }
}

/// An observer that may be absent: `None` sees nothing.
impl<W: Watch> Watch for Option<W> {
    fn see(&mut self, event: Event) {
        if let Some(watch) = self {
            watch.see(event);
        }
    }
}
