//! The plan: what a scene needs, and what is left out because it changes no bit.
//!
//! An omission is one row of [`Omission::ALL`]; its condition and its proof stand with its
//! variant. `benches/README.md` says what each saves, and what was tried and not kept.

mod holders;
pub(crate) mod nested;
mod reflections;

use catoptric_scene::{Compiled, Grid, Numerics, Phong, Power, Scalar};

use self::reflections::reflections_above;
use crate::omission::{Omission, Omissions};
use crate::shape::{Kind, facts};

/// What a scene and a request use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Features {
    /// Spheres computed from centre and radius.
    pub spheres: usize,
    /// Large spheres, computed from their height.
    pub large_spheres: usize,
    /// Planes.
    pub planes: usize,
    /// Spheres around the eye.
    pub around: usize,
    /// Spheres wholly inside another one, which nothing shows.
    pub nested: usize,
    /// Primitives whose mirror factor is above 0.
    pub mirrors: usize,
    /// Lights that some primitive does not hide from all that can be seen.
    pub lights: usize,
    /// Lights that one does hide. They light nothing.
    pub hidden_lights: usize,
    /// Some light's channels differ.
    pub coloured_lights: bool,
    /// Some material has a highlight.
    pub highlight: bool,
    /// Some highlight's exponent is not a whole number up to 1024.
    pub fractional_shininess: bool,
    /// Paths are cut by weight.
    pub cut: bool,
    /// Samples a side.
    pub samples: u32,
}

/// What a rendering of a view of a scene does, decided once. It cannot be made wrong: work can be
/// added to it, and none left out that a bit depends on.
#[derive(Clone, Debug)]
pub struct Plan<'a, S: Scalar = f32> {
    scene: &'a Compiled<S>,
    grid: &'a Grid<S>,
    features: Features,
    depth: u32,
    omissions: Omissions,
    /// Indices of the spheres that are inside others.
    nested: Vec<u32>,
}

impl<'a, S: Scalar> Plan<'a, S> {
    /// Plans a view of a scene.
    #[must_use]
    pub fn new(scene: &'a Compiled<S>, grid: &'a Grid<S>) -> Self {
        let nested = nested::nested(scene);
        let features = Features::of(scene, grid, &nested);
        let robust = scene.numerics == Numerics::Robust;
        let applies = |omission: &Omission| match omission {
            Omission::Nested => features.nested > 0,
            Omission::Tiles => robust,
            Omission::Occluders => robust && features.lights > 0,
            Omission::Directions => scene.materials.iter().any(|m| m.specular <= S::ZERO),
            Omission::Shadows => features.lights > 0 && scene.materials.iter().any(Phong::is_unlit),
        };
        let omissions = Omission::ALL.into_iter().filter(applies).collect();
        Self { scene, grid, features, depth: depth(scene), omissions, nested }
    }

    /// This plan with nothing left out.
    #[must_use]
    pub fn everything(self) -> Self {
        Self { depth: self.scene.max_depth, omissions: Omissions::NONE, ..self }
    }

    /// This plan with that omission not made.
    #[must_use]
    pub fn without(self, omission: Omission) -> Self {
        Self { omissions: self.omissions.without(omission), ..self }
    }

    /// This plan with no other omissions than those.
    #[must_use]
    pub fn only(self, omissions: &[Omission]) -> Self {
        let kept = self.omissions.iter().filter(|omission| omissions.contains(omission));
        Self { omissions: kept.collect(), ..self }
    }

    /// What the scene and the request use.
    #[must_use]
    pub fn features(&self) -> &Features {
        &self.features
    }

    /// Reflections that can occur, at most the scene's max_depth: none without a mirror, 1 with
    /// a single one that is not around the eye, since no ray meets again what it just left, and
    /// no more than the weights of the strongest mirror stay above the cut.
    #[must_use]
    pub fn depth(&self) -> u32 {
        self.depth
    }

    /// What is left out.
    #[must_use]
    pub fn omissions(&self) -> Omissions {
        self.omissions
    }

    /// Whether an omission is made.
    #[must_use]
    pub fn omits(&self, omission: Omission) -> bool {
        self.omissions.contains(omission)
    }

    pub(crate) fn scene(&self) -> &'a Compiled<S> {
        self.scene
    }

    pub(crate) fn grid(&self) -> &'a Grid<S> {
        self.grid
    }

    /// The primitives that rays are tested against, by index in ascending order.
    pub(crate) fn candidates(&self) -> Vec<u32> {
        let nested: &[u32] = if self.omits(Omission::Nested) { &self.nested } else { &[] };
        nested::others(self.scene, nested)
    }
}

impl Features {
    fn of<S: Scalar>(scene: &Compiled<S>, grid: &Grid<S>, nested: &[u32]) -> Self {
        let mut these = Self {
            nested: nested.len(),
            cut: scene.min_weight > S::ZERO,
            samples: grid.samples,
            ..Self::default()
        };
        for primitive in &scene.primitives {
            let shape = facts(&primitive.shape);
            match shape.kind() {
                Kind::Sphere => these.spheres += 1,
                Kind::LargeSphere => these.large_spheres += 1,
                Kind::Plane => these.planes += 1,
            }
            these.around += usize::from(shape.encloses_eye());
            let material = &scene.materials[primitive.material as usize];
            these.mirrors += usize::from(material.mirror > S::ZERO);
        }
        for light in &scene.lights {
            these.lights += usize::from(!light.hidden);
            these.hidden_lights += usize::from(light.hidden);
            let [r, g, b] = light.intensity.into();
            these.coloured_lights |= r != g || g != b;
        }
        for material in &scene.materials {
            these.highlight |= material.specular > S::ZERO;
            these.fractional_shininess |=
                material.specular > S::ZERO && matches!(material.power, Power::Real { .. });
        }
        these
    }
}

/// Reflections that can occur, at most.
fn depth<S: Scalar>(scene: &Compiled<S>) -> u32 {
    let mirror = |material: u32| scene.materials[material as usize].mirror;
    let robust = scene.numerics == Numerics::Robust;
    let mut mirrors = scene.primitives.iter().filter(|p| mirror(p.material) > S::ZERO);
    let most = match (mirrors.next(), mirrors.next()) {
        (None, _) => 0,
        (Some(only), None) if robust && !facts(&only.shape).encloses_eye() => 1,
        _ => u32::MAX,
    };
    let most = if most < scene.max_depth { most } else { scene.max_depth };
    let larger = |a, b| if a > b { a } else { b };
    let strongest = scene.primitives.iter().map(|p| mirror(p.material)).fold(S::ZERO, larger);
    reflections_above(scene.min_weight, strongest, most)
}
