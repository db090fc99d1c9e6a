//! What is rendered, and what a rendering is: the scene as people state it (f64), its
//! reading, validation and writing, its compilation to f32 or f64 constants, and the film.
//!
//! Nothing here traces a ray. Both renderers start from [`Compiled`] and end in [`Film`].

mod compile;
mod counts;
mod direction;
mod double_double;
mod draft;
mod error;
pub mod family;
mod film;
mod materials;
mod read;
mod scalar;
mod scene;
mod validate;
mod view;
mod write;

pub use compile::{
    CameraAxes, Compiled, EyeRays, GeneralSphere, Phong, PointLight, Power, Primitive,
    RobustSphere, Shape, TextbookPlane, TextbookSphere,
};
pub use counts::{Counts, DepthCount};
pub use double_double::DoubleDouble;
pub use draft::{Body, Camera, Draft, Image, Light, Numerics, Plane, Render, Sphere, Transfer};
pub use error::{SceneError, is_visible, shown};
pub use film::{Film, Quantiser};
pub use materials::{Material, MaterialId, Materials};
pub use read::{Document, SceneFormat};
pub use scalar::{Scalar, Wider};
pub use scene::Scene;
pub use validate::allowed;
pub use validate::{MOST_BODIES, MOST_MATERIALS};
pub use view::{Crop, Grid, View, ViewError};
