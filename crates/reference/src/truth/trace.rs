//! The recursion: the model of the picture, term by term.

use std::array::from_fn;
use std::cmp::Ordering;

use catoptric_scene::{Counts, DepthCount};

use super::depth::{DEPTH_ALLOWED, TooDeep};
use super::meet::{Hit, Ray};
use super::model::{Light, Model, Shape};
use super::power::power;
use super::real::Real;
use super::vector::Vector;

impl<T: Real> Model<T> {
    /// What a ray sees: the local colour where it ends, plus k times what the mirrored ray
    /// sees. `weight` is the product of the mirror factors on the way here.
    pub(super) fn trace(
        &self,
        ray: &Ray<T>,
        depth: u32,
        weight: T,
        counts: &mut Counts,
    ) -> Result<[T; 3], TooDeep> {
        if depth > DEPTH_ALLOWED {
            return Err(TooDeep { allowed: DEPTH_ALLOWED });
        }
        let count = counts.at(depth);
        count.rays += 1;

        // Nothing there: the background.
        let Some(hit) = self.nearest(ray) else {
            return Ok(self.background);
        };
        count.hits += 1;

        // The light that arrives at the hit from the lights themselves.
        let local = self.local(ray, &hit, count);

        // The light that arrives by way of the mirror, folded in from the deepest hit.
        let Some((reflected, weight)) = self.reflected(ray, &hit, depth, weight) else {
            return Ok(local);
        };
        let incoming = self.trace(&reflected, depth + 1, weight, counts)?;
        let k = self.primitives[hit.index].surface.mirror;
        Ok(from_fn(|c| local[c] + k * incoming[c]))
    }

    /// Ambient plus the Phong terms of every light that the hit faces and sees:
    /// I·(kd·colour·(n·l) + ks·max(0, r·(-d))^shininess).
    #[inline(never)] // The recursion's frame stays free of what this needs.
    fn local(&self, ray: &Ray<T>, hit: &Hit<T>, count: &mut DepthCount) -> [T; 3] {
        let one = T::from(1.0);
        let surface = &self.primitives[hit.index].surface;
        let mut sum = surface.ambient;
        for light in &self.lights {
            let Some((l, n_dot_l)) = self.arriving(hit, light, count) else { continue };
            // r is the mirror image of l about n. The cosine exceeds 1 by rounding only.
            let r = hit.normal * (n_dot_l + n_dot_l) - l;
            let cosine = (-r.dot(ray.direction)).at_least_zero();
            let cosine = if cosine > one { one } else { cosine };
            let highlight = surface.specular * power(cosine, surface.shininess);
            sum = from_fn(|c| {
                sum[c] + light.intensity[c] * (surface.diffuse[c] * n_dot_l + highlight)
            });
        }
        sum
    }

    /// Whether each light lights the hit.
    pub(super) fn lit(&self, hit: &Hit<T>) -> Vec<bool> {
        let count = &mut DepthCount::default();
        self.lights.iter().map(|light| self.arriving(hit, light, count).is_some()).collect()
    }

    /// The direction to a light and its cosine n·l, if the hit faces the light and sees it.
    #[inline] // As if written in `local`.
    fn arriving(
        &self,
        hit: &Hit<T>,
        light: &Light<T>,
        count: &mut DepthCount,
    ) -> Option<(Vector<T>, T)> {
        let zero = T::from(0.0);
        let toward = light.position - hit.point;
        let distance = toward.length();
        // A light in the plane that is lit grazes it: n·l is 0, whatever rounding says.
        let plane = matches!(self.primitives[hit.index].shape, Shape::Plane { .. });
        let grazes = plane && light.sides[hit.index] == Ordering::Equal;
        if distance <= zero || grazes {
            return None;
        }
        let l = toward.unit();
        let n_dot_l = hit.normal.dot(l);
        if n_dot_l <= zero {
            return None;
        }
        count.shadow += 1;
        let seen = !self.occluded(hit.point, hit.index, light, l, distance);
        seen.then_some((l, n_dot_l))
    }

    /// The reflected ray and its weight, if it is to be traced: only from a mirror, to the
    /// scene's depth, and while its weight is not below the least one.
    #[inline(never)] // The recursion's frame stays free of what this needs.
    pub(super) fn reflected(
        &self,
        ray: &Ray<T>,
        hit: &Hit<T>,
        depth: u32,
        weight: T,
    ) -> Option<(Ray<T>, T)> {
        let k = self.primitives[hit.index].surface.mirror;
        let weight = weight * k;
        if k <= T::from(0.0) || depth >= self.max_depth || weight < self.min_weight {
            return None;
        }
        // d - 2(d·n)n has length 1; it is scaled again, so that rounding does not add up.
        let (d, n) = (ray.direction, hit.normal);
        let along = d.dot(n);
        let direction = (d - n * (along + along)).unit();
        Some((Ray { origin: hit.point, direction, leaves: Some(hit.index) }, weight))
    }
}
