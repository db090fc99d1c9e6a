//! Rays and spheres in double-double: what the formulas are measured against.

use catoptric_scene::DoubleDouble;

/// A vector in double-double.
pub(crate) type Vector = [DoubleDouble; 3];

/// A vector of f64, exact.
pub(crate) fn vector(v: [f64; 3]) -> Vector {
    v.map(DoubleDouble::from)
}

/// The difference of two points, exact.
pub(crate) fn between(a: [f64; 3], b: [f64; 3]) -> Vector {
    std::array::from_fn(|i| DoubleDouble::difference(a[i], b[i]))
}

pub(crate) fn dot(a: Vector, b: Vector) -> DoubleDouble {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

/// a + b t.
pub(crate) fn along(a: Vector, b: Vector, t: DoubleDouble) -> Vector {
    std::array::from_fn(|i| a[i] + b[i] * t)
}

pub(crate) fn minus(a: Vector, b: Vector) -> Vector {
    std::array::from_fn(|i| a[i] - b[i])
}

pub(crate) fn length(v: Vector) -> DoubleDouble {
    dot(v, v).sqrt()
}

/// A ray o + t d, |d| about 1, and a sphere that it starts outside of.
pub(crate) struct Meeting {
    /// How far the centre is from the ray's line, less the radius: negative where they meet.
    pub(crate) passes: f64,
    /// The near root t, where they meet on the way in.
    pub(crate) distance: Option<DoubleDouble>,
    /// |n·d|/|d| where they meet, else 0.
    pub(crate) cosine: f64,
}

impl Meeting {
    /// Makes it for a ray and a sphere.
    pub(crate) fn new(origin: Vector, direction: Vector, center: Vector, radius: f64) -> Self {
        let r = DoubleDouble::from(radius);
        let f = minus(center, origin);
        let (a, b) = (dot(direction, direction), dot(f, direction));
        let foot = along(f, direction, -(b / a));
        let passes = (length(foot) - r).to_f64();
        let c = dot(f, f) - r * r;
        let discriminant = b * b - a * c;
        let meets = b.to_f64() > 0.0 && discriminant.to_f64() >= 0.0;
        let root = discriminant.sqrt();
        let distance = meets.then(|| c / (b + root));
        let cosine = if meets { (root / (a.sqrt() * r)).to_f64() } else { 0.0 };
        Self { passes, distance, cosine }
    }
}

/// A vector of f32 as f64.
pub(crate) fn widen(v: glam::Vec3) -> [f64; 3] {
    v.to_array().map(f64::from)
}

/// A vector rounded to f32.
#[expect(clippy::cast_possible_truncation, reason = "this is the rounding")]
pub(crate) fn narrow(v: [f64; 3]) -> glam::Vec3 {
    v.map(|x| x as f32).into()
}
