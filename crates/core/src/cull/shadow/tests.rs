//! What cannot stand before a light, beside the shadow tests themselves.

mod scenes;

use catoptric_scene::{Compiled, Shape as AnyShape};
use glam::DVec3;

use super::{CONES, CONES_EACH, Occluders, lights_with_cones};
use crate::ray::{NONE, Rays};
use crate::shape::{Shape, ShapeVisitor, dispatch};
use crate::simd::numbers::{Numbers, TestScalar, isas};
use crate::simd::{Kernel, Lanes, Mask, Vec3, in_f64, run};
use scenes::Points;

/// Lights, spheres and samples of scenes small and large.
#[test]
fn cones_take_memory_by_lights_and_balls_and_not_by_both() {
    for lights in [0, 1, 2, 10, 1000, 100_000] {
        for spheres in [0, 1, 5, 100, 20_000, 1_000_000] {
            for samples in [1, 512, 640 * 480, 1 << 30] {
                let with_cones = lights_with_cones(spheres, lights, samples);
                let most = CONES + CONES_EACH * (lights + spheres);
                assert!(with_cones <= lights && with_cones * spheres <= most);
                let few_samples = spheres > samples / 8;
                assert!(!few_samples || with_cones == 0, "{spheres} spheres, {samples} samples");
                let few = lights * spheres <= CONES && !few_samples;
                assert!(!few || with_cones == lights, "{lights} lights, {spheres} spheres");
            }
        }
    }
    assert_eq!(lights_with_cones(1_000_000, 3, 1 << 30), 3, "usual scenes have all");
}

/// Asks for the occluders of points, and tests them all.
struct Shadows<'a, S: TestScalar> {
    occluders: &'a Occluders<S>,
    light: S::Vec3,
    points: &'a Points<S>,
    bounds: (DVec3, f64),
}

/// What is said of an occluder: whether it is listed, the lanes of all packets that it darkens, and
/// those that its cone says it does not.
struct Said {
    number: u32,
    listed: bool,
    dark: u64,
    outside: u64,
}

impl<S: TestScalar> Kernel for Shadows<'_, S> {
    type Scalar = S;
    type Output = Vec<Said>;

    #[inline(always)]
    fn run<L: Lanes<Scalar = S>>(self) -> Vec<Said> {
        let Self { occluders, light, points, bounds: (center, radius) } = self;
        let mut list = vec![0; occluders.len() + 1];
        let position = in_f64::<S>(light);
        let len = occluders.find::<L>(position, center, radius, NONE, &mut list);
        let cones = occluders.cones(0);
        let anchor = Vec3::<L>::splat(points.anchor.into());
        let mut all = Vec::new();
        for number in 0..occluders.len() as u32 {
            let listed = list[..len].contains(&number);
            let mut said = Said { number, listed, dark: 0, outside: 0 };
            for arm in &points.arms {
                // As `light` forms shadow rays.
                let arm = Vec3::<L>::from_arrays(arm);
                let to_light = Vec3::splat(light) - anchor - arm;
                let distance = to_light.length();
                let direction = to_light * (L::constant(1.0) / distance);
                let rays = Rays { origin: anchor + arm, direction };
                let test = Blocks { rays, limit: distance };
                let dark = dispatch::<L, _, false>(occluders.shape(number), test);
                let mut outside = Mask::<L>::none();
                if let Some(cone) = cones.cones.get(number as usize) {
                    let along = direction.dot(Vec3::splat(cone.axis));
                    outside = along.lt(L::splat(cone.cos)) & distance.lt(L::splat(cones.reach));
                }
                said.dark = said.dark << 8 | u64::from(dark.bits());
                said.outside = said.outside << 8 | u64::from(outside.bits());
            }
            all.push(said);
        }
        all
    }
}

/// The shadow test.
struct Blocks<L> {
    rays: Rays<L>,
    limit: L,
}

impl<L: Lanes> ShapeVisitor<L> for Blocks<L> {
    type Output = Mask<L>;

    #[inline(always)]
    fn visit<F: Shape<L>>(self, shape: F) -> Mask<L> {
        shape.blocks(&self.rays, self.limit)
    }
}

/// How many occluders were left out, lanes were outside of cones, and lanes were dark.
#[derive(Default)]
struct Seen {
    left_out: usize,
    outside: u32,
    dark: u32,
}

/// Compares what is left out with the tests, on every instruction set.
fn compare<S: TestScalar>(scene: &Compiled<S>, points: &Points<S>, seen: &mut Seen) {
    let all: Vec<_> = (0..scene.primitives.len() as u32).collect();
    let occluders = Occluders::new(scene, &all).with_cones(&scene.lights, 1 << 20);
    let bounds = points.bounds();
    for isa in isas() {
        let (light, occluders) = (scene.lights[0].position, &occluders);
        for said in run(isa, Shadows { occluders, light, points, bounds }) {
            let shape: &AnyShape<S> = occluders.shape(said.number);
            let context = || format!("{isa}: {shape:?}, light {light:?}, {points:?}");
            assert!(said.listed || said.dark == 0, "left out, and darkens: {}", context());
            assert_eq!(said.dark & said.outside, 0, "dark, and no cone's: {}", context());
            seen.left_out += usize::from(!said.listed);
            seen.outside += said.outside.count_ones();
            seen.dark += said.dark.count_ones();
        }
    }
}

fn check<S: TestScalar>(
    rounds: usize,
    scene: fn(&mut Numbers) -> (Compiled<S>, Points<S>),
) -> Seen {
    let mut numbers = Numbers::new(41);
    let mut seen = Seen::default();
    for _ in 0..rounds {
        let (scene, points) = scene(&mut numbers);
        compare(&scene, &points, &mut seen);
    }
    seen
}

#[test]
fn no_sphere_darkens_a_point_that_it_was_left_out_for() {
    for seen in [check::<f32>(6000, scenes::spheres), check::<f64>(1000, scenes::spheres)] {
        let Seen { left_out, outside, dark } = seen;
        assert!(
            left_out > 1000 && outside > 10_000 && dark > 10_000,
            "{left_out} {outside} {dark}"
        );
    }
}

#[test]
fn no_large_sphere_darkens_a_point_that_it_was_left_out_for() {
    for seen in [check::<f32>(6000, scenes::horizons), check::<f64>(1000, scenes::horizons)] {
        assert!(seen.left_out > 50 && seen.dark > 500, "{} {}", seen.left_out, seen.dark);
    }
}
