//! What tracing reads, made once a rendering.

use catoptric_scene::{Compiled, PointLight};

use crate::cull::{Occluders, TileCuller};
use crate::omission::Omissions;
use crate::simd::Lane;

/// Everything that all threads of a rendering read.
pub(crate) struct Frame<'a, S: Lane> {
    pub(crate) scene: &'a Compiled<S>,
    /// The primitives that rays are tested against: all of them by reflected rays.
    pub(crate) tiles: TileCuller,
    pub(crate) occluders: Occluders<S>,
    /// The lights, all marked hidden; used for materials that reflect none
    /// ([`crate::Omission::Shadows`]).
    pub(crate) hidden_lights: Vec<PointLight<S>>,
    /// Reflections followed.
    pub(crate) depth: u32,
    pub(crate) omissions: Omissions,
}

impl<'a, S: Lane> Frame<'a, S> {
    /// Prepares a rendering of so many samples that tests some primitives, in ascending order.
    pub(crate) fn new(
        scene: &'a Compiled<S>,
        candidates: Vec<u32>,
        samples: usize,
        depth: u32,
        omissions: Omissions,
    ) -> Self {
        let occluders = Occluders::new(scene, &candidates).with_cones(&scene.lights, samples);
        let hidden = |light: &PointLight<S>| PointLight { hidden: true, ..*light };
        Self {
            scene,
            tiles: TileCuller::new(scene, candidates),
            occluders,
            hidden_lights: scene.lights.iter().map(hidden).collect(),
            depth,
            omissions,
        }
    }
}
