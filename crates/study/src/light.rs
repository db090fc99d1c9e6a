//! How much light a scene can hold: a-priori bounds on a picture and on what ending its paths
//! early leaves out.
//!
//! With L_i the most that primitive i sends back of ambient and other light, k_i its mirror
//! factor and bg the background, what i sends back with m further reflections is at most
//!
//! ```text
//! B_i(0) = L_i,   B_i(m) = L_i + k_i · max(bg, max of B_j(m - 1) over the j that i can show)
//! ```
//!
//! i shows every other primitive, and itself only where it is a sphere around the eye (or with
//! textbook formulas, which leak). Ending paths at depth d leaves out what the last mirrors
//! would have shown, times the product of mirror factors on the way: a chain whose members
//! alternate, which is what makes the bound sharper than k^(d+1)/(1 - k) · L_max (Hall and
//! Greenberg, A testbed for realistic image synthesis, 1983, cut their paths by that weight).
//!
//! Every quantity is of one channel, or of the largest of each. Bounds are of exact arithmetic:
//! what f32 adds is a term of its own.

use std::sync::OnceLock;

use catoptric_scene::{Body, Material, Numerics, Scene};

use crate::metrics::larger;

/// How often a bound is followed before it counts as unbounded.
const STEPS: u32 = 1_000_000;

/// What each primitive can send back.
pub struct LightBounds {
    background: f64,
    surfaces: Vec<Surface>,
    /// B(m) of every primitive for an m past [`STEPS`], once it was asked for: a million steps.
    endless: OnceLock<Vec<f64>>,
}

struct Surface {
    /// L.
    local: f64,
    /// k.
    mirror: f64,
    /// Whether it can show itself.
    itself: bool,
}

impl LightBounds {
    /// Bounds of a scene's light, for every channel.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::of(scene, &[0, 1, 2])
    }

    /// Bounds of a scene's light, for one channel.
    ///
    /// # Panics
    /// If there is no such channel.
    #[must_use]
    pub fn of_channel(scene: &Scene, channel: usize) -> Self {
        Self::of(scene, &[channel])
    }

    fn of(scene: &Scene, channels: &[usize]) -> Self {
        let eye = scene.camera.position;
        let leaks = scene.render.numerics == Numerics::Textbook;
        let itself = |body: Body<'_>| match body {
            Body::Sphere(sphere) => {
                let from_center = [0, 1, 2].map(|i| eye[i] - sphere.center[i]);
                let squared: f64 = from_center.iter().map(|x| x * x).sum();
                // On the safe side of rounding: a sphere that the eye is on may count as around.
                squared.sqrt() <= sphere.radius * (1.0 + 1e-9)
            }
            Body::Plane(_) => false,
        };
        let surface = |body: Body<'_>| {
            let material = &scene.materials[body.material()];
            Surface {
                local: local(scene, material, channels),
                mirror: material.mirror(),
                itself: itself(body) || leaks,
            }
        };
        let background = channels.iter().map(|&c| scene.render.background[c]).fold(0.0, larger);
        let surfaces = scene.bodies().map(surface).collect();
        Self { background, surfaces, endless: OnceLock::new() }
    }

    /// The most that a pixel can hold with that many reflections; infinite where mirrors of
    /// k = 1 never let it settle.
    #[must_use]
    pub fn brightest(&self, max_depth: u32) -> f64 {
        self.sent_back(max_depth).into_iter().fold(self.background, larger)
    }

    /// The most that a pixel can change between `max_depth = cap` and `max_depth = full`: 0
    /// where no path can have cap + 1 reflections.
    #[must_use]
    pub fn left_out_by_cap(&self, cap: u32, full: u32) -> f64 {
        if cap >= full {
            return 0.0;
        }
        // What the last mirror would have shown, with the reflections that are left.
        let sent_back = self.sent_back(full - cap - 1);
        let shown = self.shown(&sent_back, self.background);
        let mut left_out = self.reflected(&shown);
        for _ in 0..cap {
            let next = self.reflected(&self.shown(&left_out, 0.0));
            if next == left_out {
                break;
            }
            left_out = next;
        }
        left_out.into_iter().fold(0.0, larger)
    }

    /// The most that a pixel can change where reflected rays of a weight below `min_weight` are
    /// left out: less than that weight times the most that such a ray can bring.
    #[must_use]
    pub fn left_out_by_weight(&self, min_weight: f64, max_depth: u32) -> f64 {
        let any_mirror = self.surfaces.iter().any(|surface| surface.mirror > 0.0);
        if any_mirror && max_depth > 0 { min_weight * self.brightest(max_depth - 1) } else { 0.0 }
    }

    /// B(m) of every primitive. Past [`STEPS`] it does not depend on m.
    fn sent_back(&self, reflections: u32) -> Vec<f64> {
        if reflections > STEPS {
            return self.endless.get_or_init(|| self.followed(reflections)).clone();
        }
        self.followed(reflections)
    }

    fn followed(&self, reflections: u32) -> Vec<f64> {
        let mut bounds: Vec<f64> = self.surfaces.iter().map(|surface| surface.local).collect();
        for step in 0..reflections {
            let shown = self.shown(&bounds, self.background);
            let reflected = self.reflected(&shown).into_iter();
            let next = reflected.zip(&self.surfaces).map(|(r, surface)| surface.local + r);
            let next: Vec<f64> = next.collect();
            if next == bounds {
                break;
            }
            bounds = next;
            if step == STEPS {
                return vec![f64::INFINITY; bounds.len()];
            }
        }
        bounds
    }

    /// The largest of `values` over those that a primitive can show, and of `other`, by primitive.
    fn shown(&self, values: &[f64], other: f64) -> Vec<f64> {
        // The largest and the second largest tell it for all.
        let first = (0..values.len()).reduce(|a, b| if values[b] > values[a] { b } else { a });
        let rest = (0..values.len()).filter(|i| Some(*i) != first);
        let second = rest.map(|i| values[i]).fold(other, larger);
        let largest = first.map_or(other, |i| larger(values[i], other));
        let of = |(i, surface): (usize, &Surface)| {
            if Some(i) == first && !surface.itself { second } else { largest }
        };
        self.surfaces.iter().enumerate().map(of).collect()
    }

    fn reflected(&self, shown: &[f64]) -> Vec<f64> {
        // 0 times an infinite bound is nothing.
        let product = |(surface, shown): (&Surface, &f64)| {
            if surface.mirror > 0.0 { surface.mirror * shown } else { 0.0 }
        };
        self.surfaces.iter().zip(shown).map(product).collect()
    }
}

/// L: ambient light, and all lights at their brightest.
fn local(scene: &Scene, material: &Material, channels: &[usize]) -> f64 {
    let of_channel = |&c: &usize| {
        let lamps: f64 = scene.lights.iter().map(|light| light.intensity[c]).sum();
        let (color, ambient) = (material.color[c], scene.render.ambient[c]);
        ambient * color + lamps * (material.diffuse * color + material.specular)
    };
    channels.iter().map(of_channel).fold(0.0, larger)
}
