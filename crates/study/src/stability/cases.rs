//! The cases, by what is stiff or extreme in them. Each file measures its own with every
//! formula; what they are held to stands in `bounds.rs`.
//!
//! ```text
//! workshop.rs    the workshop's scene
//! large.rs       large spheres: the ground, radii of 1e5 to 1e12
//! distant.rs     tiny far spheres, grazing rays
//! apart.rs       things of very different sizes and distances, narrow views from afar
//! contact.rs     pairs with small gaps, shadows at a contact, the sphere just left
//! invariance.rs  the scene moved, turned, scaled, with what no ray meets, with every surface twice
//! stiff.rs       mirrors between which errors grow
//! mirrors.rs     paths of many reflections
//! refusals.rs    what is not a scene
//! edges.rs       the ends of ranges, and odd places for eye and lights
//! extreme.rs     generated scenes of any magnitude
//! scenes.rs      scenes that several of these use
//! ```

pub(crate) mod apart;
pub(crate) mod contact;
pub(crate) mod distant;
pub(crate) mod edges;
pub(crate) mod extreme;
pub(crate) mod invariance;
pub(crate) mod large;
pub(crate) mod mirrors;
pub(crate) mod refusals;
pub(crate) mod scenes;
mod stiff;
pub(crate) mod workshop;
