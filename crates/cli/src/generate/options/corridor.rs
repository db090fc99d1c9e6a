//! Options of the family corridor.

use catoptric_scene::Draft;
use catoptric_scene::family::{Corridor, OutOfRange};
use clap::Args;

use super::own::Own;
use crate::generate::recipe::Recipe;

/// Two mirrors face each other, balls between them
///
/// Mirrors at z = -4 and 4, a matt floor, the eye in front of one mirror. Nearly every ray
/// runs to the greatest depth, which is 32 unless --max-depth says another.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(in crate::generate) struct Options {
    /// Balls on the floor, 0 to 1000000
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          default_value_t = Corridor::default().balls)]
    balls: u32,

    /// Mirror factor of the mirrors, 0 to 1
    #[arg(long, value_name = "K", allow_negative_numbers = true,
          default_value_t = Corridor::default().reflect)]
    reflect: f64,

    /// Radius of two spheres that stand for the mirrors, 10 to 1e12 [default: planes]
    #[arg(long, value_name = "R", allow_negative_numbers = true)]
    mirror_radius: Option<f64>,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate corridor
  catoptric generate corridor --balls 50 --max-depth 100 --seed 3
  catoptric generate corridor --mirror-radius 1000 --reflect 0.99 -o curved.toml";

impl Own for Options {
    fn name(&self) -> &'static str {
        "corridor"
    }

    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange> {
        let &Self { balls, reflect, mirror_radius } = self;
        Corridor { balls, reflect, mirror_radius, seed }.draft()
    }

    fn recipe(&self) -> Recipe {
        Recipe::new(self.name())
            .with("--balls", self.balls)
            .with("--reflect", self.reflect)
            .with_any("--mirror-radius", self.mirror_radius)
    }
}
