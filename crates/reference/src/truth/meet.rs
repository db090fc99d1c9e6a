//! Hits of rays on primitives, and what hides a light.

use std::cmp::Ordering;

use super::model::{Light, Model, Shape};
use super::real::Real;
use super::vector::Vector;

/// A ray in flight; `direction` has length 1.
pub(super) struct Ray<T> {
    pub(super) origin: Vector<T>,
    pub(super) direction: Vector<T>,
    /// Index, in the model, of the primitive that the ray has just left.
    pub(super) leaves: Option<usize>,
}

/// The point where a ray ends on a primitive.
pub(super) struct Hit<T> {
    /// Index in the model.
    pub(super) index: usize,
    pub(super) point: Vector<T>,
    /// Unit normal on the eye's side of the primitive: it faces the ray.
    pub(super) normal: Vector<T>,
}

impl<T: Real> Model<T> {
    /// The nearest hit; on equal distance the lowest index.
    #[inline(never)] // The recursion's frame stays free of what this needs.
    pub(super) fn nearest(&self, ray: &Ray<T>) -> Option<Hit<T>> {
        let mut nearest: Option<(usize, T)> = None;
        for (index, primitive) in self.primitives.iter().enumerate() {
            let left = ray.leaves == Some(index);
            if let Some(t) = primitive.shape.distance(ray, left)
                && nearest.is_none_or(|(_, least)| t < least)
            {
                nearest = Some((index, t));
            }
        }
        nearest.map(|(index, t)| {
            let point = ray.origin + ray.direction * t;
            Hit { index, point, normal: self.primitives[index].shape.normal(point) }
        })
    }

    /// Whether something stands between `point` on primitive `own` and a light that lies
    /// in `direction`, `distance` away: whether another surface is crossed at
    /// 0 <= t < distance.
    ///
    /// A light beyond some surface is hidden from the whole of the eye's cell. With both
    /// ends in the cell, planes and spheres around it, being the borders of convex regions
    /// that hold both, hide nothing; any other sphere hides the light exactly if the foot
    /// of the perpendicular from its centre lies between the ends and not outside it.
    /// No root is compared with the distance, so a light on a surface needs no luck.
    pub(super) fn occluded(
        &self,
        point: Vector<T>,
        own: usize,
        light: &Light<T>,
        direction: Vector<T>,
        distance: T,
    ) -> bool {
        let zero = T::from(0.0);
        light.sides.contains(&Ordering::Less)
            || self.primitives.iter().enumerate().any(|(index, primitive)| match primitive.shape {
                Shape::Sphere { center, radius, around: false } if index != own => {
                    let f = point - center;
                    let foot = -f.dot(direction);
                    let discriminant = foot * foot - (f.dot(f) - radius * radius);
                    zero < foot && foot < distance && discriminant >= zero
                }
                _ => false,
            })
    }
}

impl<T: Real> Shape<T> {
    /// Distance from the ray's origin to this primitive, at least 0; `None` if the ray does not
    /// meet it. `left`: the ray has just left this primitive.
    ///
    /// Sphere: |f + t d|² = r² with f = o - c and |d| = 1, so t = -b ± sqrt(b² - (|f|² - r²))
    /// with b = f·d. For the surface that the ray has left, |f| = r and the roots are 0 and
    /// -2b. From outside only the near root counts and only where the sphere is approached,
    /// b < 0; from inside only the far root exists.
    /// Plane: n·(o + t d - point) = 0.
    fn distance(&self, ray: &Ray<T>, left: bool) -> Option<T> {
        let zero = T::from(0.0);
        let t = match *self {
            Self::Sphere { center, radius, around } => {
                let f = ray.origin - center;
                let b = f.dot(ray.direction);
                if left {
                    return around.then(|| (-(b + b)).at_least_zero());
                }
                let discriminant = b * b - (f.dot(f) - radius * radius);
                if around {
                    discriminant.at_least_zero().sqrt() - b
                } else if b < zero && discriminant >= zero {
                    -b - discriminant.sqrt()
                } else {
                    return None;
                }
            }
            Self::Plane { point, normal } => {
                let slope = normal.dot(ray.direction);
                if left || slope >= zero {
                    return None;
                }
                normal.dot(point - ray.origin) / slope
            }
        };
        Some(t.at_least_zero())
    }

    /// The unit normal at a point of the surface, on the eye's side.
    fn normal(&self, at: Vector<T>) -> Vector<T> {
        match *self {
            Self::Sphere { center, around: true, .. } => (center - at).unit(),
            Self::Sphere { center, around: false, .. } => (at - center).unit(),
            Self::Plane { normal, .. } => normal,
        }
    }
}
