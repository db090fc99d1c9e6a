//! Bounds on what rays can meet, each with its proof: by the eye rays of a tile, and by shadow
//! rays.

mod shadow;
mod tile;

pub use shadow::cone_bytes;
pub(crate) use shadow::{LightCones, Occluders, POINT};
pub(crate) use tile::TileCuller;
