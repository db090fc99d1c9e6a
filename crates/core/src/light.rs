//! The light that lamps send back from places on one primitive.
//!
//! Places are lit side by side: a step is taken for all of them before the next step. No step
//! waits for the root and the quotient of its own place then, and all that depends on the lamp or
//! on an occluder is a scalar for all places.

use catoptric_scene::{Numerics, Phong, PointLight, Scalar, Shape};

use crate::ball::Ball;
use crate::flat::Flat;
use crate::lanes::{LANES, Lane, Lanes, Mask};
use crate::nearest::Form;
use crate::occluders::{Occluder, Toward};
use crate::packet::{Rays, World};
use crate::power::power;
use crate::surfaces::Surface;
use crate::textbook::{TextbookPlane, TextbookSphere};
use crate::vec3::{Packed, Vec3};

/// So many packets of places are lit side by side, each a bit of a u32. They stay in the nearest
/// cache.
pub(crate) const SIDE_BY_SIDE: usize = 16;

const _: () = assert!(SIDE_BY_SIDE <= u32::BITS as usize);

/// Eight places on a primitive.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
pub(crate) struct Place<S> {
    pub(crate) normal: Packed<S>,
    /// Where rays that come there go on to; left out where nothing asks for it.
    pub(crate) mirrored: Packed<S>,
    /// The light so far.
    pub(crate) colour: Packed<S>,
    /// Lanes with a ray: so many, the first ones.
    pub(crate) live: u32,
    way: Way<S>,
}

/// From eight places to a lamp.
#[derive(Clone, Copy)]
#[repr(C, align(32))]
struct Way<S> {
    /// Unit vectors.
    l: Packed<S>,
    distance: [S; LANES],
    /// n·l.
    facing: [S; LANES],
    /// All ones where the lamp is seen, as far as is known.
    lit: [S; LANES],
}

/// A lamp, and what may stand before it.
#[derive(Clone, Copy)]
pub(crate) struct Lamp<'a, S: Scalar> {
    pub(crate) lamp: &'a PointLight<S>,
    pub(crate) toward: Toward<'a, S>,
    /// Numbers of occluders.
    pub(crate) occluders: &'a [u32],
}

impl<S: Lane> Place<S> {
    pub(crate) const EMPTY: Self = {
        let (one, three) = ([S::ZERO; LANES], [[S::ZERO; LANES]; 3]);
        let way = Way { l: three, distance: one, facing: one, lit: one };
        Self { normal: three, mirrored: three, colour: three, live: 0, way }
    };

    /// Unit vectors and distances to the lamp.
    #[inline(always)]
    fn way<L: Lanes<Scalar = S>>(&self) -> (Vec3<L>, L) {
        (Vec3::from_arrays(&self.way.l), L::from_array(self.way.distance))
    }

    #[inline(always)]
    fn lit<L: Lanes<Scalar = S>>(&self) -> Mask<L> {
        Mask::from_array(self.way.lit)
    }

    #[inline(always)]
    fn darken<L: Lanes<Scalar = S>>(&mut self, dark: Mask<L>) {
        self.way.lit = self.lit::<L>().without(dark).to_array();
    }
}

/// Adds what a lamp sends back from places on surfaces; how many rays were sent to it.
///
/// A lane that the lamp does not reach adds +0, which changes nothing: no colour is -0. Without
/// a highlight the recursion adds 0 · power, which changes nothing either.
#[inline(always)]
pub(crate) fn light<L: Lanes, F: Form<L>>(
    form: F,
    world: World<L::Scalar>,
    material: &Phong<L::Scalar>,
    highlight: bool,
    lamp: Lamp<L::Scalar>,
    surfaces: &[Surface<L::Scalar>],
    places: &mut [Place<L::Scalar>],
) -> u64 {
    let Lamp { lamp, toward, occluders } = lamp;
    // Formed once: in the loops, which write, the compiler would read and spread them each time.
    let from_anchor = form.relative(Vec3::splat(lamp.position));
    let reach = L::splat(toward.reach);
    let (intensity, diffuse) = (Vec3::<L>::splat(lamp.intensity), Vec3::splat(material.diffuse));
    let specular = L::splat(material.specular);
    let mut rays = 0;
    let mut far = 0;
    for (surface, at) in surfaces.iter().zip(&mut *places).rev() {
        let to_lamp = from_anchor - Vec3::from_arrays(&surface.arm);
        let distance = to_lamp.length();
        let l = to_lamp * (L::constant(1.0) / distance);
        let facing = Vec3::from_arrays(&at.normal).dot(l);
        let zero = L::constant(0.0);
        let faces = facing.gt(zero) & distance.gt(zero);
        rays += u64::from((faces.bits() & ((1 << at.live) - 1)).count_ones());
        far = far * 2 + u32::from(faces.without(distance.lt(reach)).any());
        at.way = Way {
            l: l.to_arrays(),
            distance: distance.to_array(),
            facing: facing.to_array(),
            lit: faces.to_array(),
        };
    }
    if lamp.hidden {
        return rays;
    }
    if F::NUMERICS == Numerics::Robust && world.omit.occluders {
        shadows_side_by_side::<L, F>(form, world, far, (toward, occluders), surfaces, places);
    } else {
        shadows_in_turn::<L, F>(form, world, occluders, surfaces, places);
    }
    for at in places {
        let lit = at.lit::<L>();
        if !lit.any() {
            continue;
        }
        let mut light = diffuse * L::from_array(at.way.facing);
        if highlight {
            let shine = Vec3::<L>::from_arrays(&at.way.l).dot(Vec3::from_arrays(&at.mirrored));
            let highlight = specular * power(shine, material.power);
            light = light + Vec3::all(highlight);
        }
        let sent = (intensity * light).keep(lit);
        at.colour = (Vec3::from_arrays(&at.colour) + sent).to_arrays();
    }
    rays
}

/// Shadows of balls and large spheres, one after another. `far`: the places beyond the lamp's reach.
#[inline(always)]
fn shadows_side_by_side<L: Lanes, F: Form<L>>(
    form: F,
    world: World<L::Scalar>,
    far: u32,
    (toward, occluders): (Toward<L::Scalar>, &[u32]),
    surfaces: &[Surface<L::Scalar>],
    places: &mut [Place<L::Scalar>],
) {
    let point = |surface: &Surface<L::Scalar>| form.point(Vec3::<L>::from_arrays(&surface.arm));
    for &number in occluders {
        match world.occluders.get(number) {
            Occluder::Ball(ball) => {
                let mut rest = far | toward.reached::<L>(number, places);
                while rest != 0 {
                    let place = rest.trailing_zeros() as usize % SIDE_BY_SIDE;
                    rest &= rest - 1;
                    let (point, at) = (point(&surfaces[place]), &mut places[place]);
                    let (l, distance) = at.way();
                    at.darken(Ball::splat(ball).occludes(point, l, distance));
                }
            }
            Occluder::Flat(flat) => {
                for (surface, at) in surfaces.iter().zip(&mut *places) {
                    let (l, distance) = at.way();
                    at.darken(Flat::splat(flat).occludes(point(surface), l, distance));
                }
            }
            Occluder::Textbook(_) => unreachable!("a scene's forms are all of its numerics"),
        }
    }
}

/// Place by place, until a place is dark. Textbook roots cost more than to find that out, and so do
/// occluders none of which is left out.
#[inline(always)]
fn shadows_in_turn<L: Lanes, F: Form<L>>(
    form: F,
    world: World<L::Scalar>,
    occluders: &[u32],
    surfaces: &[Surface<L::Scalar>],
    places: &mut [Place<L::Scalar>],
) {
    for (surface, at) in surfaces.iter().zip(places) {
        let (l, distance) = at.way::<L>();
        let point = form.point(Vec3::from_arrays(&surface.arm));
        let start = form.start(point, Vec3::from_arrays(&at.normal));
        let rays = Rays { origin: start, direction: l };
        let mut lit = at.lit::<L>();
        for &number in occluders {
            if !lit.any() {
                break;
            }
            let dark = match (F::NUMERICS, world.occluders.get(number)) {
                (Numerics::Robust, Occluder::Ball(ball)) => {
                    Ball::splat(ball).occludes(start, l, distance)
                }
                (Numerics::Robust, Occluder::Flat(flat)) => {
                    Flat::splat(flat).occludes(start, l, distance)
                }
                (Numerics::Textbook, Occluder::Textbook(index)) => {
                    let root = match &world.scene.primitives[index as usize].shape {
                        Shape::TextbookSphere(sphere) => {
                            TextbookSphere::splat(sphere).met_by(&rays)
                        }
                        Shape::TextbookPlane(plane) => TextbookPlane::splat(plane).met_by(&rays),
                        _ => unreachable!("a scene's forms are all of its numerics"),
                    };
                    root.met & root.t.lt(distance)
                }
                _ => unreachable!("a scene's forms are all of its numerics"),
            };
            lit = lit.without(dark);
        }
        at.way.lit = lit.to_array();
    }
}

impl<S: Lane> Toward<'_, S> {
    /// Among which places a ball may hide the lamp, place i as bit i; from no others does it. Of
    /// places within reach; a lamp without cones has none.
    #[inline(always)]
    fn reached<L: Lanes<Scalar = S>>(&self, number: u32, places: &[Place<S>]) -> u32 {
        let Some(cone) = self.cones.get(number as usize) else { return 0 };
        let (axis, cos) = (Vec3::<L>::splat(cone.axis), L::splat(cone.cos));
        let mut reached = 0;
        for at in places.iter().rev() {
            let outside = Vec3::from_arrays(&at.way.l).dot(axis).lt(cos);
            let lit = at.lit::<L>();
            reached = reached * 2 + u32::from(lit.without(outside).any());
        }
        reached
    }
}
