//! The account of a scene: one structure, as words and as JSON.

mod features;
mod plan;
mod text;

use catoptric_core::{Isa, Plan};
use catoptric_scene::{Compiled, Film, Grid, Scene, Transfer, View};
use catoptric_study::error::{Enough, enough};
use catoptric_study::light::LightBounds;
use catoptric_study::subject::Subject;
use catoptric_study::tracer::{TooDeep, Tracer};
use serde::Serialize;

use crate::error::ExplainError;
use crate::words::numerics;
use features::{Has, Needs};

/// What is said of a scene. Serialised, every key is always there.
#[derive(Debug, Serialize)]
pub struct Account {
    /// `catoptric-explain`.
    schema: &'static str,
    /// Grows when a key changes its meaning or goes.
    version: u32,
    /// The scene as the command line named it; `-` for stdin.
    scene: String,
    width: u32,
    height: u32,
    /// `linear` or `srgb`.
    transfer: &'static str,
    /// `robust` or `textbook`.
    numerics: &'static str,
    max_depth: u32,
    min_weight: f64,
    has: Has,
    needs: Needs,
    /// What the engine leaves out, and why that is safe.
    plan: plan::Told,
    rays: Rays,
    /// Ever larger caps, up to the deepest ray.
    caps: Vec<Cap>,
    /// What cutting paths at min_weight can change at most, of a channel, linear, in exact
    /// arithmetic, against cutting none. Null without a cut, and where there is no bound.
    weight_cut_bound: Option<f64>,
    enough: Depths,
}

/// The rays of the scene's own picture, one sample a pixel. Logical: what the picture needs,
/// whether or not the engine has to trace it.
#[derive(Debug, Serialize)]
struct Rays {
    primary: u64,
    reflection: u64,
    shadow: u64,
    /// The most reflections that one has behind it.
    deepest: u32,
    /// The most reflections behind a ray with max_depth raised to 256, if it is below; null if rays
    end: Option<u32>,
    /// Counts by depth, 0 first.
    depths: Vec<Depth>,
}

/// What happens after that many reflections.
#[derive(Debug, Serialize)]
struct Depth {
    depth: usize,
    rays: u64,
    hits: u64,
    shadow: u64,
}

/// What ending all paths early can change at most.
#[derive(Debug, Serialize)]
struct Cap {
    max_depth: u32,
    /// Bound for a channel, linear, in exact arithmetic, against the scene's own max_depth; known
    /// before anything is rendered. Null: no bound.
    bound: Option<f64>,
    /// Bound against a max_depth without end, else as `bound`.
    bound_endless: Option<f64>,
}

/// The smallest max_depth for which the scene's picture is as good as at its own, found by
/// rendering.
#[derive(Debug, Serialize)]
struct Depths {
    /// No bit is another one.
    same_bits: u32,
    /// No 8-bit level is off by more than one.
    within_a_level: u32,
}

/// How far rays are followed to see where they end by themselves.
const FAR: u32 = 256;

impl Account {
    /// Renders the picture about 2 log2 of its deepest ray times, and as often as it takes to
    /// see what omissions save, on rayon's current threads.
    ///
    /// `name` is the scene's, as it is to be told. See [`Account::memory`] for what this takes.
    ///
    /// # Errors
    /// [`ExplainError::PictureTooDeep`].
    pub fn new(name: &str, scene: &Scene, isa: Isa) -> Result<Self, ExplainError> {
        let (width, height) = (scene.image.width, scene.image.height);
        let failed = |deep: TooDeep| {
            let (max_depth, min_weight) = (scene.render.max_depth, scene.render.min_weight);
            ExplainError::PictureTooDeep { deep, max_depth, min_weight }
        };
        // Render, to learn which depth is enough and how deep rays go.
        let found = enough(scene, isa).map_err(failed)?;
        let Enough { same_bits, within_a_level, deepest_ray, counts } = found;
        let end = end(scene, isa, deepest_ray).map_err(failed)?;
        // Plan as the engine would, and tell what the scene has and needs.
        let compiled = Compiled::new(scene);
        let grid = Grid::new(&View::whole(scene));
        let planned = Plan::new(&compiled, &grid);
        let plan = plan::Told::new(&compiled, &grid, &planned, isa).map_err(failed)?;
        let has = Has::new(scene, &compiled, planned.features());
        let needs = Needs::new(scene, &compiled, &has, plan.depth);
        // Bound what paths that end early can change, also for a scene without max_depth.
        let light = LightBounds::new(scene);
        let without_end = Compiled { max_depth: u32::MAX, ..compiled };
        let plan_depth = plan.depth;
        let endless = Plan::new(&without_end, &grid).depth();
        let entry = |(depth, count): (usize, &catoptric_scene::DepthCount)| Depth {
            depth,
            rays: count.rays,
            hits: count.hits,
            shadow: count.shadow,
        };
        // Put it all together.
        Ok(Self {
            schema: "catoptric-explain",
            version: 1,
            scene: name.to_owned(),
            width,
            height,
            transfer: match scene.image.transfer {
                Transfer::Linear => "linear",
                Transfer::Srgb => "srgb",
            },
            numerics: numerics(scene),
            max_depth: scene.render.max_depth,
            min_weight: scene.render.min_weight,
            has,
            needs,
            plan,
            rays: Rays {
                primary: counts.primary(),
                reflection: counts.reflection(),
                shadow: counts.shadow(),
                deepest: deepest_ray,
                end,
                depths: counts.depths.iter().enumerate().map(entry).collect(),
            },
            caps: caps(&light, deepest_ray, plan_depth, endless),
            weight_cut_bound: weight_cut_bound(scene, &light),
            enough: Depths { same_bits, within_a_level },
        })
    }

    /// Bytes that two films of the scene take, which are compared with each other.
    #[must_use]
    pub fn memory(scene: &Scene) -> u64 {
        u64::from(scene.image.width) * u64::from(scene.image.height) * 24
    }
}

/// The depth at which rays end by themselves, if they do before [`FAR`].
fn end(scene: &Scene, isa: Isa, deepest: u32) -> Result<Option<u32>, TooDeep> {
    if deepest < scene.render.max_depth {
        return Ok(Some(deepest));
    }
    let far = Subject { name: String::new(), scene: scene.clone() }.to_depth(FAR.max(deepest));
    let grid = Grid::new(&View::whole(&far));
    let mut film = Film::new(grid.width, grid.height);
    let counts = Tracer::Packet(isa).render(&Compiled::new(&far), &grid, &mut film)?;
    let deepest = u32::try_from(counts.depths.len().saturating_sub(1)).unwrap_or(u32::MAX);
    Ok(Some(deepest).filter(|deepest| *deepest < far.render.max_depth))
}

/// A few caps: 0 to 5, then powers of two, and the deepest ray. `full`: the reflections that can
/// occur; `endless`: the same if max_depth were without end.
fn caps(light: &LightBounds, deepest: u32, full: u32, endless: u32) -> Vec<Cap> {
    let bound = |cap, full| Some(light.left_out_by_cap(cap, full)).filter(|b| b.is_finite());
    let cap = |max_depth| Cap {
        max_depth,
        bound: bound(max_depth, full),
        bound_endless: bound(max_depth, endless),
    };
    let powers = (3..32).map(|i| 1 << i);
    let few = (0..=5).chain(powers).take_while(|depth| *depth < deepest);
    few.chain([deepest]).map(cap).collect()
}

fn weight_cut_bound(scene: &Scene, light: &LightBounds) -> Option<f64> {
    let render = scene.render;
    let bound = light.left_out_by_weight(render.min_weight, render.max_depth);
    (render.min_weight > 0.0 && bound.is_finite()).then_some(bound)
}
