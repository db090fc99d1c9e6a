//! Options of the family lattice.

use catoptric_scene::Draft;
use catoptric_scene::family::{Lattice, OutOfRange};
use clap::Args;

use super::own::Own;
use crate::generate::recipe::Recipe;

/// Equal balls on a cubic grid
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(in crate::generate) struct Options {
    /// Balls along an edge, 1 to 100: N x N x N in all
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          default_value_t = Lattice::default().edge)]
    edge: u32,

    /// Their radius, 1e-6 to 0.5, at which they touch
    #[arg(long, value_name = "R", allow_negative_numbers = true,
          default_value_t = Lattice::default().radius)]
    radius: f64,

    /// Their mirror factor, 0 to 1
    #[arg(long, value_name = "K", allow_negative_numbers = true,
          default_value_t = Lattice::default().reflect)]
    reflect: f64,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate lattice
  catoptric generate lattice --edge 20 --radius 0.5
  catoptric generate lattice --edge 2 --seed 5 -o - --quiet";

impl Own for Options {
    fn name(&self) -> &'static str {
        "lattice"
    }

    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange> {
        let &Self { edge, radius, reflect } = self;
        Lattice { edge, radius, reflect, seed }.draft()
    }

    fn recipe(&self) -> Recipe {
        Recipe::new(self.name())
            .with("--edge", self.edge)
            .with("--radius", self.radius)
            .with("--reflect", self.reflect)
    }
}
