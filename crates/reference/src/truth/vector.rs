//! Vectors of truth's numbers: no more than the formulas need.

use std::ops::{Add, Mul, Neg, Sub};

use super::real::Real;

/// A point or a direction.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vector<T> {
    x: T,
    y: T,
    z: T,
}

impl<T: Real> Vector<T> {
    pub(super) fn dot(self, other: Self) -> T {
        self.x * other.x + self.y * other.y + self.z * other.z
    }

    pub(super) fn cross(self, other: Self) -> Self {
        Self {
            x: self.y * other.z - self.z * other.y,
            y: self.z * other.x - self.x * other.z,
            z: self.x * other.y - self.y * other.x,
        }
    }

    pub(super) fn length(self) -> T {
        self.dot(self).sqrt()
    }

    /// The vector scaled to length 1. The zero vector stays zero: a hit's radial vector is zero
    /// only where rounding has lost a radius smaller than an ulp of the coordinates.
    pub(super) fn unit(self) -> Self {
        let length = self.length();
        if length > T::from(0.0) {
            Self { x: self.x / length, y: self.y / length, z: self.z / length }
        } else {
            self
        }
    }

    /// Scales a direction to a length whose square neither overflows nor underflows, by a power of
    /// two, hence exactly; for stated directions, which may have any length.
    pub(super) fn tamed(self) -> Self {
        let [x, y, z] = self.to_f64().map(f64::abs);
        let largest = x.max(y).max(z);
        let power_of_two = |exponent: u64| f64::from_bits((exponent + 1023) << 52);
        let scale = if largest < 1e-100 {
            power_of_two(700)
        } else if largest > 1e100 {
            1.0 / power_of_two(700)
        } else {
            1.0
        };
        self * T::from(scale)
    }

    pub(super) fn to_f64(self) -> [f64; 3] {
        [self.x.to_f64(), self.y.to_f64(), self.z.to_f64()]
    }
}

impl<T: Real> From<[f64; 3]> for Vector<T> {
    fn from([x, y, z]: [f64; 3]) -> Self {
        Self { x: T::from(x), y: T::from(y), z: T::from(z) }
    }
}

impl<T: Real> Add for Vector<T> {
    type Output = Self;

    fn add(self, other: Self) -> Self {
        Self { x: self.x + other.x, y: self.y + other.y, z: self.z + other.z }
    }
}

impl<T: Real> Sub for Vector<T> {
    type Output = Self;

    fn sub(self, other: Self) -> Self {
        Self { x: self.x - other.x, y: self.y - other.y, z: self.z - other.z }
    }
}

impl<T: Real> Neg for Vector<T> {
    type Output = Self;

    fn neg(self) -> Self {
        Self { x: -self.x, y: -self.y, z: -self.z }
    }
}

impl<T: Real> Mul<T> for Vector<T> {
    type Output = Self;

    fn mul(self, factor: T) -> Self {
        Self { x: self.x * factor, y: self.y * factor, z: self.z * factor }
    }
}
