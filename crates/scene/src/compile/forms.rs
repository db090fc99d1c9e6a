//! The form of each primitive: which constants its intersection is computed from.
//!
//! A **robust sphere** is computed from centre and radius. A **general sphere** is a plane, or a
//! sphere whose surface is so close to the eye, for its size, that it looks like one: computed from
//! its height function, it needs no coordinates of a centre far away. The choice depends on the
//! sphere and the eye alone: nothing else in the scene changes a bit of it.
//!
//! Accuracy: points of a robust sphere are off by some u (|c| + r), points of a general sphere by
//! some u times their distance from the eye. Where the eye is at a quarter of the radius from the
//! surface, the nearest point of a robust sphere is off by 9 u of its distance; closer, that grows
//! without bound.

use std::collections::HashSet;

use super::camera::CameraAxes;
use super::constants::{nearest3, unit};
use crate::direction::tamed;
use crate::{Body, DoubleDouble, Draft, Numerics, Plane, Scalar, Scene, Sphere};

/// The form chosen for a primitive.
#[derive(Clone, Copy, Debug)]
pub enum Shape<S: Scalar = f32> {
    /// Robust: a sphere.
    RobustSphere(RobustSphere<S>),
    /// Robust: a plane or a large sphere.
    GeneralSphere(GeneralSphere<S>),
    /// Textbook: a sphere.
    TextbookSphere(TextbookSphere<S>),
    /// Textbook: a plane.
    TextbookPlane(TextbookPlane<S>),
}

/// A sphere, by centre and radius.
#[derive(Clone, Copy, Debug)]
pub struct RobustSphere<S: Scalar = f32> {
    /// Centre in the camera's axes, relative to the eye.
    pub center: S::Vec3,
    /// Radius in world units.
    pub radius: S,
    /// The radius squared in f64, rounded to the scalar.
    pub radius_squared: S,
    /// 1 where the eye is outside the sphere or on it, -1 where the sphere is around the eye. Times
    /// the outward normal it gives the normal that faces every ray.
    pub side: S,
}

/// A plane, or a sphere close to the eye for its size, by its height function.
///
/// Twice the height of x above the surface, on the eye's side, is
/// 2g(x) = curvature·|x|^2 - 2 scaled_center·x + cocurvature. Its gradient is
/// N(x) = curvature·x - scaled_center: on the surface the unit normal that faces every ray.
#[derive(Clone, Copy, Debug)]
pub struct GeneralSphere<S: Scalar = f32> {
    /// 1/r for a sphere seen from outside, -1/r for one around the eye, 0 for a plane.
    pub curvature: S,
    /// c/r, or -c/r for a sphere around the eye; the negated normal for a plane.
    pub scaled_center: S::Vec3,
    /// Twice the eye's height: (|c|^2 - r^2)/r, or its negative, formed in double-double.
    pub cocurvature: S,
}

impl<S: Scalar> GeneralSphere<S> {
    /// Whether it is a sphere around the eye.
    #[must_use]
    pub fn encloses_eye(&self) -> bool {
        self.curvature < S::ZERO
    }
}

impl<S: Scalar> RobustSphere<S> {
    /// Whether it is a sphere around the eye.
    #[must_use]
    pub fn encloses_eye(&self) -> bool {
        self.side < S::ZERO
    }
}

/// A sphere as the workshop states it.
#[derive(Clone, Copy, Debug)]
pub struct TextbookSphere<S: Scalar = f32> {
    /// Centre in the camera's axes, relative to the eye.
    pub center: S::Vec3,
    /// Radius in world units.
    pub radius: S,
}

/// A plane as the workshop would state it.
#[derive(Clone, Copy, Debug)]
pub struct TextbookPlane<S: Scalar = f32> {
    /// The unit normal as given.
    pub normal: S::Vec3,
    /// normal · point, relative to the eye.
    pub offset: S,
}

/// The form of each body, in the order of bodies.
pub(super) fn shapes<S: Scalar>(scene: &Scene, axes: &CameraAxes) -> Vec<Shape<S>> {
    let robust = |body: Body<'_>| match body {
        Body::Sphere(sphere) => robust_sphere(scene, axes, sphere),
        Body::Plane(plane) => Shape::GeneralSphere(robust_plane(scene, axes, plane)),
    };
    let textbook = |body: Body<'_>| match body {
        Body::Sphere(sphere) => Shape::TextbookSphere(TextbookSphere {
            center: nearest3::<S>(axes.point(sphere.center)),
            radius: S::rounded(sphere.radius),
        }),
        Body::Plane(plane) => Shape::TextbookPlane(TextbookPlane {
            normal: nearest3::<S>(axes.turned(exact_normal(plane))),
            offset: S::nearest(-height(plane, scene.camera.position)),
        }),
    };
    match scene.render.numerics {
        Numerics::Robust => scene.bodies().map(robust).collect(),
        Numerics::Textbook => scene.bodies().map(textbook).collect(),
    }
}

/// Whether each body is the first with its surface; in textbook scenes all are kept.
///
/// A repeated surface is never seen, since ties go to the first. In a robust scene it must not be
/// tried either: a ray that leaves the first would tell the two apart by rounding.
pub(super) fn firsts(scene: &Draft) -> Vec<bool> {
    let all = scene.render.numerics == Numerics::Textbook;
    let bits = |v: [f64; 3]| v.map(|x| (x + 0.0).to_bits());
    let (mut spheres, mut planes) = (HashSet::new(), HashSet::new());
    let first = |body: Body<'_>| match body {
        Body::Sphere(sphere) => spheres.insert((bits(sphere.center), sphere.radius.to_bits())),
        Body::Plane(plane) => planes.insert((bits(plane.point), bits(plane.normal))),
    };
    scene.bodies().map(first).map(|first| first || all).collect()
}

/// Radius over the eye's distance from the surface, from which a sphere takes the general form.
const FLAT_FROM: f64 = 4.0;

fn robust_sphere<S: Scalar>(scene: &Draft, axes: &CameraAxes, sphere: &Sphere) -> Shape<S> {
    let center = axes.point(sphere.center);
    let power = power_of(sphere, scene.camera.position);
    let around = power < DoubleDouble::default();
    let r = DoubleDouble::from(sphere.radius);
    // The eye's distance from the surface is (|c|^2 - r^2)/(|c| + r), so that nothing cancels.
    let [x, y, z] = center.map(DoubleDouble::to_f64);
    let to_center = (x * x + y * y + z * z).sqrt();
    let distance = (power.to_f64() / (to_center + sphere.radius)).abs();
    if sphere.radius < FLAT_FROM * distance {
        return Shape::RobustSphere(RobustSphere {
            center: nearest3::<S>(center),
            radius: S::rounded(sphere.radius),
            radius_squared: S::rounded(sphere.radius * sphere.radius),
            side: S::rounded(if around { -1.0 } else { 1.0 }),
        });
    }
    let side = DoubleDouble::from(if around { -1.0 } else { 1.0 });
    Shape::GeneralSphere(GeneralSphere {
        curvature: S::nearest(side / r),
        scaled_center: nearest3::<S>(center.map(|c| side * c / r)),
        cocurvature: S::nearest(side * power / r),
    })
}

/// A plane in the general form, its normal turned to the eye's side. An eye on the plane counts as
/// where the stated normal points.
fn robust_plane<S: Scalar>(scene: &Draft, axes: &CameraAxes, plane: &Plane) -> GeneralSphere<S> {
    let normal = exact_normal(plane);
    let height = height(plane, scene.camera.position);
    let turned = height < DoubleDouble::default();
    let scaled_center = if turned { normal } else { normal.map(|x| -x) };
    let height = if turned { -height } else { height };
    let scaled_center = axes.turned(scaled_center);
    GeneralSphere {
        curvature: S::ZERO,
        scaled_center: nearest3::<S>(scaled_center),
        cocurvature: S::nearest(height + height),
    }
}

/// The unit vector of a plane's stated normal.
fn exact_normal(plane: &Plane) -> [DoubleDouble; 3] {
    unit(tamed(plane.normal).map(DoubleDouble::from))
}

/// |x - c|^2 - r^2, the power of a point: negative inside the sphere, positive outside.
pub(super) fn power_of(sphere: &Sphere, x: [f64; 3]) -> DoubleDouble {
    let d: [_; 3] = std::array::from_fn(|i| DoubleDouble::difference(x[i], sphere.center[i]));
    let r = DoubleDouble::from(sphere.radius);
    d[0] * d[0] + d[1] * d[1] + d[2] * d[2] - r * r
}

/// The height of x over a plane, on the side that its normal points to.
fn height(plane: &Plane, x: [f64; 3]) -> DoubleDouble {
    let [a, b, c] = tamed(plane.normal).map(DoubleDouble::from);
    scaled_height(plane, x) / (a * a + b * b + c * c).sqrt()
}

/// [`height`] times the length of the stated normal: its sign says on which side of the plane x is.
///
/// The products are exact, so a point stated to be on the plane gives 0, however the plane lies. A
/// unit normal's rounding would put it on one side or the other.
pub(super) fn scaled_height(plane: &Plane, x: [f64; 3]) -> DoubleDouble {
    let normal = tamed(plane.normal);
    let along =
        |i: usize| DoubleDouble::from(normal[i]) * DoubleDouble::difference(x[i], plane.point[i]);
    along(0) + along(1) + along(2)
}
