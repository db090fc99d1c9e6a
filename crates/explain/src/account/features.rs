//! What a scene has, and what of a ray tracer that needs.

use std::collections::BTreeMap;

use catoptric_core::Features;
use catoptric_scene::{Body, Compiled, Numerics, Power, Scene};
use serde::Serialize;

/// What the scene has.
#[derive(Debug, Serialize)]
pub(super) struct Has {
    pub(super) primitives: Primitives,
    /// Mirror factors, the largest first.
    pub(super) mirrors: Vec<Mirror>,
    pub(super) highlights: Highlights,
    pub(super) lamps: Lamps,
    /// Linear RGB.
    pub(super) background: [f64; 3],
    /// Linear RGB.
    pub(super) ambient: [f64; 3],
}

/// Primitives, by statement and by form.
#[derive(Debug, Serialize)]
pub(super) struct Primitives {
    /// Spheres as stated.
    pub(super) spheres: usize,
    /// Planes as stated.
    pub(super) planes: usize,
    /// Surfaces that an earlier one is already; never seen, and not compiled.
    pub(super) stated_twice: usize,
    /// Spheres computed from centre and radius.
    pub(super) balls: usize,
    /// Spheres so large against the scene that they are computed as heights, as planes are.
    pub(super) large_spheres: usize,
    /// Spheres around the eye; null with textbook numerics, which do not tell.
    pub(super) around: Option<usize>,
}

/// Primitives of one mirror factor.
#[derive(Debug, Serialize)]
pub(super) struct Mirror {
    pub(super) k: f64,
    pub(super) primitives: usize,
}

/// Primitives with a highlight, by what its exponent is computed with.
#[derive(Debug, Serialize)]
pub(super) struct Highlights {
    /// Whole exponents up to 1024: by squaring.
    pub(super) whole: usize,
    /// Other exponents: by exponential and logarithm.
    pub(super) fractional: usize,
}

/// Lights.
#[derive(Debug, Serialize)]
pub(super) struct Lamps {
    pub(super) stated: usize,
    /// Behind some primitive for all that can be seen: they light nothing.
    pub(super) hidden: usize,
    /// Lights of intensity 0.
    pub(super) off: usize,
    /// Lights whose channels differ.
    pub(super) coloured: usize,
}

/// What the scene needs of the engine.
#[derive(Debug, Serialize)]
pub(super) struct Needs {
    /// Some light can shine on something that shows it.
    pub(super) shadow_rays: bool,
    /// Some light can make a highlight.
    pub(super) highlights: bool,
    /// Some mirror can be followed.
    pub(super) reflection_rays: bool,
    /// Paths are cut by their weight.
    pub(super) weight_cut: bool,
}

impl Has {
    pub(super) fn new(scene: &Scene, compiled: &Compiled, used: &Features) -> Self {
        let stated = scene.spheres.len() + scene.planes.len();
        let robust = scene.render.numerics == Numerics::Robust;
        let powers = compiled.primitives.iter().filter_map(|primitive| {
            let material = &compiled.materials[primitive.material as usize];
            (material.specular > 0.0).then_some(material.power)
        });
        let whole = powers.clone().filter(|power| matches!(power, Power::Whole { .. })).count();
        Self {
            primitives: Primitives {
                spheres: scene.spheres.len(),
                planes: scene.planes.len(),
                stated_twice: stated - compiled.primitives.len(),
                balls: used.spheres,
                large_spheres: used.large_spheres,
                around: robust.then_some(used.around),
            },
            mirrors: mirrors(scene),
            highlights: Highlights { whole, fractional: powers.count() - whole },
            lamps: Lamps {
                stated: scene.lights.len(),
                hidden: compiled.lights.iter().filter(|light| light.hidden).count(),
                off: scene.lights.iter().filter(|l| l.intensity == [0.0; 3]).count(),
                coloured: scene.lights.iter().filter(|l| !is_grey(l.intensity)).count(),
            },
            background: scene.render.background,
            ambient: scene.render.ambient,
        }
    }
}

impl Needs {
    /// `depth`: reflections that can occur.
    pub(super) fn new(scene: &Scene, compiled: &Compiled, has: &Has, depth: u32) -> Self {
        let mut lamps = scene.lights.iter().zip(&compiled.lights);
        let lit = lamps.any(|(stated, lamp)| !lamp.hidden && stated.intensity != [0.0; 3]);
        let shows = |body: Body<'_>| {
            let material = &scene.materials[body.material()];
            material.specular > 0.0 || material.color.iter().any(|c| material.diffuse * c > 0.0)
        };
        Self {
            shadow_rays: lit && scene.bodies().any(shows),
            highlights: lit && has.highlights.whole + has.highlights.fractional > 0,
            reflection_rays: depth > 0,
            weight_cut: scene.render.min_weight > 0.0,
        }
    }
}

fn mirrors(scene: &Scene) -> Vec<Mirror> {
    let mirrors = scene.bodies().map(|body| scene.materials[body.material()].mirror());
    let mut counts = BTreeMap::new();
    for k in mirrors.filter(|k| *k > 0.0) {
        // Bits of positive numbers are in their order.
        *counts.entry(k.to_bits()).or_insert(0) += 1;
    }
    let mirror = |(bits, primitives)| Mirror { k: f64::from_bits(bits), primitives };
    counts.into_iter().rev().map(mirror).collect()
}

/// Whether a colour's channels are alike.
pub(super) fn is_grey([r, g, b]: [f64; 3]) -> bool {
    r == g && g == b
}
