//! The account of a scene in words, for a terminal of 80 columns.

use std::io::{self, Write};

use super::features::{Has, is_grey};
use super::{Account, FAR};
use crate::words;

/// Rows of a table at its beginning that are all shown.
const ALL: usize = 9;

/// Mirror factors that are shown.
const FACTORS: usize = 6;

impl Account {
    /// Writes it in words, for a terminal of 80 columns.
    ///
    /// # Errors
    /// What `to` fails with.
    pub fn write(&self, to: &mut dyn Write) -> io::Result<()> {
        write(self, to)
    }
}

fn write(account: &Account, to: &mut dyn Write) -> io::Result<()> {
    let Account { scene, width, height, transfer, numerics, max_depth, min_weight, .. } = account;
    writeln!(to, "{}", words::name(scene))?;
    writeln!(to, "{width}x{height} pixels, transfer {transfer}, numerics {numerics}")?;
    writeln!(to, "max_depth {max_depth}, min_weight {min_weight}")?;

    writeln!(to, "\nWhat the scene has")?;
    write_has(&account.has, to)?;

    writeln!(to, "\nWhat it needs")?;
    let needs = &account.needs;
    for (needed, what) in [
        (needs.shadow_rays, "shadow rays: a lamp can light something that shows it"),
        (needs.highlights, "highlights: a lamp can make one"),
        (needs.reflection_rays, "reflection rays: some mirror can be followed"),
        (needs.weight_cut, "weights: paths of less than min_weight are cut"),
    ] {
        writeln!(to, "  {} {what}", if needed { "yes" } else { "no " })?;
    }

    writeln!(to, "\nWhat the engine leaves out, why that is safe, and what it saves")?;
    write_plan(account, to)?;

    write_rays(account, to)?;
    write_caps(account, to)?;

    let enough = &account.enough;
    writeln!(to, "\nWhich max_depth is enough, found by rendering at this size")?;
    writeln!(to, "  {:<10} changes no bit of the picture", enough.same_bits)?;
    writeln!(to, "  {:<10} changes no 8-bit level by more than one", enough.within_a_level)
}

fn write_has(has: &Has, to: &mut dyn Write) -> io::Result<()> {
    let primitives = &has.primitives;
    let mut line = |name: &str, text: &str| writeln!(to, "  {name:<12}{text}");
    line("spheres", &primitives.spheres.to_string())?;
    line("", &format!("{} balls, computed from centre and radius", primitives.balls))?;
    let large = primitives.large_spheres;
    line("", &format!("{large} so large that they are computed as planes are"))?;
    match primitives.around {
        Some(around) => line("", &format!("{around} around the eye"))?,
        None => line("", "textbook numerics do not tell which are around the eye")?,
    }
    line("planes", &primitives.planes.to_string())?;
    if primitives.stated_twice > 0 {
        let twice = primitives.stated_twice;
        line("", &format!("{twice} surfaces stated twice, of which the first is seen"))?;
    }
    // Mirrors by factor, the strongest first, and only some of them.
    let mirrors: usize = has.mirrors.iter().map(|mirror| mirror.primitives).sum();
    line("mirrors", &mirrors.to_string())?;
    for mirror in has.mirrors.iter().take(FACTORS) {
        line("", &format!("{} of k = {}", mirror.primitives, mirror.k))?;
    }
    if let Some(more) = has.mirrors.len().checked_sub(FACTORS + 1) {
        line("", &format!("... and {} further factors, all in --json", more + 1))?;
    }
    // Highlights by the way in which they are computed.
    let highlights = &has.highlights;
    line("highlights", &(highlights.whole + highlights.fractional).to_string())?;
    if highlights.whole + highlights.fractional > 0 {
        let (whole, fractional) = (highlights.whole, highlights.fractional);
        line("", &format!("{whole} of whole shininess up to 1024, by squaring"))?;
        line("", &format!("{fractional} of another, by exponential and logarithm"))?;
    }
    // Lights, and those that light nothing.
    let lamps = &has.lamps;
    line("lamps", &format!("{}, {} of them coloured", lamps.stated, lamps.coloured))?;
    line("", &format!("{} hidden from all that can be seen", lamps.hidden))?;
    if lamps.off > 0 {
        line("", &format!("{} of intensity 0", lamps.off))?;
    }
    line("background", &colour(has.background))?;
    line("ambient", &colour(has.ambient))
}

fn write_plan(account: &Account, to: &mut dyn Write) -> io::Result<()> {
    let plan = &account.plan;
    // A depth that the scene sets by itself is worth telling.
    if plan.depth_set_by != "max_depth" {
        let depth = plan.depth;
        let why = match (plan.depth_set_by, depth) {
            ("min_weight", _) => "a weight of more mirrors is below min_weight",
            (_, 0) => "there is no mirror",
            _ => "there is one mirror, which cannot show itself",
        };
        writeln!(to, "  depth       no ray can have more than {depth} reflections")?;
        writeln!(to, "              {why}")?;
    }
    // What is left out, with its reason and what that saves or costs.
    for omitted in &plan.omitted {
        writeln!(to, "  {:<12}{}", omitted.name, omitted.what)?;
        writeln!(to, "              {}", omitted.why)?;
        let percent = omitted.saves * 100.0;
        if percent < 0.0 {
            writeln!(
                to,
                "              costs {:.0} % of the time of tracing, measured now",
                -percent
            )?;
        } else {
            writeln!(
                to,
                "              saves {percent:.0} % of the time of tracing, measured now"
            )?;
        }
    }
    if plan.omitted.is_empty() {
        writeln!(to, "  nothing of this scene's own")?;
    }
    // What is culled before a ray is traced.
    let (tiles, empty, tried) = (plan.tiles, plan.empty_tiles, plan.tried_a_tile);
    let primitives = account.has.primitives.spheres + account.has.primitives.planes;
    writeln!(to, "  of {primitives} primitives a tile's eye rays try {tried:.2} in the mean;")?;
    writeln!(to, "  {empty} of {tiles} tiles can show nothing but the background")?;
    if let Some(occluders) = plan.occluders {
        writeln!(to, "  between a lamp and a primitive {occluders:.2} can stand in the mean")?;
    }
    writeln!(to, "  and of every scene:")?;
    plan.always.iter().try_for_each(|always| writeln!(to, "  - {always}"))
}

fn write_rays(account: &Account, to: &mut dyn Write) -> io::Result<()> {
    let rays = &account.rays;
    writeln!(to, "\nWhere rays end")?;
    writeln!(to, "  the deepest has {} reflections behind it", rays.deepest)?;
    match rays.end {
        Some(end) if end == rays.deepest && account.needs.weight_cut => {
            writeln!(to, "  there they end, by themselves or cut by min_weight")?
        }
        Some(end) if end == rays.deepest => writeln!(to, "  there they end by themselves")?,
        Some(end) => {
            writeln!(to, "  with a larger max_depth they would end by themselves at {end}")?
        }
        None => writeln!(to, "  followed to {}, some still go on", FAR.max(rays.deepest))?,
    }
    let (primary, reflection, shadow) = (rays.primary, rays.reflection, rays.shadow);
    writeln!(to, "  {primary} eye rays, {reflection} reflected, {shadow} shadow rays\n")?;
    writeln!(to, "  {:>10} {:>14} {:>14} {:>14}", "depth", "rays", "hits", "shadow rays")?;
    let shown = |i: usize| i < ALL || i.is_power_of_two() || i + 1 == rays.depths.len();
    for depth in rays.depths.iter().filter(|depth| shown(depth.depth)) {
        let (at, rays, hits, shadow) = (depth.depth, depth.rays, depth.hits, depth.shadow);
        writeln!(to, "  {at:>10} {rays:>14} {hits:>14} {shadow:>14}")?;
    }
    let hidden = (0..rays.depths.len()).filter(|i| !shown(*i)).count();
    if hidden > 0 {
        writeln!(to, "  ... {hidden} depths between these are not shown; all are in --json")?;
    }
    Ok(())
}

fn write_caps(account: &Account, to: &mut dyn Write) -> io::Result<()> {
    writeln!(to, "\nWhat ending all rays at a lower max_depth can change at most")?;
    writeln!(to, "  a channel, linear, 1 being white; known without rendering, of exact")?;
    writeln!(to, "  arithmetic; the picture may change far less")?;
    let own = format!("against {}", account.max_depth);
    writeln!(to, "  {:>10} {own:>20} {:>20}", "max_depth", "against any depth")?;
    for cap in &account.caps {
        let (depth, own, any) = (cap.max_depth, bound(cap.bound), bound(cap.bound_endless));
        writeln!(to, "  {depth:>10} {own:>20} {any:>20}")?;
    }
    if account.needs.weight_cut {
        let bound = bound(account.weight_cut_bound);
        writeln!(to, "  min_weight {} against none: {bound}", account.min_weight)?;
    }
    Ok(())
}

/// Three digits.
fn bound(bound: Option<f64>) -> String {
    match bound {
        None => "no bound".to_owned(),
        Some(0.0) => "0".to_owned(),
        Some(x @ 0.001..1000.0) => format!("{x:.3}"),
        Some(x) => format!("{x:.2e}"),
    }
}

fn colour(colour: [f64; 3]) -> String {
    match colour {
        [0.0, 0.0, 0.0] => "black".to_owned(),
        [r, _, _] if is_grey(colour) => format!("grey {r}"),
        [r, g, b] => format!("{r} {g} {b}"),
    }
}
