//! Ways to trace a picture in f32: the two renderers, and what leads from one to the other.

use catoptric_core::{Engine, Isa, Omission, Plan, Settings};
use catoptric_ladder::Rung;
use catoptric_scene::{Compiled, Counts, Film, Grid};

use crate::tracer::{STACK_LIMIT, TooDeep, Tracer};

/// One way.
#[derive(Clone, Copy, Debug)]
pub enum Way {
    /// One of the two renderers.
    Tracer(Tracer),
    /// The packet engine with a plan that leaves nothing out.
    Everything(Isa),
    /// The packet engine with a plan that makes no other omissions than these.
    Omitting(Isa, &'static [Omission]),
    /// A rung of the ladder; the instruction set is the engine's.
    Rung(&'static Rung, Isa),
}

impl Way {
    /// `recursive`, `packet`, `r0`, ...
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Tracer(tracer) => tracer.name(),
            Self::Everything(isa) | Self::Omitting(isa, _) => Tracer::Packet(isa).name(),
            Self::Rung(rung, _) => rung.name,
        }
    }

    /// Renders on rayon's current threads.
    ///
    /// # Errors
    /// A path too deep for its stack.
    pub fn render(self, scene: &Compiled, grid: &Grid, film: &mut Film) -> Result<Counts, TooDeep> {
        let packets = |isa, plan: &Plan, film: &mut Film| {
            let settings = Settings { isa, stack_limit: STACK_LIMIT };
            Engine::new(scene).with(settings).render_planned(plan, film).map_err(|_| TooDeep)
        };
        match self {
            Self::Tracer(tracer) => tracer.render(scene, grid, film),
            Self::Everything(isa) => packets(isa, &Plan::new(scene, grid).everything(), film),
            Self::Omitting(isa, omissions) => {
                packets(isa, &Plan::new(scene, grid).only(omissions), film)
            }
            Self::Rung(rung, isa) => {
                let settings = Settings { isa, stack_limit: STACK_LIMIT };
                (rung.render)(scene, grid, film, settings).map_err(|_| TooDeep)
            }
        }
    }
}
