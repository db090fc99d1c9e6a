//! Materials by chance.

use super::draws::Draws;
use crate::{Draft, Material, MaterialId};

/// A few materials that differ in colour. Spheres share them, since files write a shared
/// material once and renderers compile it once.
pub(super) struct Palette([MaterialId; 8]);

impl Palette {
    /// Adds materials of eight colours, all with the same factors, to a draft.
    pub(super) fn new(
        draws: &mut Draws,
        [diffuse, specular, reflect]: [f64; 3],
        draft: &mut Draft,
    ) -> Self {
        Self(std::array::from_fn(|_| {
            let (color, reflect) = (colour(draws), Some(reflect));
            let material = Material { color, diffuse, specular, shininess: 30.0, reflect };
            draft.materials.add(material)
        }))
    }

    /// One of the materials by chance, from one draw.
    pub(super) fn any(&self, draws: &mut Draws) -> MaterialId {
        let index = draws.below(self.0.len() as u64);
        self.0[usize::try_from(index).expect("below eight")]
    }

    /// The material of a number; numbers past the last start again at the first.
    pub(super) fn at(&self, index: usize) -> MaterialId {
        self.0[index % self.0.len()]
    }
}

/// A clear colour: one channel strong, one weak, one anywhere. Four draws; in hundredths,
/// which is enough for the eye and short in files.
fn colour(draws: &mut Draws) -> [f64; 3] {
    let channels = [draws.between(0.75, 1.0), draws.between(0.15, 0.9), draws.between(0.1, 0.35)];
    let order = match draws.below(6) {
        0 => [0, 1, 2],
        1 => [0, 2, 1],
        2 => [1, 0, 2],
        3 => [1, 2, 0],
        4 => [2, 0, 1],
        _ => [2, 1, 0],
    };
    order.map(|channel: usize| (channels[channel] * 100.0).floor() / 100.0)
}
