//! One ray's way through a scene, written down: what the recursion met, for finding out where it
//! goes wrong. Rendering does not use it.

use catoptric_scene::Compiled;

use super::ray::{Hit, Ray, Surface};
use super::real::{Real, Vec3};
use super::trace::Tracer;

/// What a ray met.
#[derive(Clone, Debug)]
pub struct Step {
    /// The ray.
    pub ray: Ray,
    /// Index in [`Compiled::primitives`].
    pub primitive: usize,
    /// Distance along the ray. Units: world units, up to the rounding of |direction|.
    pub distance: Real,
    /// The surface there.
    pub surface: Surface,
    /// Whether each light, in file order, lights the point.
    pub lit: Vec<bool>,
    /// Colour without the mirror: ambient light and lights.
    pub local: Vec3,
    /// Whether the mirrored ray is traced. On the last step, true means that this ray met nothing.
    pub followed: bool,
}

/// The ray from the eye through a point of the image plane, as the picture has it.
#[must_use]
pub fn eye_ray(scene: &Compiled<Real>, column: Real, row: Real) -> Ray {
    Tracer::new(scene).eye_ray(column, row)
}

/// Everything that a ray meets, in order, as deep as the picture follows it; empty if it meets
/// nothing. Takes no native stack, so no depth is too large.
#[must_use]
pub fn follow(scene: &Compiled<Real>, mut ray: Ray) -> Vec<Step> {
    let mut tracer = Tracer::new(scene);
    let mut steps = Vec::new();
    let mut weight = 1.0;
    for depth in 0.. {
        // The counts are not wanted, so they need not grow.
        let Some(hit) = tracer.meet(ray, 0) else { break };
        let Hit { primitive, distance, surface, local, k, mirrored } = hit;
        let lit = tracer.lit(&surface);
        weight *= k;
        let followed = tracer.follows(k, weight, depth);
        steps.push(Step { ray, primitive, distance, surface, lit, local, followed });
        if !followed {
            break;
        }
        ray = mirrored;
    }
    steps
}

impl Tracer<'_> {
    fn lit(&self, at: &Surface) -> Vec<bool> {
        let lit = |position: Vec3, hidden: bool| {
            let to_light = at.to(position);
            let distance = to_light.length();
            let l = to_light * (1.0 / distance);
            at.normal.dot(l) > 0.0 && distance > 0.0 && !hidden && !self.occluded(at, l, distance)
        };
        self.scene.lights.iter().map(|light| lit(light.position, light.hidden)).collect()
    }
}
