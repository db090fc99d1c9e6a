//! Scene to f32 constants: recentre on the camera, choose a form for each primitive, round
//! once.
//!
//! Everything that is subtracted here is subtracted exactly (double-double), so a scene far
//! from the origin compiles to the same constants as the same scene around it, as far as
//! f64 could state it. Both renderers start from these constants and nothing else.

mod camera;
mod forms;
mod material;

use std::collections::HashMap;

use glam::Vec3;

pub use camera::EyeRays;
pub use forms::{Ball, Flat, Shape, TextbookPlane, TextbookSphere};
pub use material::{Phong, Power};

use crate::{DoubleDouble, Draft, Numerics, Scene};

/// A scene as the renderers read it. The eye is at the origin.
#[derive(Clone, Debug)]
pub struct Compiled {
    /// Which formulas. Robust scenes hold balls and flats, textbook scenes the others.
    pub numerics: Numerics,
    /// How a point of the image plane becomes a direction.
    pub eye: EyeRays,
    /// Reflections followed.
    pub max_depth: u32,
    /// Cumulative weight below which a reflected ray adds black.
    pub min_weight: f32,
    /// Linear RGB of a ray that meets nothing.
    pub background: Vec3,
    /// In file order, which is the order of summation.
    pub lights: Vec<PointLight>,
    /// Each different material once.
    pub materials: Vec<Phong>,
    /// Spheres in file order, then planes: on equal distance the lower index is seen. In a
    /// robust scene the same surface stands here once.
    pub primitives: Vec<Primitive>,
}

/// A point light.
#[derive(Clone, Copy, Debug)]
pub struct PointLight {
    /// Relative to the eye.
    pub position: Vec3,
    /// Linear RGB.
    pub intensity: Vec3,
    /// Robust only: some primitive stands between the light and every point that the eye or
    /// a mirror can see. It is inside a sphere that the eye is not in, outside one that the
    /// eye is in, or behind a plane; strictly, decided in double-double.
    pub hidden: bool,
}

/// A shape and what it is made of.
#[derive(Clone, Copy, Debug)]
pub struct Primitive {
    /// Constants of the form chosen for it.
    pub shape: Shape,
    /// Index in [`Compiled::materials`].
    pub material: u32,
}

impl Compiled {
    /// Compiles a scene.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        let (materials, material_of) = materials(scene);
        let shapes = forms::shapes(scene).into_iter().zip(forms::firsts(scene));
        let primitives = shapes
            .zip(material_of)
            .filter(|((_, first), _)| *first)
            .map(|((shape, _), material)| Primitive { shape, material })
            .collect();
        Self {
            numerics: scene.render.numerics,
            eye: EyeRays::new(scene),
            max_depth: scene.render.max_depth,
            min_weight: rounded(scene.render.min_weight),
            background: rounded3(scene.render.background),
            lights: lights(scene),
            materials,
            primitives,
        }
    }
}

/// The lights, relative to the eye.
fn lights(scene: &Draft) -> Vec<PointLight> {
    let robust = scene.render.numerics == Numerics::Robust;
    scene
        .lights
        .iter()
        .map(|light| PointLight {
            position: from_eye(scene, light.position).map(DoubleDouble::to_f32).into(),
            intensity: rounded3(light.intensity),
            hidden: robust && forms::hides(scene, light.position),
        })
        .collect()
}

/// The different materials, and for every primitive the index of its own.
fn materials(scene: &Draft) -> (Vec<Phong>, Vec<u32>) {
    let ambient = scene.render.ambient;
    let mut known = HashMap::new();
    let mut compiled = Vec::new();
    let of_spheres = scene.spheres.iter().map(|s| &s.material);
    let of_planes = scene.planes.iter().map(|p| &p.material);
    let indices = of_spheres
        .chain(of_planes)
        .map(|stated| {
            let phong = Phong::new(stated, ambient);
            *known.entry(phong.bits()).or_insert_with(|| {
                compiled.push(phong);
                u32::try_from(compiled.len() - 1).expect("fewer than 2^32 materials fit in memory")
            })
        })
        .collect();
    (compiled, indices)
}

/// A point relative to the eye, exact.
fn from_eye(scene: &Draft, point: [f64; 3]) -> [DoubleDouble; 3] {
    let eye = scene.camera.position;
    std::array::from_fn(|i| DoubleDouble::difference(point[i], eye[i]))
}

/// The unit vector of a direction of a valid scene.
fn unit(v: [f64; 3]) -> [f64; 3] {
    crate::direction::unit(v).expect("a valid scene's directions are not zero")
}

/// The one rounding from f64.
#[expect(clippy::cast_possible_truncation, reason = "this is the rounding")]
fn rounded(x: f64) -> f32 {
    x as f32
}

fn rounded3(v: [f64; 3]) -> Vec3 {
    v.map(rounded).into()
}
