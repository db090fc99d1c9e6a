//! Options of the family kissing.

use catoptric_scene::Draft;
use catoptric_scene::family::{Arrangement, Kissing, OutOfRange};
use clap::{Args, ValueEnum};

use super::own::Own;
use crate::generate::recipe::Recipe;

/// Mirror spheres that touch: a cluster, a ring or a chain
///
/// They touch as exactly as f64 can state it. Mirror images repeat without end between
/// them; the greatest depth is 50 unless --max-depth says another.
#[derive(Args, Debug)]
#[command(after_help = EXAMPLES)]
pub(in crate::generate) struct Options {
    /// Who touches whom
    #[arg(long, value_enum, value_name = "HOW", default_value_t = Group::Cluster)]
    arrangement: Group,

    /// Spheres: 2 to 4 in a cluster, from 3 in a ring, from 2 in a chain, to 1000000
    #[arg(long, value_name = "N", allow_negative_numbers = true,
          default_value_t = Kissing::default().spheres)]
    spheres: u32,

    /// Their radius, 1e-6 to 1e6
    #[arg(long, value_name = "R", allow_negative_numbers = true,
          default_value_t = Kissing::default().radius)]
    radius: f64,

    /// Their mirror factor, 0 to 1
    #[arg(long, value_name = "K", allow_negative_numbers = true,
          default_value_t = Kissing::default().reflect)]
    reflect: f64,
}

const EXAMPLES: &str = "\
Examples:
  catoptric generate kissing
  catoptric generate kissing --spheres 3
  catoptric generate kissing --arrangement ring --spheres 12 -o ring.toml
  catoptric generate kissing --arrangement chain --spheres 5 --reflect 1";

impl Own for Options {
    fn name(&self) -> &'static str {
        "kissing"
    }

    fn draft(&self, seed: u64) -> Result<Draft, OutOfRange> {
        let &Self { arrangement, spheres, radius, reflect } = self;
        let arrangement = match arrangement {
            Group::Cluster => Arrangement::Cluster,
            Group::Ring => Arrangement::Ring,
            Group::Chain => Arrangement::Chain,
        };
        Kissing { arrangement, spheres, radius, reflect, seed }.draft()
    }

    fn recipe(&self) -> Recipe {
        Recipe::new(self.name())
            .with("--arrangement", self.arrangement.name())
            .with("--spheres", self.spheres)
            .with("--radius", self.radius)
            .with("--reflect", self.reflect)
    }
}

/// The arrangements, as the command line names them.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Group {
    /// each touches every other
    Cluster,
    /// each touches two others, around a circle
    Ring,
    /// along a straight line
    Chain,
}

impl Group {
    fn name(self) -> &'static str {
        match self {
            Self::Cluster => "cluster",
            Self::Ring => "ring",
            Self::Chain => "chain",
        }
    }
}
