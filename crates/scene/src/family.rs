//! Families of scenes: from a few numbers and a seed to a scene.
//!
//! A family is a plain struct of parameters with defaults; its `draft` makes the scene, or
//! says which parameter is out of its range. Parameters in range always make a valid scene.
//! The draft's image is the format's default, 640 x 480; set another one before the draft
//! becomes a scene.
//!
//! The same parameters and seed make the same scene, to the bit, on every machine and in
//! every version: numbers come from one written generator (`draws`), and only from
//! operations that IEEE 754 rounds correctly (+, -, x, / and the square root).
//!
//! ```text
//! corridor.rs     two mirrors face each other, spheres between them
//! room.rs         a closed mirror sphere, spheres and the eye inside
//! kissing.rs      spheres that touch: a cluster, a ring, a chain
//! random.rs       a cloud of spheres, radii over decades
//! lattice.rs      spheres on a cubic grid
//! sphereflake.rs  a sphere with nine children, each with nine children, ...
//! ```

mod cells;
mod corridor;
mod draws;
mod kissing;
mod lattice;
mod palette;
mod parameter;
mod random;
mod room;
mod sphereflake;
mod turn;

pub use corridor::Corridor;
pub use draws::Draws;
pub use kissing::{Arrangement, Kissing};
pub use lattice::Lattice;
pub use parameter::{MOST_BALLS, OutOfRange};
pub use random::{Placement, Random};
pub use room::Room;
pub use sphereflake::Sphereflake;
