//! What a tile's culler leaves out, beside the test of every ray.

use catoptric_scene::{
    Camera, Compiled, Draft, EyeRays, Material, MaterialId, Materials, Plane, Scene,
    Shape as AnyShape, Sphere,
};
use glam::DVec3;

use super::{MARGIN, TileCone, TileCuller};
use crate::ray::{Rays, TILE_HEIGHT, TILE_WIDTH};
use crate::shape::{Shape, ShapeVisitor, dispatch};
use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, LANES, Lanes, Mask, Vec3, run};

/// A tile by the positions of its columns and rows.
struct Tile<S> {
    columns: Vec<S>,
    rows: Vec<S>,
}

impl<S: TestScalar> Tile<S> {
    /// Up to a whole tile, of single rays or half a picture.
    fn random(numbers: &mut Numbers) -> Self {
        let mut line = |most: usize| {
            let len = if numbers.one_in(4) { 1 } else { 1 + numbers.below(most) };
            let step = numbers.magnitude(1e-4, 1.0) / most as f64;
            let start = numbers.between(-1.0, 1.0 - step * len as f64);
            (0..len).map(|i| S::rounded(start + step * i as f64)).collect::<Vec<_>>()
        };
        Self { columns: line(TILE_WIDTH), rows: line(TILE_HEIGHT).into_iter().rev().collect() }
    }

    /// The exact direction of one of its corners, and one that leads away from the tile there.
    fn corner(&self, eye: &EyeRays<S>, numbers: &mut Numbers) -> (DVec3, DVec3) {
        let [width, height, distance] =
            [eye.half_width, eye.half_height, eye.distance].map(S::to_f64);
        let end =
            |line: &[S], last: bool| (if last { line[line.len() - 1] } else { line[0] }).to_f64();
        let (right, bottom) = (numbers.one_in(2), numbers.one_in(2));
        let (x, y) = (end(&self.columns, right), end(&self.rows, bottom));
        let corner = DVec3::new(x * width, y * height, -distance).normalize();
        let cone = TileCone::new(eye, &self.columns, &self.rows).expect("half a picture at most");
        // Straight away from the axis, or nearly.
        let askew = numbers.magnitude(1e-9, 1.0);
        let any = direction(numbers) * if cone.sin > 1e-6 { askew } else { 1.0 };
        let away = corner - cone.axis + any * (cone.sin + 1e-6);
        (corner, (away - corner * away.dot(corner)).normalize())
    }
}

/// A matt material, which stands first in a scene's list.
fn matt() -> (Materials, MaterialId) {
    let mut materials = Materials::default();
    let material = materials.add(Material::matt([1.0; 3]));
    (materials, material)
}

fn direction(numbers: &mut Numbers) -> DVec3 {
    let component = |_| numbers.between(-1.0, 1.0);
    DVec3::from_array(std::array::from_fn(component)).try_normalize().unwrap_or(DVec3::X)
}

/// A small angle: just beside, or just within.
fn graze(numbers: &mut Numbers) -> f64 {
    let sign = if numbers.one_in(4) { -1.0 } else { 1.0 };
    sign * numbers.magnitude(1e-9, 1e-3)
}

/// A sphere that a corner's ray just misses or just meets, however small and far.
fn sphere((corner, away): (DVec3, DVec3), numbers: &mut Numbers) -> Sphere {
    let distance = numbers.magnitude(0.1, 1e4);
    let half = numbers.magnitude(1e-4, 1.5);
    let angle = half + graze(numbers) * half.sin();
    let center = (corner * angle.cos() + away * angle.sin()) * distance;
    let material = matt().1;
    Sphere { center: center.to_array(), radius: distance * half.sin(), material }
}

/// A plane that a corner's ray is nearly parallel to.
fn plane((corner, away): (DVec3, DVec3), numbers: &mut Numbers) -> Plane {
    let normal = away - corner * graze(numbers);
    let point = normal * numbers.magnitude(1e-3, 1e3);
    let material = matt().1;
    Plane { point: point.to_array(), normal: normal.to_array(), material }
}

/// A sphere so large that it looks like such a plane.
fn large((corner, away): (DVec3, DVec3), numbers: &mut Numbers) -> Sphere {
    let distance = numbers.magnitude(1e-3, 10.0);
    let radius = distance * numbers.magnitude(4.0, 1e9);
    let center = (away - corner * graze(numbers)).normalize() * (distance + radius);
    Sphere { center: center.to_array(), radius, material: matt().1 }
}

/// Whether any ray of a tile meets a shape, as `nearest` asks.
struct Meets<'a, S: TestScalar>(&'a AnyShape<S>, &'a EyeRays<S>, &'a Tile<S>);

impl<S: TestScalar> Kernel for Meets<'_, S> {
    type Scalar = S;
    type Output = bool;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> bool {
        let Self(shape, eye, tile) = self;
        let mut met = false;
        let z = L::splat(-eye.distance);
        for columns in tile.columns.chunks(LANES) {
            let mut lanes = [columns[0]; LANES];
            lanes[..columns.len()].copy_from_slice(columns);
            let x = L::from_array(lanes) * L::splat(eye.half_width);
            for &row in &tile.rows {
                let y = L::splat(row) * L::splat(eye.half_height);
                let length = (x * x + y * y + z * z).sqrt();
                let direction = Vec3 { x, y, z } * (L::constant(1.0) / length);
                met |= dispatch::<L, _, true>(shape, AnyMet(direction));
            }
        }
        met
    }
}

/// Whether any of eight eye rays meets a form.
struct AnyMet<L>(Vec3<L>);

impl<L: Lanes> ShapeVisitor<L> for AnyMet<L> {
    type Output = bool;

    #[inline(always)]
    fn visit<F: Shape<L>>(self, shape: F) -> bool {
        let rays = Rays { origin: Vec3::zero(), direction: self.0 };
        match shape.distance::<true>(&rays, Mask::none()) {
            Some(at) => (at.met & at.t.lt(L::constant(f64::INFINITY))).any(),
            None => false,
        }
    }
}

/// Tiles and primitives at their edges: how many were left out, and how many met.
fn check<S: TestScalar>(rounds: usize) -> (usize, usize) {
    let mut numbers = Numbers::new(31);
    let (mut culled, mut met) = (0, 0);
    let mut candidates = Vec::new();
    for _ in 0..rounds {
        // The tile's own scene says how it lies; its primitives are then put beside it.
        let mut draft = Draft {
            camera: Camera { fov: numbers.magnitude(0.1, 120.0), ..Camera::default() },
            materials: matt().0,
            ..Draft::default()
        };
        let empty = Compiled::<S>::of(&Scene::new(draft.clone()).expect("a valid scene"));
        let tile = Tile::<S>::random(&mut numbers);
        for _ in 0..20 {
            let at = tile.corner(&empty.eye, &mut numbers);
            draft.spheres.push(sphere(at, &mut numbers));
            draft.spheres.push(large(at, &mut numbers));
            draft.planes.push(plane(at, &mut numbers));
        }
        let scene = Compiled::<S>::of(&Scene::new(draft).expect("a valid scene"));
        let all: Vec<_> = (0..scene.primitives.len() as u32).collect();
        let culler = TileCuller::new(&scene, all.clone());
        culler.candidates(&scene.eye, &tile.columns, &tile.rows, &mut candidates);
        assert!(candidates.is_sorted() && culler.all() == all);
        culled += all.len() - candidates.len();
        for index in all {
            let shape = &scene.primitives[index as usize].shape;
            let tried = candidates.binary_search(&index).is_ok();
            for isa in isas() {
                let meets = run(isa, Meets(shape, &scene.eye, &tile));
                assert!(tried || !meets, "{isa}: a ray meets {shape:?}, which was left out");
                met += usize::from(meets);
            }
        }
    }
    (culled, met)
}

/// Most primitives miss by less than a thousandth, many by less than the margin.
#[test]
fn no_ray_of_a_tile_meets_what_is_left_out() {
    for (culled, met) in [check::<f32>(1500), check::<f64>(100)] {
        assert!(culled > 1000 && met > 1000, "{culled} left out, {met} met");
    }
}

/// Directly behind a single ray the cones know the angle itself.
#[test]
fn what_is_far_beside_a_tile_is_left_out() {
    let draft = Draft {
        materials: matt().0,
        spheres: [0.9, 1.1]
            .map(|x| Sphere { center: [x, 0.0, -10.0], radius: 1.0, material: matt().1 })
            .to_vec(),
        ..Draft::default()
    };
    let scene = Compiled::<f32>::of(&Scene::new(draft).expect("a valid scene"));
    let mut candidates = Vec::new();
    let culler = TileCuller::new(&scene, vec![0, 1]);
    culler.candidates(&scene.eye, &[0.0], &[0.0], &mut candidates);
    assert_eq!(candidates, [0], "the margin is {MARGIN}");
}
