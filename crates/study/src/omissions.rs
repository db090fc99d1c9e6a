//! What each omission of a plan saves on one picture.

use std::time::Instant;

use catoptric_core::{Engine, Isa, Omission, Plan, Settings};
use catoptric_scene::{Compiled, Film, Grid};

use crate::Unwatched;
use crate::timing::{Repeat, in_turn};
use crate::tracer::{STACK_LIMIT, TooDeep};

/// What one omission saves.
#[derive(Clone, Copy, Debug)]
pub struct Saving {
    /// The omission.
    pub omission: Omission,
    /// 1 - t/t', by least times of tracing: t by the plan, t' by the plan without the omission.
    /// Below 0 where finding out what may be left out costs more.
    pub share: f64,
}

/// About this long, in seconds, is spent on finding it out, where a picture is quick.
const LONG: f64 = 0.5;

/// Renders the picture by its plan and without each omission, in turn on rayon's current
/// threads, 3 to 20 times each.
///
/// # Errors
/// A path too deep for the engine's stack.
pub fn savings(scene: &Compiled, grid: &Grid, isa: Isa) -> Result<Vec<Saving>, TooDeep> {
    let plan = Plan::new(scene, grid);
    let without = plan.omissions().iter().map(|omission| plan.clone().without(omission));
    let plans: Vec<Plan> = std::iter::once(plan.clone()).chain(without).collect();
    let mut film = Film::new(grid.width, grid.height);
    let engine = Engine::new(scene).with(Settings { isa, stack_limit: STACK_LIMIT });
    let mut trace = |plan: &Plan| {
        let start = Instant::now();
        let rendered = engine.render_planned(plan, &mut film);
        rendered.ok().map(|_| start.elapsed())
    };
    // The first picture pays for its film's pages.
    let first = trace(&plan).ok_or(TooDeep)?;
    let rounds = LONG / (first.as_secs_f64() * plans.len() as f64);
    let rounds = if rounds < 3.0 {
        3
    } else if rounds < 20.0 {
        rounds as u32
    } else {
        20
    };
    let times = in_turn(plans.len(), Repeat::Times(rounds), &Unwatched, |i| trace(&plans[i]));
    let least: Option<Vec<f64>> = times.iter().map(|times| times.min_ms()).collect();
    let least = least.ok_or(TooDeep)?;
    let share = |(omission, &other): (Omission, &f64)| {
        // A picture of next to nothing may take no time that the clock tells.
        let share = if other > 0.0 { 1.0 - least[0] / other } else { 0.0 };
        Saving { omission, share }
    };
    Ok(plan.omissions().iter().zip(&least[1..]).map(share).collect())
}
