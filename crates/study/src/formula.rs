//! What is measured: the workshop's formulas, the robust ones, and the latter in f64.

use catoptric_core::Isa;
use catoptric_scene::{Compiled, Counts, Draft, Film, Grid, Numerics, Scalar, Scene, View};

use crate::stability::paths::{Arithmetic, with_numerics};
use crate::tracer::{Renders, TooDeep, Tracer};

/// 2^-24: half an ulp of 1 in f32.
pub const U: f64 = f32::EPSILON as f64 / 2.0;

/// Formulas and the arithmetic that they are computed in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Formula {
    /// The workshop's formulas in f32.
    TextbookF32,
    /// The robust forms in f32: what is rendered unless something else is asked.
    RobustF32,
    /// The robust forms in f64.
    RobustF64,
}

impl Formula {
    /// All formulas.
    pub const ALL: [Self; 3] = [Self::TextbookF32, Self::RobustF32, Self::RobustF64];

    /// The formulas in f32.
    pub const F32: [Self; 2] = [Self::TextbookF32, Self::RobustF32];

    /// The formula's name in reports.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::TextbookF32 => "textbook f32",
            Self::RobustF32 => "robust f32",
            Self::RobustF64 => "robust f64",
        }
    }

    /// The arithmetic that the formula's paths are computed in.
    #[must_use]
    pub fn arithmetic(self) -> Arithmetic {
        match self {
            Self::TextbookF32 => Arithmetic::Textbook,
            Self::RobustF32 => Arithmetic::Robust,
            Self::RobustF64 => Arithmetic::RobustF64,
        }
    }

    /// The unit roundoff of its arithmetic: half an ulp of 1.
    #[must_use]
    pub fn u(self) -> f64 {
        match self {
            Self::TextbookF32 | Self::RobustF32 => U,
            Self::RobustF64 => f64::EPSILON / 2.0,
        }
    }

    /// Numbers as its arithmetic holds them.
    pub(crate) fn rounded(self, v: [f64; 3]) -> [f64; 3] {
        match self {
            Self::TextbookF32 | Self::RobustF32 => v.map(|x| f64::from(f32::rounded(x))),
            Self::RobustF64 => v,
        }
    }

    /// The scene, to be rendered with this formula.
    ///
    /// # Panics
    /// If the draft is not valid.
    #[must_use]
    pub fn scene(self, draft: &Draft) -> Scene {
        let numerics = match self {
            Self::TextbookF32 => Numerics::Textbook,
            Self::RobustF32 | Self::RobustF64 => Numerics::Robust,
        };
        with_numerics(draft, numerics)
    }

    /// The whole picture, by the packet engine, which has the recursion's bits.
    ///
    /// # Errors
    /// A path is deeper than the engine's stack.
    pub fn picture(self, draft: &Draft) -> Result<Vec<[f64; 3]>, TooDeep> {
        let scene = self.scene(draft);
        match self {
            Self::RobustF64 => Ok(pixels(&packets::<f64>(&scene)?.0)),
            Self::TextbookF32 | Self::RobustF32 => Ok(pixels(&packets::<f32>(&scene)?.0)),
        }
    }
}

/// The packet engine's picture and rays.
pub(crate) fn packets<S: Renders>(scene: &Scene) -> Result<(Film<S>, Counts), TooDeep> {
    let grid = Grid::of(&View::whole(scene));
    let mut film = Film::black(grid.width, grid.height);
    let tracer = Tracer::Packet(Isa::detected());
    let counts = tracer.render(&Compiled::of(scene), &grid, &mut film)?;
    Ok((film, counts))
}

/// A picture as numbers that can be compared with truth.
pub(crate) fn pixels<S: Renders>(film: &Film<S>) -> Vec<[f64; 3]> {
    film.pixels().iter().map(|pixel| pixel.map(S::to_f64)).collect()
}
