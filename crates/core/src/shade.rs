//! Local light, and the mirrored rays that go on, for all rays of a level that met one primitive.

use catoptric_scene::{DepthCount, Numerics, Phong, PointLight, Scalar, Shape};
use glam::DVec3;

use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::nearest::{Form, Found, Nearest};
use crate::occluders::Occluder;
use crate::packet::{NONE, Rays, World};
use crate::plan::is_unlit;
use crate::power::power;
use crate::sight::in_f64;
use crate::stack::{Owed, Stack};
use crate::surfaces::{Met, Surfaces};
use crate::vec3::Vec3;
use crate::wave::{Mirrored, Wave};
use crate::{ball, flat, textbook};

/// So many shadow tests are fewer than finding out which of them can be left out costs.
const WORTH_BOUNDS: usize = 8;

/// The level in flight, and the next.
pub(crate) struct Level<'a, 'b, S: Lane> {
    pub(crate) wave: &'a Wave<S>,
    pub(crate) nearest: &'a Nearest<S>,
    pub(crate) stack: &'a mut Stack<'b, S>,
    pub(crate) next: &'a mut Wave<S>,
    /// Whether mirrored rays are traced.
    pub(crate) followed: bool,
    /// Whether there is a cut by weight.
    pub(crate) cut: bool,
    pub(crate) count: DepthCount,
}

/// Room for what shading finds out about one primitive.
pub(crate) struct Shading<S> {
    surfaces: Surfaces<S>,
    /// Of all lamps, one after another, and where each lamp's end.
    occluders: Vec<u32>,
    ends: Vec<usize>,
}

/// The lamps, and for each what can stand before it: a part of the list, up to its end.
#[derive(Clone, Copy)]
struct Lamps<'a, S: Scalar> {
    lights: &'a [PointLight<S>],
    occluders: &'a [u32],
    ends: &'a [usize],
    /// Whether highlights are formed.
    highlight: bool,
}

/// What eight rays owe on the return.
struct Owes<'a, L: Lanes> {
    local: Vec3<L>,
    rays: &'a [Owed; LANES],
    material: u32,
    k: L::Scalar,
}

/// Where eight rays met a primitive.
struct Place<L> {
    point: Vec3<L>,
    normal: Vec3<L>,
    /// Where shadow and mirrored rays start.
    start: Vec3<L>,
    mirrored: Vec3<L>,
}

impl<S: Lane> Shading<S> {
    pub(crate) fn new(occluders: usize, lamps: usize) -> Self {
        // One more: a place is written before it is known whether it counts.
        let occluders = vec![0; (occluders + 1) * lamps];
        Self { surfaces: Surfaces::new(), occluders, ends: vec![0; lamps] }
    }
}

/// Shades the rays of a level that met one primitive, and counts them and their shadow rays.
#[inline(always)]
pub(crate) fn shade<L: Lanes>(
    world: World<L::Scalar>,
    found: Found,
    level: &mut Level<L::Scalar>,
    shading: &mut Shading<L::Scalar>,
) {
    match &world.scene.primitives[found.index as usize].shape {
        Shape::Ball(ball) => shade_form::<L, _>(*ball, world, found, level, shading),
        Shape::Flat(flat) => shade_form::<L, _>(*flat, world, found, level, shading),
        Shape::TextbookSphere(sphere) => shade_form::<L, _>(*sphere, world, found, level, shading),
        Shape::TextbookPlane(plane) => shade_form::<L, _>(*plane, world, found, level, shading),
    }
}

/// [`shade`] for a primitive of one form.
#[inline(always)]
fn shade_form<L: Lanes, F: Form<L::Scalar>>(
    form: F,
    world: World<L::Scalar>,
    found: Found,
    level: &mut Level<L::Scalar>,
    shading: &mut Shading<L::Scalar>,
) {
    let (scene, index) = (world.scene, found.index);
    let primitive = &scene.primitives[index as usize];
    let material = &scene.materials[primitive.material as usize];
    let followed = level.followed && material.mirror > L::Scalar::ZERO;
    let highlight = material.specular > L::Scalar::ZERO || !world.omit.directions;
    let Shading { surfaces, occluders, ends } = shading;
    let met = Met { wave: level.wave, nearest: level.nearest, found };
    let hits = surfaces.collect::<L, _>(form, met);
    if hits == 0 {
        return;
    }
    level.count.hits += hits;

    let few = world.occluders.len() * surfaces.all().len() < WORTH_BOUNDS;
    let (center, radius) =
        if few || !world.omit.occluders { (DVec3::ZERO, f64::INFINITY) } else { surfaces.bounds() };
    let mut end = 0;
    let unlit = world.omit.shadows && is_unlit(material);
    let lights = if unlit { world.hidden } else { &scene.lights };
    for (lamp, lamp_end) in lights.iter().zip(&mut *ends) {
        if !lamp.hidden {
            let lamp = in_f64::<L::Scalar>(lamp.position);
            let list = &mut occluders[end..];
            end += world.occluders.find::<L>(lamp, center, radius, index, list);
        }
        *lamp_end = end;
    }

    let lamps = Lamps { lights, occluders, ends, highlight };
    let mut shadow = 0;
    for at in surfaces.all() {
        let (lanes, direction) = match Owed::packet(&at.rays) {
            Some(packet) => (Mask::every(), level.wave.directions().packet(packet)),
            None => (Mask::first(at.live), Vec3::from_arrays(&at.direction)),
        };
        let (point, normal) = form.surface(Vec3::from_arrays(&at.place), direction);
        let mut place =
            Place { point, normal, start: form.start(point, normal), mirrored: direction };
        if followed || highlight {
            place.mirrored = mirrored(F::NUMERICS, direction, normal);
        }
        let local = local::<L, F>(world, material, &place, lamps, lanes, &mut shadow);
        if followed {
            let owes =
                Owes { local, rays: &at.rays, material: primitive.material, k: material.mirror };
            go_on::<L, F>(world, index, &place, lanes, owes, level);
        } else {
            level.stack.push(local, &at.rays, Owed::END);
        }
    }
    level.count.shadow += shadow;
}

/// Ambient light plus what each visible lamp adds, in file order.
///
/// A lane that a lamp does not reach adds +0, which changes nothing: no colour is -0. Without
/// a highlight the recursion adds 0 · power, which changes nothing either.
#[inline(always)]
fn local<L: Lanes, F: Form<L::Scalar>>(
    world: World<L::Scalar>,
    material: &Phong<L::Scalar>,
    at: &Place<L>,
    lamps: Lamps<L::Scalar>,
    lanes: Mask<L>,
    shadow: &mut u64,
) -> Vec3<L> {
    let mut colour = Vec3::splat(material.ambient);
    let mut start = 0;
    for (lamp, &end) in lamps.lights.iter().zip(lamps.ends) {
        let occluders = &lamps.occluders[start..end];
        start = end;
        let to_lamp = Vec3::splat(lamp.position) - at.point;
        let distance = to_lamp.length();
        let l = to_lamp * (L::constant(1.0) / distance);
        let facing = at.normal.dot(l);
        let zero = L::constant(0.0);
        let faces = facing.gt(zero) & distance.gt(zero);
        *shadow += (faces & lanes).count();
        if lamp.hidden || !faces.any() {
            continue;
        }
        let lit = visible::<L, F>(world, at, occluders, l, distance, faces);
        if !lit.any() {
            continue;
        }
        let mut light = Vec3::splat(material.diffuse) * facing;
        if lamps.highlight {
            let highlight = L::splat(material.specular) * power(l.dot(at.mirrored), material.power);
            light = light + Vec3::all(highlight);
        }
        colour = colour + (Vec3::splat(lamp.intensity) * light).keep(lit);
    }
    colour
}

/// The lanes of `faces` between which and a lamp none of `occluders` stands.
#[inline(always)]
fn visible<L: Lanes, F: Form<L::Scalar>>(
    world: World<L::Scalar>,
    at: &Place<L>,
    occluders: &[u32],
    l: Vec3<L>,
    distance: L,
    faces: Mask<L>,
) -> Mask<L> {
    let mut lit = faces;
    let rays = Rays { origin: at.start, direction: l };
    for &number in occluders {
        let dark = match (F::NUMERICS, world.occluders.get(number)) {
            (Numerics::Robust, Occluder::Ball(ball)) => ball::occludes(ball, at.start, l, distance),
            (Numerics::Robust, Occluder::Flat(flat)) => flat::occludes(flat, at.start, l, distance),
            (Numerics::Textbook, Occluder::Textbook(index)) => {
                let root = match &world.scene.primitives[index as usize].shape {
                    Shape::TextbookSphere(sphere) => textbook::sphere_distance(sphere, &rays),
                    Shape::TextbookPlane(plane) => textbook::plane_distance(plane, &rays),
                    _ => unreachable!("a scene's forms are all of its numerics"),
                };
                root.met & root.t.lt(distance)
            }
            _ => unreachable!("a scene's forms are all of its numerics"),
        };
        lit = lit.without(dark);
        if !lit.any() {
            break;
        }
    }
    lit
}

/// d - 2 (d·n) n; robust: made a unit vector again by one Newton step.
#[inline(always)]
fn mirrored<L: Lanes>(numerics: Numerics, d: Vec3<L>, n: Vec3<L>) -> Vec3<L> {
    let v = d - n * (L::constant(2.0) * d.dot(n));
    match numerics {
        Numerics::Robust => v * (L::constant(1.5) - L::constant(0.5) * v.dot(v)),
        Numerics::Textbook => v,
    }
}

/// Adds the mirrored rays whose weight is not below the cut to the next wave.
///
/// Without a cut every weight passes, and weights are not even formed.
#[inline(always)]
fn go_on<L: Lanes, F: Form<L::Scalar>>(
    world: World<L::Scalar>,
    index: u32,
    at: &Place<L>,
    lanes: Mask<L>,
    owes: Owes<L>,
    level: &mut Level<L::Scalar>,
) {
    let left = match F::NUMERICS {
        Numerics::Robust => index,
        Numerics::Textbook => NONE,
    };
    let rays_on = Rays { origin: at.start, direction: at.mirrored };
    let mut next = Mirrored { rays: rays_on, weight: None, left };
    let mut goes_on = lanes;
    if level.cut {
        let weight = match Owed::packet(owes.rays) {
            Some(packet) => level.wave.weights().packet::<L>(packet),
            None => level.wave.weights().gather(|lane| owes.rays[lane].slot()),
        };
        let product = weight * L::splat(owes.k);
        goes_on = goes_on & product.ge(L::splat(world.scene.min_weight));
        next.weight = Some(product);
    }
    if goes_on.all() {
        level.next.push(&next);
        level.stack.push(owes.local, owes.rays, owes.material);
        return;
    }
    let (local, owed) = (owes.local.to_arrays(), Owed::each(owes.rays, owes.material));
    let ends = lanes.without(goes_on);
    if ends.any() {
        // Lanes that go on repeat the first one that ends.
        let set = ends.bits();
        let first = set.trailing_zeros() as usize % LANES;
        let Vec3 { x, y, z } = owes.local;
        let all = Vec3 {
            x: ends.select(x, L::splat(local[0][first])),
            y: ends.select(y, L::splat(local[1][first])),
            z: ends.select(z, L::splat(local[2][first])),
        };
        let mut ended = [owed[first].ended(); LANES];
        for (lane, (ended, owed)) in ended.iter_mut().zip(owed).enumerate() {
            if set >> lane & 1 != 0 {
                *ended = owed.ended();
            }
        }
        level.stack.push(all, &ended, 0);
    }
    level.next.push_lanes(&next, goes_on, &local, &owed, level.stack);
}
