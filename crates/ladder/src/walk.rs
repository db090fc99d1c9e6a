//! The operations that all rungs share: one step of a ray, and one fold of a colour.
//!
//! Both are the reference's operations. A rung decides nothing but when they happen.

use catoptric_reference::ray::Ray;
use catoptric_reference::trace::Tracer;
use catoptric_scene::{Compiled, Counts};
use glam::Vec3;

use crate::{Error, Event, Watch};

/// A ray in flight, with all that the way down needs.
#[derive(Clone, Copy, Debug)]
pub struct Flight {
    /// Origin, direction and the primitive just left.
    pub ray: Ray,
    /// The product of the mirror factors on the way, 1 for an eye ray.
    pub weight: f32,
    /// Mirrors on the way, 0 for an eye ray.
    pub depth: u32,
}

/// What a mirror owes: colour = local + k · (what comes back). These 16 bytes are all that the way
/// up needs.
#[derive(Clone, Copy, Debug)]
pub struct PendingBounce {
    /// What the hit itself sends.
    pub local: Vec3,
    /// The mirror factor.
    pub k: f32,
}

/// Outcome of one step of a ray.
#[derive(Clone, Copy, Debug)]
pub enum Step {
    /// The ray ended with this colour: the background, or a hit whose mirror is not followed.
    Ends(Vec3),
    /// The ray met a mirror. Another ray sets out, and the colour waits for it.
    Mirrors(PendingBounce, Flight),
}

/// Takes rays through a scene step by step, counts them and lets `watch` see.
pub struct Walk<'a, W> {
    tracer: Tracer<'a>,
    deepest: u32,
    watch: W,
}

impl<'a, W: Watch> Walk<'a, W> {
    /// A walk that refuses to go deeper than `deepest`.
    #[must_use]
    pub fn new(scene: &'a Compiled, deepest: u32, watch: W) -> Self {
        Self { tracer: Tracer::new(scene), deepest, watch }
    }

    /// The eye ray through a point of the image plane.
    #[must_use]
    pub fn eye(&self, column: f32, row: f32) -> Flight {
        Flight { ray: self.tracer.eye_ray(column, row), weight: 1.0, depth: 0 }
    }

    /// Takes a ray to its end or to the next mirror.
    ///
    /// Past `deepest` all is void: rays end at once, and [`finish`](Self::finish) says so.
    #[inline]
    pub fn step(&mut self, flight: Flight) -> Step {
        let Flight { ray, weight, depth } = flight;
        if depth > self.deepest || self.tracer.too_deep {
            self.tracer.too_deep = true;
            return Step::Ends(Vec3::ZERO);
        }
        let Ray { origin, direction, .. } = ray;
        self.watch.see(Event::Call { depth, origin, direction, weight: Some(weight) });
        let Some(hit) = self.tracer.meet(ray, depth) else {
            return self.ends(depth, self.tracer.scene.background);
        };

        let (local, k) = (hit.local, hit.k);
        let weight = weight * k;
        let followed = self.tracer.follows(k, weight, depth);
        let (primitive, distance) = (hit.primitive, hit.distance);
        self.watch.see(Event::Hit { depth, primitive, distance, local, k, followed });
        if followed {
            let next = Flight { ray: hit.mirrored, weight, depth: depth + 1 };
            Step::Mirrors(PendingBounce { local, k }, next)
        } else {
            self.ends(depth, local)
        }
    }

    /// Pays what a mirror at `depth` owes.
    #[inline]
    pub fn fold(&mut self, depth: u32, bounce: PendingBounce, back: Vec3) -> Vec3 {
        let PendingBounce { local, k } = bounce;
        let colour = local + k * back;
        // Without a mirror nothing was owed (`r4_packets`).
        if k > 0.0 {
            self.watch.see(Event::Fold { depth, local, k, back, colour });
            self.watch.see(Event::Return { depth, colour });
        }
        colour
    }

    /// Ends the walk and gives the counts of its rays.
    ///
    /// # Errors
    /// [`Error::TooDeep`] if a path was given up.
    pub fn finish(self) -> Result<Counts, Error> {
        if self.tracer.too_deep {
            Err(Error::TooDeep { deepest: self.deepest })
        } else {
            Ok(self.tracer.counts)
        }
    }

    fn ends(&mut self, depth: u32, colour: Vec3) -> Step {
        self.watch.see(Event::Return { depth, colour });
        Step::Ends(colour)
    }
}
