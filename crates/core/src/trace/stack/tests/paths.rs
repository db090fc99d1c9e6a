//! Paths of rays on plain numbers, and the recursion along them.

use catoptric_scene::{Phong, Power};
use glam::Vec3;

use crate::ray::BREADTH;
use crate::simd::LANES;
use crate::simd::numbers::Numbers;

/// What a ray meets at one bounce.
#[derive(Clone, Copy)]
pub(super) struct Met {
    pub(super) primitive: u32,
    pub(super) local: [f32; 3],
}

/// What a ray meets, one after another.
#[derive(Clone)]
struct Path {
    met: Vec<Met>,
    /// Whether it ends where it meets the last one; else it goes on from there and meets nothing.
    ends: bool,
}

/// A tile's paths, one a ray.
pub(super) struct Paths(Vec<Path>);

pub(super) const BACKGROUND: [f32; 3] = [0.125, 0.75, 1e-30];

/// Materials, of which a primitive has the one of its index modulo their number.
pub(super) fn materials() -> Vec<Phong> {
    let mirrors = [0.0, 1.0, 0.5, 0.3, 0.999, 1e-20, 0.7];
    let zero = Vec3::ZERO;
    let material = |mirror| Phong {
        ambient: zero,
        diffuse: zero,
        specular: 0.0,
        power: Power::Whole { exponent: 0, cut: -1.0 },
        mirror,
    };
    mirrors.map(material).to_vec()
}

impl Path {
    /// A path of so many reflections at most.
    fn random(depth: usize, numbers: &mut Numbers) -> Self {
        let primitives = [1, 3, 20][numbers.below(3)];
        let len = numbers.below(depth + 2);
        let mut met = Vec::new();
        for _ in 0..len {
            met.push(Met::random(numbers.below(primitives) as u32, numbers));
        }
        // As far as reflections are followed, a ray may also be lost.
        Self { met, ends: len > depth || len > 0 && numbers.one_in(2) }
    }

    /// The same primitives, with other light.
    fn beside(&self, numbers: &mut Numbers) -> Self {
        let met = self.met.iter().map(|met| Met::random(met.primitive, numbers)).collect();
        Self { met, ends: self.ends }
    }
}

impl Met {
    fn random(primitive: u32, numbers: &mut Numbers) -> Self {
        let edge = numbers.one_in(32);
        let light = |_| if edge { numbers.any() } else { numbers.between(0.0, 1.0) as f32 };
        Self { primitive, local: std::array::from_fn(light) }
    }
}

impl Paths {
    /// Packets whose rays stay together, part at some bounce, or were never together.
    pub(super) fn random(rays: usize, depth: usize, numbers: &mut Numbers) -> Self {
        let mut paths: Vec<Path> = Vec::new();
        while paths.len() < rays {
            let first = Path::random(depth, numbers);
            let style = numbers.below(4);
            for _ in 0..LANES.min(rays - paths.len()) {
                let mut path = first.beside(numbers);
                if style == 0 {
                    path = Path::random(depth, numbers);
                } else if style == 1 && numbers.one_in(3) && path.met.len() > 1 {
                    path.met.truncate(1 + numbers.below(path.met.len()));
                    path.ends = true;
                }
                paths.push(path);
            }
        }
        Self(paths)
    }

    /// Paths around the bounce at which packets are held.
    pub(super) fn deep(rays: usize, numbers: &mut Numbers) -> Self {
        let path = |_| {
            let mut path = Path { met: Vec::new(), ends: numbers.one_in(2) };
            // Some end long before the others.
            let far = !numbers.one_in(4);
            let len = if far { BREADTH - 20 + numbers.below(60) } else { numbers.below(100) };
            for _ in 0..len {
                path.met.push(Met::random(numbers.below(3) as u32, numbers));
            }
            path.ends &= !path.met.is_empty();
            path
        };
        Self((0..rays).map(path).collect())
    }

    /// Rays that go on together `depth` times, then meet one primitive each and end there.
    pub(super) fn alone(rays: usize, depth: usize, numbers: &mut Numbers) -> Self {
        let path = |ray: usize| {
            let mut met: Vec<_> = (0..depth).map(|_| Met::random(0, numbers)).collect();
            met.push(Met::random(ray as u32, numbers));
            Path { met, ends: true }
        };
        Self((0..rays).map(path).collect())
    }

    pub(super) fn len(&self) -> usize {
        self.0.len()
    }

    /// What a ray meets at a bounce, if anything.
    pub(super) fn met(&self, ray: usize, bounce: usize) -> Option<Met> {
        self.0[ray].met.get(bounce).copied()
    }

    /// Whether a ray's path ends where it meets something at a bounce.
    pub(super) fn ends(&self, ray: usize, bounce: usize) -> bool {
        self.0[ray].ends && bounce + 1 == self.0[ray].met.len()
    }

    /// The colour of a ray from a bounce on: the recursion.
    pub(super) fn recursion(&self, materials: &[Phong], ray: usize, bounce: usize) -> [f32; 3] {
        let Some(Met { primitive, local }) = self.met(ray, bounce) else { return BACKGROUND };
        if self.ends(ray, bounce) {
            return local;
        }
        let mirror = materials[primitive as usize % materials.len()].mirror;
        let back = self.recursion(materials, ray, bounce + 1);
        std::array::from_fn(|i| local[i] + back[i] * mirror)
    }

    /// How many rays there are at each bounce.
    pub(super) fn rays(&self) -> Vec<u64> {
        let mut rays = Vec::new();
        for path in &self.0 {
            let len = path.met.len() + usize::from(!path.ends);
            rays.resize(rays.len().max(len), 0);
            rays[..len].iter_mut().for_each(|rays| *rays += 1);
        }
        rays
    }
}
