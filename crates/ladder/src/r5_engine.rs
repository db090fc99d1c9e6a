//! Rung 5, the engine: rung 4 with the shading in eight lanes too (`core::trace`).
//!
//! The engine knows no events. Here, what its loop leaves on its stack on the way down and takes
//! off on the way up is turned into the events of the other rungs.

use catoptric_core::watch::{Bounce, Fold};
use catoptric_core::{Engine, Settings};
use catoptric_scene::{Compiled, Counts, Film, Grid};
use glam::Vec3;

use crate::{Error, Event, Watch};

pub(crate) fn render(
    scene: &Compiled,
    grid: &Grid,
    film: &mut Film,
    settings: Settings,
) -> Result<Counts, Error> {
    Ok(Engine::new(scene).with(settings).render(grid, film)?)
}

pub(crate) fn watch(
    scene: &Compiled,
    grid: &Grid,
    (column, row): (usize, usize),
    settings: Settings,
    watch: &mut dyn Watch,
) -> Result<Vec3, Error> {
    let (column, row) = (grid.columns[column], grid.rows[row]);
    let mut words = Words { scene, watch, depth: 0 };
    Ok(catoptric_core::watch::watch(scene, column, row, settings, &mut words)?.into())
}

/// Turns the engine's levels into events.
struct Words<'a> {
    scene: &'a Compiled,
    watch: &'a mut dyn Watch,
    /// Depth of the level that comes next.
    depth: u32,
}

impl catoptric_core::watch::Watch for Words<'_> {
    fn bounce(&mut self, bounce: Bounce) {
        let (depth, weight) = (self.depth, bounce.weight);
        let (origin, direction) = (bounce.origin.into(), bounce.direction.into());
        self.watch.see(Event::Call { depth, origin, direction, weight });
        let (local, followed) = (bounce.local.into(), bounce.reflectance > 0.0);
        if let Some((primitive, distance)) = bounce.met {
            let primitive = primitive as usize;
            // The engine keeps k only with a ray that goes on. For a mirror that is not followed,
            // k is the scene's.
            let material = self.scene.primitives[primitive].material as usize;
            let k =
                if followed { bounce.reflectance } else { self.scene.materials[material].mirror };
            self.watch.see(Event::Hit { depth, primitive, distance, local, k, followed });
        }
        if followed {
            self.depth += 1;
        } else {
            self.watch.see(Event::Return { depth, colour: local });
        }
    }

    fn fold(&mut self, fold: Fold) {
        // The deepest level owes nothing, and has returned.
        if fold.reflectance > 0.0 {
            self.depth -= 1;
            let (depth, local, k) = (self.depth, fold.local.into(), fold.reflectance);
            let (back, colour) = (fold.back.into(), fold.colour.into());
            self.watch.see(Event::Fold { depth, local, k, back, colour });
            self.watch.see(Event::Return { depth, colour });
        }
    }
}
