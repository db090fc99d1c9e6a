//! Options of the family room.

use catoptric_scene::Draft;
use catoptric_scene::family::{OutOfRange, Room};
use clap::Args;

use super::own::Own;
use crate::generate::recipe::Recipe;

/// A closed mirror sphere, balls and the eye inside
///
/// No ray escapes, so every path runs to the greatest depth, which is 64 unless --max-depth
/// says another. The background would show as magenta where a ray leaked.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(in crate::generate) struct Options {
    /// Radius of the room, 0.001 to 1e9
    #[arg(long, value_name = "R", allow_negative_numbers = true,
          default_value_t = Room::default().radius)]
    radius: f64,

    /// Balls in it, 0 to 1000000
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          default_value_t = Room::default().balls)]
    balls: u32,

    /// Mirror factor of the wall, 0 to 1
    #[arg(long, value_name = "K", allow_negative_numbers = true,
          default_value_t = Room::default().reflect)]
    reflect: f64,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate room
  catoptric generate room --radius 1e6 --balls 20 --reflect 1
  catoptric generate room --balls 3 --max-depth 1000 --format json";

impl Own for Options {
    fn name(&self) -> &'static str {
        "room"
    }

    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange> {
        let &Self { radius, balls, reflect } = self;
        Room { radius, balls, reflect, seed }.draft()
    }

    fn recipe(&self) -> Recipe {
        Recipe::new(self.name())
            .with("--radius", self.radius)
            .with("--balls", self.balls)
            .with("--reflect", self.reflect)
    }
}
