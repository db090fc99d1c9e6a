//! The recursion.
//!
//! The workshop's six formulas, and where they are computed:
//!
//! 1. a ray is p = o + t d                                   (`surface` of each shape)
//! 2. it meets a sphere where |o + t d - c|^2 = r^2          (`distance` of each shape)
//! 3. the normal there is n = (p - c)/|p - c|                (`surface` of each shape)
//! 4. a light adds I (kd colour (n·l) + ks (r·v)^p)          (`local`)
//! 5. the mirrored ray is d - 2 (d·n) n                      (`mirrored`)
//! 6. colour = local + k · trace(mirrored ray)               (`trace`)

use catoptric_scene::{Compiled, Counts, Numerics, Phong};

use super::power::power;
use super::ray::{Hit, Ray, Surface};
use super::real::{Real, Vec3};
use super::shape;
use crate::depth::DEPTH_ALLOWED;

/// Traces rays through one scene and counts them.
///
/// [`meet`](Self::meet) and [`follows`](Self::follows) are all that is computed for one ray;
/// [`trace`](Self::trace) ties rays together, and is not the only way to (`crates/ladder`). They
/// are inlined, in other crates too, or the recursion would lose a tenth of its speed.
pub struct Tracer<'a> {
    /// What the rays go through.
    pub scene: &'a Compiled<Real>,
    /// The rays so far.
    pub counts: Counts,
    /// Set once a path went deeper than the stack allows; the picture is then void.
    pub too_deep: bool,
}

impl<'a> Tracer<'a> {
    /// A tracer that has counted nothing.
    #[must_use]
    pub fn new(scene: &'a Compiled<Real>) -> Self {
        Self { scene, counts: Counts::default(), too_deep: false }
    }

    /// The light that comes back along a ray.
    ///
    /// `weight` is the product of the mirror factors on the way here, 1 for an eye ray;
    /// `depth` the number of mirrors on the way, 0 for an eye ray.
    pub fn trace(&mut self, ray: Ray, weight: Real, depth: u32) -> Vec3 {
        if depth > DEPTH_ALLOWED {
            self.too_deep = true;
            return Vec3::ZERO;
        }
        let Some(hit) = self.meet(ray, depth) else {
            return self.scene.background;
        };

        // A mirror that is not followed shows black.
        let weight = weight * hit.k;
        if self.follows(hit.k, weight, depth) {
            hit.local + hit.k * self.trace(hit.mirrored, weight, depth + 1)
        } else {
            hit.local
        }
    }

    /// What the ray meets first, if anything, and the light there. Counts the ray, the hit
    /// and its shadow rays.
    #[inline(always)]
    pub fn meet(&mut self, ray: Ray, depth: u32) -> Option<Hit> {
        self.counts.at(depth).rays += 1;
        let (primitive, distance) = self.nearest(ray)?;
        self.counts.at(depth).hits += 1;

        let surface = self.surface(primitive, ray, distance);
        let material = self.scene.materials[self.scene.primitives[primitive].material as usize];
        let direction = self.mirrored(ray.direction, surface.normal);
        let local = self.local(&surface, &material, direction, depth);
        let mirrored = Ray { origin: surface.start, direction, left: surface.left };
        Some(Hit { primitive, distance, surface, local, k: material.mirror, mirrored })
    }

    /// Whether a mirror of factor `k` met at `depth` is followed; `weight` is the product of
    /// the mirror factors up to and with it.
    #[inline(always)]
    #[must_use]
    pub fn follows(&self, k: Real, weight: Real, depth: u32) -> bool {
        k > 0.0 && depth < self.scene.max_depth && weight >= self.scene.min_weight
    }

    /// Ambient light plus what each visible light adds, in file order (Phong 1975).
    #[inline(always)]
    fn local(&mut self, at: &Surface, material: &Phong<Real>, mirrored: Vec3, depth: u32) -> Vec3 {
        let mut colour = material.ambient;
        for light in &self.scene.lights {
            let to_light = at.to(light.position);
            let distance = to_light.length();
            let l = to_light * (1.0 / distance);
            let facing = at.normal.dot(l);
            // A light behind the surface adds nothing, nor does one at the very point, or so close
            // that the square of its distance is 0.
            if facing > 0.0 && distance > 0.0 {
                self.counts.at(depth).shadow += 1;
                if !light.hidden && !self.occluded(at, l, distance) {
                    // r·v, r being l mirrored about n and v = -d, equals l·(d mirrored).
                    let highlight = material.specular * power(l.dot(mirrored), material.power);
                    let diffuse = material.diffuse * facing;
                    colour += light.intensity * (diffuse + Vec3::splat(highlight));
                }
            }
        }
        colour
    }

    /// The mirrored direction d - 2 (d·n) n.
    ///
    /// Robust: made a unit vector again, or rounding would add up over the mirrors. Its
    /// length is 1 up to a few ulps, so one Newton step for 1/|v|, v (3 - v·v)/2, is exact
    /// to the last place and needs neither a root nor a division.
    #[inline(always)]
    fn mirrored(&self, d: Vec3, n: Vec3) -> Vec3 {
        let v = d - n * (2.0 * d.dot(n));
        match self.scene.numerics {
            Numerics::Robust => v * (1.5 - 0.5 * v.dot(v)),
            Numerics::Textbook => v,
        }
    }

    /// The primitive that the ray meets first, and its distance. The first of equals wins.
    #[inline(always)]
    fn nearest(&self, ray: Ray) -> Option<(usize, Real)> {
        let mut nearest = None;
        let mut best = Real::INFINITY;
        for (id, primitive) in self.scene.primitives.iter().enumerate() {
            let own = ray.left == Some(id);
            let distance = shape::distance(&primitive.shape, ray, own);
            if let Some(t) = distance
                && t < best
            {
                best = t;
                nearest = Some((id, t));
            }
        }
        nearest
    }

    /// Whether something stands between the surface and a light in direction `l`.
    #[inline(always)]
    pub(super) fn occluded(&self, at: &Surface, l: Vec3, distance: Real) -> bool {
        let ray = Ray { origin: at.start, direction: l, left: at.left };
        for (id, primitive) in self.scene.primitives.iter().enumerate() {
            let left = at.left == Some(id);
            let hides = !left && shape::occludes(&primitive.shape, ray, distance);
            if hides {
                return true;
            }
        }
        false
    }

    #[inline(always)]
    fn surface(&self, id: usize, ray: Ray, distance: Real) -> Surface {
        shape::surface(&self.scene.primitives[id].shape, ray, distance, id)
    }
}
