//! Scene to constants in f32 or f64: recentre on the camera, turn into its axes, choose a form for
//! each primitive, round once.
//!
//! Subtraction and turning are done in double-double. So a scene far from the origin, or turned
//! against the world's axes, compiles to the same constants as the same scene around the origin, as
//! far as f64 could state it. Both renderers start from these constants and nothing else. The form
//! of each primitive, and which lights are hidden, is decided on the stated scene: neither depends
//! on the scalar.

mod camera;
mod constants;
mod forms;
mod hidden;
mod material;

use std::collections::HashMap;

pub use camera::{CameraAxes, EyeRays};
pub use forms::{GeneralSphere, RobustSphere, Shape, TextbookPlane, TextbookSphere};
pub use material::{Phong, Power};

use crate::{Draft, MaterialId, Numerics, Scalar, Scene};
use constants::{colour, nearest3, rounded3};

/// A scene as the renderers read it: in the camera's own axes, the eye at the origin.
#[derive(Clone, Debug)]
pub struct Compiled<S: Scalar = f32> {
    /// Formulas in use. Robust scenes hold the two robust shapes, textbook scenes the other two.
    pub numerics: Numerics,
    /// The camera's own axes, in which everything else here is stated.
    pub axes: CameraAxes,
    /// How a point of the image plane becomes a direction.
    pub eye: EyeRays<S>,
    /// Reflections followed.
    pub max_depth: u32,
    /// Cumulative weight below which a reflected ray adds black.
    pub min_weight: S,
    /// Linear RGB of a ray that meets nothing; 0 for -0.
    pub background: S::Vec3,
    /// Lights in file order, which is the order of summation.
    pub lights: Vec<PointLight<S>>,
    /// The different materials, each once.
    pub materials: Vec<Phong<S>>,
    /// Spheres in file order, then planes: on equal distance the lower index is seen. In a
    /// robust scene a surface that is stated twice stands here once.
    pub primitives: Vec<Primitive<S>>,
}

/// A point light.
#[derive(Clone, Copy, Debug)]
pub struct PointLight<S: Scalar = f32> {
    /// Position in the camera's axes, relative to the eye.
    pub position: S::Vec3,
    /// Linear RGB.
    pub intensity: S::Vec3,
    /// Whether some primitive stands between the light and every point that the eye or a mirror
    /// can see: the light is inside a sphere that the eye is not in, outside one that the eye is
    /// in, or behind a plane. Strictly, decided in double-double; always false in textbook scenes.
    pub hidden: bool,
}

/// A shape and what it is made of.
#[derive(Clone, Copy, Debug)]
pub struct Primitive<S: Scalar = f32> {
    /// Constants of the form chosen for it.
    pub shape: Shape<S>,
    /// Index in [`Compiled::materials`].
    pub material: u32,
    /// Index among the scene's spheres, then planes: differs from the place in
    /// [`Compiled::primitives`] after a surface that is stated twice.
    pub stated: u32,
}

impl Compiled {
    /// Compiles a scene to f32.
    #[must_use]
    pub fn new(scene: &Scene) -> Self {
        Self::of(scene)
    }
}

impl<S: Scalar> Compiled<S> {
    /// Compiles a scene.
    #[must_use]
    pub fn of(scene: &Scene) -> Self {
        let (materials, material_of) = materials(scene);
        let axes = CameraAxes::new(&scene.camera);
        let shapes = forms::shapes(scene, &axes).into_iter().zip(forms::firsts(scene));
        let primitives = (0..)
            .zip(shapes.zip(material_of))
            .filter(|(_, ((_, first), _))| *first)
            .map(|(stated, ((shape, _), material))| Primitive { shape, material, stated })
            .collect();
        Self {
            numerics: scene.render.numerics,
            eye: EyeRays::new(scene),
            axes,
            max_depth: scene.render.max_depth,
            min_weight: S::rounded(scene.render.min_weight),
            background: colour::<S>(scene.render.background),
            lights: lights(scene, &axes),
            materials,
            primitives,
        }
    }
}

/// The lights, in the camera's axes.
fn lights<S: Scalar>(scene: &Draft, axes: &CameraAxes) -> Vec<PointLight<S>> {
    let hidden = match scene.render.numerics {
        Numerics::Robust => hidden::hidden(scene),
        Numerics::Textbook => vec![false; scene.lights.len()],
    };
    let lights = scene.lights.iter().zip(hidden);
    lights
        .map(|(light, hidden)| PointLight {
            position: nearest3::<S>(axes.point(light.position)),
            intensity: rounded3::<S>(light.intensity),
            hidden,
        })
        .collect()
}

/// The different materials in the order of their first bodies, and each body's index among them.
/// Materials that round to the same constants are one: the engine shades their hits together.
fn materials<S: Scalar>(scene: &Draft) -> (Vec<Phong<S>>, Vec<u32>) {
    let mut compiled = Vec::new();
    let mut known = HashMap::new();
    let mut numbers = vec![None; scene.materials.len()];
    let mut number = |id: MaterialId| {
        let phong = Phong::new(&scene.materials[id], scene.render.ambient);
        *known.entry(phong.bits()).or_insert_with(|| {
            compiled.push(phong);
            u32::try_from(compiled.len() - 1).expect("a scene has fewer than 2^22 materials")
        })
    };
    let of_bodies = scene.bodies().map(|body| {
        let id = body.material();
        *numbers[id.index()].get_or_insert_with(|| number(id))
    });
    let of_bodies = of_bodies.collect();
    (compiled, of_bodies)
}
