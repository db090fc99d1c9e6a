//! Eight vectors.

use std::ops::{Add, Mul, Sub};

use catoptric_scene::Scalar;

use glam::DVec3;

use super::lanes::{LANES, Lanes, Mask};

/// Eight vectors, structure of arrays. Operations are glam's, lane by lane.
#[derive(Clone, Copy)]
pub(crate) struct Vec3<L> {
    pub(crate) x: L,
    pub(crate) y: L,
    pub(crate) z: L,
}

/// Eight vectors in memory: x, y, z; eight lanes each.
pub(crate) type Packed<S> = [[S; LANES]; 3];

impl<L: Lanes> Vec3<L> {
    #[inline(always)]
    pub(crate) fn from_arrays(&[x, y, z]: &Packed<L::Scalar>) -> Self {
        Self { x: L::from_array(x), y: L::from_array(y), z: L::from_array(z) }
    }

    #[inline(always)]
    pub(crate) fn to_arrays(self) -> Packed<L::Scalar> {
        [self.x.to_array(), self.y.to_array(), self.z.to_array()]
    }

    /// The same vector in every lane.
    #[inline(always)]
    pub(crate) fn splat(v: <L::Scalar as Scalar>::Vec3) -> Self {
        let [x, y, z] = v.into();
        Self { x: L::splat(x), y: L::splat(y), z: L::splat(z) }
    }

    #[inline(always)]
    pub(crate) fn zero() -> Self {
        Self::all(L::constant(0.0))
    }

    #[inline(always)]
    pub(crate) fn all(x: L) -> Self {
        Self { x, y: x, z: x }
    }

    /// The lesser of each two components; that of `other` where one of them is NaN.
    #[inline(always)]
    pub(crate) fn min_or_second(self, other: Self) -> Self {
        Self {
            x: self.x.min_or_second(other.x),
            y: self.y.min_or_second(other.y),
            z: self.z.min_or_second(other.z),
        }
    }

    /// The greater of each two components; that of `other` where one of them is NaN.
    #[inline(always)]
    pub(crate) fn max_or_second(self, other: Self) -> Self {
        Self {
            x: self.x.max_or_second(other.x),
            y: self.y.max_or_second(other.y),
            z: self.z.max_or_second(other.z),
        }
    }

    /// Each component divided.
    #[inline(always)]
    pub(crate) fn div(self, divisor: L) -> Self {
        Self { x: self.x / divisor, y: self.y / divisor, z: self.z / divisor }
    }

    /// The vector in lane 0.
    #[inline(always)]
    pub(crate) fn first(self) -> [L::Scalar; 3] {
        let [[x, ..], [y, ..], [z, ..]] = self.to_arrays();
        [x, y, z]
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

/// The same vector in f64.
#[inline(always)]
pub(crate) fn in_f64<S: Scalar>(v: S::Vec3) -> DVec3 {
    let [x, y, z] = v.into();
    DVec3::new(x.to_f64(), y.to_f64(), z.to_f64())
}
