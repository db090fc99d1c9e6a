//! Options of the family random.

use catoptric_scene::Draft;
use catoptric_scene::family::{OutOfRange, Placement, Random};
use clap::Args;

use super::own::Own;
use crate::generate::recipe::Recipe;

/// A cloud of balls above a floor, radii over decades
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(in crate::generate) struct Options {
    /// Balls, 0 to 1000000
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          default_value_t = Random::default().balls)]
    balls: u32,

    /// Smallest radius, 1e-9 to 1e9; radii are log-uniform
    #[arg(long, value_name = "R", allow_negative_numbers = true,
          default_value_t = Random::default().min_radius)]
    min_radius: f64,

    /// Largest radius, 1e-9 to 1e9
    #[arg(long, value_name = "R", allow_negative_numbers = true,
          default_value_t = Random::default().max_radius)]
    max_radius: f64,

    /// Balls may overlap and lie inside one another
    #[arg(long)]
    overlap: bool,

    /// Mirror factor of the balls, 0 to 1
    #[arg(long, value_name = "K", allow_negative_numbers = true,
          default_value_t = Random::default().reflect)]
    reflect: f64,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate random
  catoptric generate random --balls 10000 --min-radius 0.01 --seed 42
  catoptric generate random --overlap -o tangle.toml --width 1920 --height 1080";

impl Own for Options {
    fn name(&self) -> &'static str {
        "random"
    }

    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange> {
        let &Self { balls, min_radius, max_radius, overlap, reflect } = self;
        let placement = if overlap { Placement::Anywhere } else { Placement::Apart };
        Random { balls, min_radius, max_radius, placement, reflect, seed }.draft()
    }

    fn recipe(&self) -> Recipe {
        Recipe::new(self.name())
            .with("--balls", self.balls)
            .with("--min-radius", self.min_radius)
            .with("--max-radius", self.max_radius)
            .with_flag("--overlap", self.overlap)
            .with("--reflect", self.reflect)
    }
}
