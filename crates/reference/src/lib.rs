//! The ray tracer as a workshop writes it: a recursion over mirrors, in f32. [`double`] is the
//! same recursion in f64.
//!
//! This is the specification. Read [`trace`](mod@trace) first; then the shapes beside it in the
//! order `textbook`, `robust_sphere`, `general_sphere`. The packet engine does the same operations
//! in the same order, so its picture has the same bits; where the two differ, one of them is wrong.
//!
//! Arithmetic: every + - * / and square root is rounded once, in the order written; dot
//! products are (x + y) + z; nothing is fused. A comparison with NaN is false, and the
//! formulas are written so that a NaN distance is a miss.
//!
//! ```
//! use catoptric_scene::{Compiled, Document, Film, Grid, SceneFormat, View};
//!
//! let text = b"[[lights]]\nposition = [0, 20, 0]\n
//!     [[spheres]]\ncenter = [0, 0, -20]\nradius = 4\ncolor = [1.0, 0.3, 0.4]\n";
//! let scene = Document::parse("red.toml", text, SceneFormat::Toml)?.into_scene()?;
//! let grid = Grid::new(&View::whole(&scene));
//! let mut film = Film::new(grid.width, grid.height);
//! catoptric_reference::render(&Compiled::new(&scene), &grid, &mut film, &|_| ())?;
//! assert!(film.pixels()[240 * 640 + 320][0] > 0.1);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```

mod depth;
pub mod double;
mod recursion;
pub mod truth;

pub use depth::{DEPTH_ALLOWED, STACK_BYTES, TooDeep};
pub use recursion::{path, power, ray, render, trace};

/// Numbers of the recursion: f32. In [`double`] the same names mean f64.
mod real {
    pub(crate) use std::f32::consts;

    pub(crate) use glam::Vec3;

    pub(crate) type Real = f32;
    pub(crate) type Bits = u32;
}
