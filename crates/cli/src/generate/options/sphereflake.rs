//! Options of the family sphereflake.

use catoptric_scene::Draft;
use catoptric_scene::family::{OutOfRange, Sphereflake};
use clap::Args;

use super::own::Own;
use crate::generate::recipe::Recipe;

/// A ball with nine children of a third of its size, each with nine children, ...
///
/// The `balls` scene of Haines' Standard Procedural Databases, seen as there. Levels 0 to 6
/// make 1, 10, 91, 820, 7381, 66430, 597871 balls.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(in crate::generate) struct Options {
    /// Generations after the first ball, 0 to 6
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          default_value_t = Sphereflake::default().levels)]
    levels: u32,

    /// Mirror factor of the balls, 0 to 1
    #[arg(long, value_name = "K", allow_negative_numbers = true,
          default_value_t = Sphereflake::default().reflect)]
    reflect: f64,

    /// Radius of a sphere that stands for the ground, 10 to 1e12 [default: a plane]
    #[arg(long, value_name = "R", allow_negative_numbers = true)]
    ground_radius: Option<f64>,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate sphereflake
  catoptric generate sphereflake --levels 3 --ground-radius 10000
  catoptric generate sphereflake --levels 2 -o - | catoptric render - -o flake.png";

impl Own for Options {
    fn name(&self) -> &'static str {
        "sphereflake"
    }

    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange> {
        let &Self { levels, reflect, ground_radius } = self;
        Sphereflake { levels, reflect, ground_radius, seed }.draft()
    }

    fn recipe(&self) -> Recipe {
        Recipe::new(self.name())
            .with("--levels", self.levels)
            .with("--reflect", self.reflect)
            .with_any("--ground-radius", self.ground_radius)
    }
}
