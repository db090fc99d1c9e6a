//! Points, a light, and spheres that just stand between them or just do not.

use catoptric_scene::{Compiled, Draft, Light, Material, MaterialId, Materials, Scene, Sphere};
use glam::DVec3;

use super::super::POINT;
use crate::simd::numbers::{Numbers, TestScalar};
use crate::simd::{LANES, Packed};

/// Packets of points: arms from an anchor.
#[derive(Debug)]
pub(super) struct Points<S> {
    pub(super) anchor: [S; 3],
    pub(super) arms: Vec<Packed<S>>,
}

impl<S: TestScalar> Points<S> {
    /// Points at a distance of a center; their anchor is the eye, or that of a sphere.
    fn around(center: DVec3, spread: f64, numbers: &mut Numbers) -> Self {
        let anchor = if numbers.one_in(2) { DVec3::ZERO } else { anchor(center, numbers) };
        let anchor = anchor.to_array().map(S::rounded);
        let mut packet = |_| {
            let points: [_; LANES] =
                std::array::from_fn(|_| (center + direction(numbers) * spread).to_array());
            let component =
                |axis: usize| points.map(|point| S::rounded(point[axis] - anchor[axis].to_f64()));
            std::array::from_fn(component)
        };
        Self { anchor, arms: (0..2).map(&mut packet).collect() }
    }

    /// One of the points, before it is rounded.
    fn any(&self, numbers: &mut Numbers) -> DVec3 {
        let (packet, lane) = (numbers.below(self.arms.len()), numbers.below(LANES));
        let component =
            |axis: usize| self.anchor[axis].to_f64() + self.arms[packet][axis][lane].to_f64();
        DVec3::from_array(std::array::from_fn(component))
    }

    /// Center and radius of a sphere that holds them, as hit groups tell it.
    pub(super) fn bounds(&self) -> (DVec3, f64) {
        let (mut center, mut corner) = (DVec3::ZERO, DVec3::ZERO);
        for axis in 0..3 {
            let anchor = self.anchor[axis].to_f64();
            let lanes = self.arms.iter().flat_map(|arm| arm[axis]);
            let mut all: Vec<_> = lanes.map(|x| anchor + x.to_f64()).collect();
            all.sort_by(f64::total_cmp);
            let (least, most) = (all[0], all[all.len() - 1]);
            center[axis] = S::rounded((least + most) * 0.5).to_f64();
            let (below, above) = (center[axis] - least, most - center[axis]);
            corner[axis] = if below > above { below } else { above };
        }
        let radius = corner.length();
        (center, radius + POINT * (center.length() + radius))
    }
}

/// The center of a sphere through a point, as a robust scene may hold it: its radius is below four
/// times the eye's distance from it.
fn anchor(point: DVec3, numbers: &mut Numbers) -> DVec3 {
    loop {
        let radius = point.length() * numbers.magnitude(1e-3, 5.0);
        let center = point + direction(numbers) * radius;
        if radius < 4.0 * (center.length() - radius).abs() {
            return center;
        }
    }
}

fn direction(numbers: &mut Numbers) -> DVec3 {
    let component = |_| numbers.between(-1.0, 1.0);
    DVec3::from_array(std::array::from_fn(component)).try_normalize().unwrap_or(DVec3::X)
}

/// A direction across another one.
fn across(way: DVec3, numbers: &mut Numbers) -> DVec3 {
    let any = direction(numbers);
    (any - way * (any.dot(way) / way.length_squared())).try_normalize().unwrap_or(DVec3::X)
}

/// A matt material, which stands first in a scene's list.
fn matt() -> (Materials, MaterialId) {
    let mut materials = Materials::default();
    let material = materials.add(Material::matt([1.0; 3]));
    (materials, material)
}

/// A small part: just beside, or just within.
fn graze(numbers: &mut Numbers) -> f64 {
    let sign = if numbers.one_in(3) { -1.0 } else { 1.0 };
    sign * numbers.magnitude(1e-8, 1e-2)
}

fn compiled<S: TestScalar>(light: DVec3, spheres: Vec<Sphere>) -> Compiled<S> {
    let light = Light { position: light.to_array(), intensity: [1.0; 3] };
    let draft = Draft { lights: vec![light], materials: matt().0, spheres, ..Draft::default() };
    Compiled::of(&Scene::new(draft).expect("a valid scene"))
}

/// Spheres anywhere along the way to the light, most of them close to its far end.
pub(super) fn spheres<S: TestScalar>(numbers: &mut Numbers) -> (Compiled<S>, Points<S>) {
    let center = direction(numbers) * numbers.magnitude(1e-3, 1000.0);
    let far = numbers.magnitude(0.1, 3000.0);
    let light = center + direction(numbers) * far;
    let spread = if numbers.one_in(2) { 0.0 } else { far * numbers.magnitude(1e-5, 0.5) };
    let points = Points::around(center, spread, numbers);
    let sphere = |_| {
        let start = points.any(numbers);
        let way = light - start;
        // From the light to the foot, and the radius; half of them in proportion to that.
        let foot = numbers.magnitude(1e-3, 1.0);
        let scale = if numbers.one_in(2) { foot } else { 1.0 };
        let radius = way.length() * scale * numbers.magnitude(1e-4, 1.0);
        let beside = across(way, numbers) * (radius * (1.0 + graze(numbers)));
        let center = light - way * foot + beside;
        Sphere { center: center.to_array(), radius, material: matt().1 }
    };
    let spheres = (0..20).map(sphere).collect();
    (compiled(light, spheres), points)
}

/// A sphere under the eye, points over it, and a light on their horizon.
pub(super) fn horizons<S: TestScalar>(numbers: &mut Numbers) -> (Compiled<S>, Points<S>) {
    let height = numbers.magnitude(1e-2, 10.0);
    let radius = height * numbers.magnitude(4.5, 1e7);
    let up = direction(numbers);
    let center = up * -(radius + height);
    let aside = up + across(up, numbers) * numbers.magnitude(1e-6, 0.5);
    let over = height * numbers.magnitude(1e-9, 1.0);
    let point = center + aside.normalize() * (radius + over);
    let spread = if numbers.one_in(2) { 0.0 } else { over * numbers.magnitude(1e-3, 0.5) };
    let points = Points::around(point, spread, numbers);
    // Rising a little or falling a little, from one of the points.
    let start = points.any(numbers);
    let normal = (start - center).normalize();
    let way = across(normal, numbers) + normal * graze(numbers);
    let light = start + way * (height * numbers.magnitude(1e-2, 1e3));
    let material = matt().1;
    (compiled(light, vec![Sphere { center: center.to_array(), radius, material }]), points)
}
