//! Eight vectors.

use std::ops::{Add, Mul, Sub};

use glam::Vec3 as Scalar;

use crate::lanes::{Lanes, Mask};

/// Eight vectors, structure of arrays. Operations are glam's, lane by lane.
#[derive(Clone, Copy)]
pub(crate) struct Vec3<L> {
    pub(crate) x: L,
    pub(crate) y: L,
    pub(crate) z: L,
}

impl<L: Lanes> Vec3<L> {
    /// The same vector in every lane.
    #[inline(always)]
    pub(crate) fn splat(v: Scalar) -> Self {
        Self { x: L::splat(v.x), y: L::splat(v.y), z: L::splat(v.z) }
    }

    #[inline(always)]
    pub(crate) fn zero() -> Self {
        Self::splat(Scalar::ZERO)
    }

    /// (x + y) + z.
    #[inline(always)]
    pub(crate) fn dot(self, other: Self) -> L {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    #[inline(always)]
    pub(crate) fn length(self) -> L {
        self.dot(self).sqrt()
    }

    /// `this` where true, `other` elsewhere.
    #[inline(always)]
    pub(crate) fn select(mask: Mask<L>, this: Self, other: Self) -> Self {
        Self {
            x: mask.select(this.x, other.x),
            y: mask.select(this.y, other.y),
            z: mask.select(this.z, other.z),
        }
    }

    /// This where true, +0 elsewhere.
    #[inline(always)]
    pub(crate) fn keep(self, mask: Mask<L>) -> Self {
        Self { x: mask.keep(self.x), y: mask.keep(self.y), z: mask.keep(self.z) }
    }
}

impl<L: Lanes> Add for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<L: Lanes> Sub for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

/// Component by component.
impl<L: Lanes> Mul for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, other: Self) -> Self {
        Self { x: self.x * other.x, y: self.y * other.y, z: self.z * other.z }
    }
}

impl<L: Lanes> Mul<L> for Vec3<L> {
    type Output = Self;
    #[inline(always)]
    fn mul(self, s: L) -> Self {
        Self { x: self.x * s, y: self.y * s, z: self.z * s }
    }
}
