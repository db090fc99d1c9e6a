//! A scene as stated: plain numbers, not yet known to be valid.
//!
//! World units are the author's own; all numbers are f64. The defaults are those of the
//! scene format (`scenes/README.md`).

use crate::materials::{Material, MaterialId, Materials};

/// How rays meet surfaces: which formulas are used.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Numerics {
    /// No epsilon, forms chosen for accuracy. The default.
    #[default]
    Robust,
    /// The workshop's formulas to the letter; they speckle.
    Textbook,
}

/// How linear light becomes an 8-bit level.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Transfer {
    /// Level = 255 times the linear value: the workshop's way, the default.
    #[default]
    Linear,
    /// The sRGB curve (IEC 61966-2-1).
    Srgb,
}

/// Size and transfer of the picture.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Image {
    /// Columns, 1 to 65 535.
    pub width: u32,
    /// Rows, 1 to 65 535.
    pub height: u32,
    /// Transfer of 8-bit pictures; others do not use it.
    pub transfer: Transfer,
}

impl Default for Image {
    fn default() -> Self {
        Self { width: 640, height: 480, transfer: Transfer::default() }
    }
}

/// A pinhole camera.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Camera {
    /// The eye.
    pub position: [f64; 3],
    /// A point straight ahead; apart from `position`.
    pub look_at: [f64; 3],
    /// Direction that is up in the picture; not parallel to the view, any length.
    pub up: [f64; 3],
    /// Vertical field of view in degrees, in (0, 180).
    pub fov: f64,
}

impl Default for Camera {
    fn default() -> Self {
        Self { position: [0.0; 3], look_at: [0.0, 0.0, -1.0], up: [0.0, 1.0, 0.0], fov: 30.0 }
    }
}

/// Settings that hold for the whole picture.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Render {
    /// Reflections followed: the eye ray is depth 0. Every u32 is legal.
    pub max_depth: u32,
    /// A reflected ray whose cumulative weight is below this adds black.
    pub min_weight: f64,
    /// Linear RGB of a ray that meets nothing.
    pub background: [f64; 3],
    /// Linear RGB that multiplies every material's colour.
    pub ambient: [f64; 3],
    /// Formulas that rays meet surfaces by.
    pub numerics: Numerics,
}

impl Default for Render {
    fn default() -> Self {
        Self {
            max_depth: 5,
            min_weight: 0.0,
            background: [0.0; 3],
            ambient: [0.1; 3],
            numerics: Numerics::default(),
        }
    }
}

/// A point light without fall-off.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Position in world units.
    pub position: [f64; 3],
    /// Intensity in linear RGB.
    pub intensity: [f64; 3],
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Centre in world units.
    pub center: [f64; 3],
    /// Radius in world units, in [1e-12, 1e12].
    pub radius: f64,
    /// Material of the sphere.
    pub material: MaterialId,
}

/// An infinite plane.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point on the plane.
    pub point: [f64; 3],
    /// Normal, of any length but zero.
    pub normal: [f64; 3],
    /// Material, the same on both sides.
    pub material: MaterialId,
}

/// Sphere or plane of a draft.
#[derive(Clone, Copy, Debug)]
pub enum Body<'a> {
    /// One of [`Draft::spheres`].
    Sphere(&'a Sphere),
    /// One of [`Draft::planes`].
    Plane(&'a Plane),
}

impl Body<'_> {
    /// The body's material.
    #[must_use]
    pub fn material(self) -> MaterialId {
        match self {
            Self::Sphere(sphere) => sphere.material,
            Self::Plane(plane) => plane.material,
        }
    }
}

/// A scene as stated. [`crate::Scene::new`] makes it valid or names what is wrong.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Draft {
    /// Size and transfer.
    pub image: Image,
    /// The eye.
    pub camera: Camera,
    /// Depth, background, ambient, formulas.
    pub render: Render,
    /// Point lights; their order is the order of summation.
    pub lights: Vec<Light>,
    /// Materials of the bodies, and named ones that no body has.
    pub materials: Materials,
    /// Spheres; on equal distance the lower index is seen.
    pub spheres: Vec<Sphere>,
    /// Planes; they come after all spheres in that order.
    pub planes: Vec<Plane>,
}

impl Draft {
    /// All spheres, then all planes: the order of bodies everywhere. Where two are at the same
    /// distance, the first is seen.
    pub fn bodies(&self) -> impl DoubleEndedIterator<Item = Body<'_>> + Clone {
        let spheres = self.spheres.iter().map(Body::Sphere);
        spheres.chain(self.planes.iter().map(Body::Plane))
    }

    /// Gives each body a material of its own: its present one, changed by `change`. Goes in the
    /// order of [`Draft::bodies`].
    pub fn remake_materials(&mut self, mut change: impl FnMut(&mut Material)) {
        let Self { materials, spheres, planes, .. } = self;
        let of_spheres = spheres.iter_mut().map(|sphere| &mut sphere.material);
        for id in of_spheres.chain(planes.iter_mut().map(|plane| &mut plane.material)) {
            let mut material = materials[*id];
            change(&mut material);
            *id = materials.add(material);
        }
    }
}
