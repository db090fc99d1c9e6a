//! The plan: what a scene needs, and what is left out because it changes no bit.
//!
//! An omission is one row of [`Omission::ALL`]; its condition and its proof stand with its
//! variant. `benches/README.md` says what each saves, and what was tried and not kept.

use catoptric_scene::{Compiled, Grid, Numerics, Phong, Power, Scalar, Shape};
use glam::DVec3;

use crate::PacketScalar;
use crate::cut::reflections_above;
use crate::lanes::Lane;
use crate::nested;
use crate::occluders::Occluders;
use crate::sight::{Sights, in_f64};
use crate::tile;

/// Work that need not be done. None of it changes a bit of the picture or a ray count.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Omission {
    /// Balls wholly inside another one are not tried, by any ray.
    ///
    /// Robust numerics, no plane, and the eye outside the outer ball. A ray would meet that one
    /// first: `nested` asks for a gap between them that is above all rounding.
    Nested,
    /// Primitives that no eye ray of a tile can meet are not tried there, and a tile without
    /// any is filled with the background.
    ///
    /// Robust numerics. The rays would miss them: `sight` bounds their directions by cones, with
    /// margins above all rounding.
    Tiles,
    /// Primitives that cannot stand between a lamp and any of a tile's points on one primitive
    /// are not tried on the way to the lamp.
    ///
    /// Robust numerics. The shadow test would be false: `occluders` bounds those ways by a
    /// capsule, and from each packet of points by a cone, with margins above all rounding.
    Occluders,
    /// Without a highlight and without a mirror to follow, no mirrored direction is formed, and
    /// without a highlight no power.
    ///
    /// The recursion adds 0 · power, which is 0, and no light is -0.
    Directions,
    /// On a primitive that no lamp's light comes back from, kd·colour and ks being 0, shadow rays
    /// are counted and not traced.
    ///
    /// The recursion adds I · (0 · n·l + 0 · power), which is 0: n·l, power and I are finite.
    Shadows,
}

impl Omission {
    /// Every one.
    pub const ALL: [Self; 5] =
        [Self::Nested, Self::Tiles, Self::Occluders, Self::Directions, Self::Shadows];

    /// A word for tables.
    #[must_use]
    pub fn name(self) -> &'static str {
        match self {
            Self::Nested => "nested",
            Self::Tiles => "tiles",
            Self::Occluders => "occluders",
            Self::Directions => "directions",
            Self::Shadows => "shadows",
        }
    }

    /// What is not done, in a sentence.
    #[must_use]
    pub fn what(self) -> &'static str {
        match self {
            Self::Nested => "no ray tries a sphere wholly inside another one",
            Self::Tiles => "eye rays do not try what their tile of pixels cannot show",
            Self::Occluders => "shadow rays do not try what cannot stand in their way",
            Self::Directions => {
                "no mirrored direction where neither highlight nor mirror needs one"
            }
            Self::Shadows => "no shadow ray where a surface sends back no lamp's light",
        }
    }

    /// Why no bit of the picture depends on it.
    #[must_use]
    pub fn why(self) -> &'static str {
        match self {
            Self::Nested => "whatever comes near it meets the outer one first",
            Self::Tiles => "cones around them miss it, with room for all rounding",
            Self::Occluders => "bounds around the way miss it, with room for all rounding",
            Self::Directions | Self::Shadows => "what would be added is 0, and no light is -0",
        }
    }
}

/// What a scene and a request use.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Features {
    /// Spheres computed from centre and radius.
    pub balls: usize,
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
    /// Lamps that some primitive does not hide from all that can be seen.
    pub lamps: usize,
    /// Lamps that one does hide. They light nothing.
    pub hidden_lamps: usize,
    /// Some lamp's channels differ.
    pub coloured_lamps: bool,
    /// Some material has a highlight.
    pub highlight: bool,
    /// Some highlight's exponent is not a whole number up to 1024.
    pub fractional_shininess: bool,
    /// Paths are cut by weight.
    pub cut: bool,
    /// Samples a side.
    pub samples: u32,
}

/// What a rendering does, decided once.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Plan {
    /// What the scene and the request use.
    pub features: Features,
    /// Reflections that can occur, at most the scene's max_depth: none without a mirror, 1 with
    /// a single one that is not around the eye, since no ray meets again what it just left, and
    /// no more than the weights of the strongest mirror stay above the cut (`cut`).
    pub depth: u32,
    /// What is left out.
    pub omitted: Vec<Omission>,
    /// Indices of the spheres that are inside others: found once.
    nested: Vec<u32>,
}

impl Plan {
    /// The plan for a view of a scene.
    #[must_use]
    pub fn new<S: Scalar>(scene: &Compiled<S>, grid: &Grid<S>) -> Self {
        let nested = nested::nested(scene);
        let features = Features::of(scene, grid, &nested);
        let robust = scene.numerics == Numerics::Robust;
        let applies = |omission: &Omission| match omission {
            Omission::Nested => features.nested > 0,
            Omission::Tiles => robust,
            Omission::Occluders => robust && features.lamps > 0,
            Omission::Directions => scene.materials.iter().any(|m| m.specular <= S::ZERO),
            Omission::Shadows => features.lamps > 0 && scene.materials.iter().any(is_unlit),
        };
        let omitted = Omission::ALL.into_iter().filter(applies).collect();
        Self { features, depth: depth(scene), omitted, nested }
    }

    /// A plan that leaves nothing out.
    #[must_use]
    pub fn everything<S: Scalar>(scene: &Compiled<S>, grid: &Grid<S>) -> Self {
        let nested = nested::nested(scene);
        let features = Features::of(scene, grid, &nested);
        Self { features, depth: scene.max_depth, omitted: Vec::new(), nested }
    }

    /// This plan, with that omission not made.
    #[must_use]
    pub fn without(mut self, omission: Omission) -> Self {
        self.omitted.retain(|&other| other != omission);
        self
    }

    /// Whether it is left out.
    #[must_use]
    pub fn omits(&self, omission: Omission) -> bool {
        self.omitted.contains(&omission)
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
            match &primitive.shape {
                Shape::Ball(ball) => {
                    these.balls += 1;
                    these.around += usize::from(ball.is_around());
                }
                Shape::Flat(flat) if flat.curvature == S::ZERO => these.planes += 1,
                Shape::Flat(flat) => {
                    these.large_spheres += 1;
                    these.around += usize::from(flat.is_around());
                }
                Shape::TextbookSphere(_) => these.balls += 1,
                Shape::TextbookPlane(_) => these.planes += 1,
            }
            let material = &scene.materials[primitive.material as usize];
            these.mirrors += usize::from(material.mirror > S::ZERO);
        }
        for lamp in &scene.lights {
            these.lamps += usize::from(!lamp.hidden);
            these.hidden_lamps += usize::from(lamp.hidden);
            let [r, g, b] = lamp.intensity.into();
            these.coloured_lamps |= r != g || g != b;
        }
        for material in &scene.materials {
            these.highlight |= material.specular > S::ZERO;
            these.fractional_shininess |=
                material.specular > S::ZERO && matches!(material.power, Power::Real { .. });
        }
        these
    }
}

/// The primitives that rays try, by index in ascending order.
pub(crate) fn tried<S: Scalar>(scene: &Compiled<S>, plan: &Plan) -> Vec<u32> {
    let nested: &[u32] = if plan.omits(Omission::Nested) { &plan.nested } else { &[] };
    nested::others(scene, nested)
}

/// Whether no lamp's light comes back from a material.
#[inline(always)]
pub(crate) fn is_unlit<S: Scalar>(material: &Phong<S>) -> bool {
    let [r, g, b] = material.diffuse.into();
    material.specular == S::ZERO && r == S::ZERO && g == S::ZERO && b == S::ZERO
}

/// Reflections that can occur, at most.
fn depth<S: Scalar>(scene: &Compiled<S>) -> u32 {
    let mirror = |material: u32| scene.materials[material as usize].mirror;
    let mut mirrors = scene.primitives.iter().filter(|p| mirror(p.material) > S::ZERO);
    let most = match (mirrors.next(), mirrors.next()) {
        (None, _) => 0,
        (Some(only), None) => match &only.shape {
            Shape::Ball(ball) if !ball.is_around() => 1,
            Shape::Flat(flat) if !flat.is_around() => 1,
            _ => u32::MAX,
        },
        _ => u32::MAX,
    };
    let most = if most < scene.max_depth { most } else { scene.max_depth };
    let larger = |a, b| if a > b { a } else { b };
    let strongest = scene.primitives.iter().map(|p| mirror(p.material)).fold(S::ZERO, larger);
    reflections_above(scene.min_weight, strongest, most)
}

/// How many of a view's tiles can show how many primitives.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct TileCandidates {
    /// Tiles of the picture.
    pub tiles: usize,
    /// Tiles that can show nothing but the background.
    pub empty: usize,
    /// Primitives tried, summed over all tiles.
    pub tried: usize,
}

/// What the eye rays of a view's tiles have to try.
#[must_use]
pub fn tile_candidates<S: Scalar>(scene: &Compiled<S>, grid: &Grid<S>) -> TileCandidates {
    let sights = Sights::new(scene, nested::others(scene, &nested::nested(scene)));
    let (mut sum, mut list) = (TileCandidates::default(), Vec::new());
    let samples = grid.samples as usize;
    for rows in grid.rows.chunks(tile::HEIGHT * samples) {
        for columns in grid.columns.chunks(tile::WIDTH * samples) {
            sights.candidates(&scene.eye, columns, rows, &mut list);
            sum.tiles += 1;
            sum.empty += usize::from(list.is_empty());
            sum.tried += list.len();
        }
    }
    sum
}

/// The primitives that can stand between a lamp and any point of a receiver, by index.
///
/// Conservative: one that is not here never does; one that is here may not either. Of a hidden
/// lamp, none.
///
/// # Panics
/// If there is no such lamp or receiver.
#[must_use]
pub fn occluders<S: PacketScalar>(scene: &Compiled<S>, lamp: usize, receiver: usize) -> Vec<u32> {
    S::occluders(scene, lamp, receiver)
}

/// [`occluders`] of one scalar.
pub(crate) fn occluders_of<S: Lane>(scene: &Compiled<S>, lamp: usize, receiver: usize) -> Vec<u32> {
    let lamp = &scene.lights[lamp];
    if lamp.hidden {
        return Vec::new();
    }
    let (center, radius) = match &scene.primitives[receiver].shape {
        // Its points are within rounding of it, a few u of |c| + r, u = 6e-8 at most.
        Shape::Ball(ball) => {
            let (center, radius) = (in_f64::<S>(ball.center), ball.radius.to_f64());
            (center, radius + 1e-6 * (center.length() + radius))
        }
        _ => (DVec3::ZERO, f64::INFINITY),
    };
    // Balls inside others too: to find them takes longer than what is asked for here.
    let occluders = Occluders::new(scene, &nested::all(scene));
    let mut list = vec![0; occluders.len() + 1];
    let left = u32::try_from(receiver).expect("fewer than 2^32 primitives");
    let position = in_f64::<S>(lamp.position);
    let len = occluders.find::<S::Portable>(position, center, radius, left, &mut list);
    let mut indices: Vec<_> = list[..len].iter().map(|&number| occluders.index(number)).collect();
    indices.sort_unstable();
    indices
}
