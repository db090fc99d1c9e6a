//! The depth that is enough for a scene.

use catoptric_core::Isa;
use catoptric_scene::{Compiled, Counts, Film, Grid, Quantiser, Scene, View};

use crate::subject::Subject;
use crate::tracer::{TooDeep, Tracer};

/// Depths at which a scene's picture is as good as at its own `max_depth`.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Enough {
    /// The smallest `max_depth` that changes no bit.
    pub same_bits: u32,
    /// The smallest one at which no 8-bit level is off by more than one, transfer as stated.
    pub within_a_level: u32,
    /// The deepest ray.
    pub deepest_ray: u32,
    /// Rays of each depth, to the scene's own `max_depth`.
    pub counts: Counts,
}

/// Finds them by rendering the whole picture again, on rayon's current threads. What is known
/// of a depth holds of all greater ones: where a fold no longer changes a pixel, deeper ones do
/// not either, up to the last place. Memory: two films.
///
/// # Errors
/// A path deeper than the engine's stack.
pub fn enough(scene: &Scene, isa: Isa) -> Result<Enough, TooDeep> {
    let subject = Subject { name: String::new(), scene: scene.clone() };
    let grid = Grid::new(&View::whole(scene));
    let quantiser = Quantiser::new(scene.image.transfer);
    let render = |depth: u32| {
        let mut film = Film::new(grid.width, grid.height);
        let compiled = Compiled::new(&subject.to_depth(depth));
        let counts = Tracer::Packet(isa).render(&compiled, &grid, &mut film)?;
        Ok((film, counts))
    };
    let (full, counts) = render(scene.render.max_depth)?;
    let deepest_ray = u32::try_from(counts.depths.len().saturating_sub(1)).unwrap_or(u32::MAX);

    let smallest = |is_enough: &dyn Fn(&Film) -> bool| -> Result<u32, TooDeep> {
        let (mut low, mut high) = (0, deepest_ray);
        while low < high {
            let middle = low + (high - low) / 2;
            if is_enough(&render(middle)?.0) { high = middle } else { low = middle + 1 }
        }
        Ok(low)
    };
    let values = |film: &Film, enough: &dyn Fn(f32, f32) -> bool| {
        let pairs = film.pixels().as_flattened().iter().zip(full.pixels().as_flattened());
        pairs.into_iter().all(|(a, b)| enough(*a, *b))
    };
    let same_bits = smallest(&|film| values(film, &|a, b| a.to_bits() == b.to_bits()))?;
    let levels_apart = |a: f32, b: f32| quantiser.level(a).abs_diff(quantiser.level(b));
    let within_a_level = smallest(&|film| values(film, &|a, b| levels_apart(a, b) <= 1))?;
    Ok(Enough { same_bits, within_a_level, deepest_ray, counts })
}
