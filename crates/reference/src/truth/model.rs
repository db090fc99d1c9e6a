//! The scene in truth's arithmetic, with the constants that the eye's cell gives.
//!
//! Mirrors keep every path in the cell of space that the eye is in: no ray crosses a
//! surface. Thus the side of a primitive on which the path runs is a constant of the scene, and
//! so is whether a light stands on that side. Both are decided once, in double-double for
//! either arithmetic, straight from the stated numbers: a camera or a light exactly on a
//! surface is seen to be there as long as the squares involved fit 106 bits.

use std::array::from_fn;
use std::cmp::Ordering;

use catoptric_scene::{self as scene, Body, DoubleDouble, Scene};

use super::camera::Eye;
use super::real::Real;
use super::vector::Vector;

pub(super) struct Model<T> {
    pub(super) eye: Eye<T>,
    /// Spheres in file order, then planes; never two that are the same surface twice.
    pub(super) primitives: Vec<Primitive<T>>,
    pub(super) lights: Vec<Light<T>>,
    pub(super) background: [T; 3],
    pub(super) max_depth: u32,
    pub(super) min_weight: T,
}

pub(super) struct Primitive<T> {
    /// Index among the scene's spheres, then planes.
    pub(super) id: usize,
    pub(super) shape: Shape<T>,
    pub(super) surface: Surface<T>,
}

pub(super) enum Shape<T> {
    /// A sphere. `around`: the eye is strictly inside.
    Sphere { center: Vector<T>, radius: T, around: bool },
    /// A plane. `normal`: of length 1, on the eye's side (on the stated side if the eye is on it).
    Plane { point: Vector<T>, normal: Vector<T> },
}

pub(super) struct Surface<T> {
    /// Ambient light times colour.
    pub(super) ambient: [T; 3],
    /// kd times colour.
    pub(super) diffuse: [T; 3],
    pub(super) specular: T,
    pub(super) shininess: f64,
    /// The mirror factor k.
    pub(super) mirror: T,
}

pub(super) struct Light<T> {
    pub(super) position: Vector<T>,
    pub(super) intensity: [T; 3],
    /// Side of each primitive: `Greater` on the eye's, `Equal` on the surface, else `Less`.
    pub(super) sides: Vec<Ordering>,
}

impl<T: Real> Model<T> {
    pub(super) fn new(scene: &Scene) -> Self {
        let eye = scene.camera.position;
        let stated = distinct(scene);
        let light = |light: &scene::Light| Light {
            position: Vector::from(light.position),
            intensity: light.intensity.map(T::from),
            sides: stated.iter().map(|(_, s)| s.side(light.position, eye)).collect(),
        };
        Self {
            eye: Eye::new(&scene.camera, scene.image),
            lights: scene.lights.iter().map(light).collect(),
            primitives: stated.iter().map(|&(id, s)| s.primitive(id, scene)).collect(),
            background: scene.render.background.map(T::from),
            max_depth: scene.render.max_depth,
            min_weight: T::from(scene.render.min_weight),
        }
    }
}

/// A sphere or plane as the scene states it.
#[derive(Clone, Copy)]
struct Stated<'a>(Body<'a>);

/// The scene's primitives with their indices, without those that repeat an earlier surface.
///
/// A repeated surface is never seen, since ties go to the lowest index, and hides nothing
/// that the first does not. Left in, it would tie with the first in exact arithmetic only:
/// the surface that a ray has just left offers its root in another form than its twin.
fn distinct(scene: &Scene) -> Vec<(usize, Stated<'_>)> {
    let mut kept: Vec<(usize, Stated<'_>)> = Vec::new();
    for (id, body) in scene.bodies().enumerate() {
        if !kept.iter().any(|(_, earlier)| earlier.same_surface(Stated(body))) {
            kept.push((id, Stated(body)));
        }
    }
    kept
}

impl Stated<'_> {
    fn same_surface(self, other: Self) -> bool {
        match (self.0, other.0) {
            (Body::Sphere(a), Body::Sphere(b)) => a.center == b.center && a.radius == b.radius,
            (Body::Plane(a), Body::Plane(b)) => a.point == b.point && a.normal == b.normal,
            _ => false,
        }
    }

    /// Side of a point: `Greater` outside a sphere or where a plane's stated normal points, `Equal`
    /// on the surface, else `Less`.
    fn stated_side(self, at: [f64; 3]) -> Ordering {
        let at = Vector::<DoubleDouble>::from(at);
        let (value, zero_level) = match self.0 {
            Body::Sphere(s) => {
                let (f, r) = (at - Vector::from(s.center), DoubleDouble::from(s.radius));
                (f.dot(f), r * r)
            }
            Body::Plane(p) => {
                let normal = Vector::from(p.normal).tamed();
                (normal.dot(at - Vector::from(p.point)), DoubleDouble::from(0.0))
            }
        };
        value.partial_cmp(&zero_level).unwrap_or(Ordering::Equal)
    }

    /// Whether the stated side is turned to suit an eye on the other one.
    fn turned(self, eye: [f64; 3]) -> bool {
        self.stated_side(eye) == Ordering::Less
    }

    /// Side of a point: `Greater` on the eye's side, `Equal` on the surface, `Less` beyond it.
    fn side(self, at: [f64; 3], eye: [f64; 3]) -> Ordering {
        let side = self.stated_side(at);
        if self.turned(eye) { side.reverse() } else { side }
    }

    fn primitive<T: Real>(self, id: usize, scene: &Scene) -> Primitive<T> {
        let turned = self.turned(scene.camera.position);
        let shape = match self.0 {
            Body::Sphere(s) => {
                let (center, radius) = (Vector::from(s.center), T::from(s.radius));
                Shape::Sphere { center, radius, around: turned }
            }
            Body::Plane(p) => {
                let normal = Vector::from(p.normal).tamed().unit();
                let normal = if turned { -normal } else { normal };
                Shape::Plane { point: Vector::from(p.point), normal }
            }
        };
        let material = &scene.materials[self.0.material()];
        Primitive { id, shape, surface: Surface::new(material, scene.render.ambient) }
    }
}

impl<T: Real> Surface<T> {
    fn new(material: &scene::Material, ambient: [f64; 3]) -> Self {
        let color = material.color.map(T::from);
        Self {
            ambient: from_fn(|c| T::from(ambient[c]) * color[c]),
            diffuse: color.map(|c| T::from(material.diffuse) * c),
            specular: T::from(material.specular),
            shininess: material.shininess,
            mirror: T::from(material.mirror()),
        }
    }
}
