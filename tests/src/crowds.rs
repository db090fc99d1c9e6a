//! Scenes of very many primitives in very small pictures: what fills a tile's stack.
//!
//! The worst that a tile can meet is a primitive of its own for each of its rays: then nothing is
//! put together to eights but what is mirrored. These scenes have up to some thousands.

use catoptric_scene::family::{Lattice, Placement, Random};
use catoptric_scene::{Draft, Light, Material, Numerics, Scene, Sphere};
use proptest::collection::vec;
use proptest::prelude::*;

/// Spheres one for each pixel, each in the way of that pixel's eye ray alone; some pixels have
/// none. Every mixture of materials that end a path, that send it on, and that a cut by weight
/// parts; and something that sends mirrored rays back, or nothing.
pub fn a_sphere_a_pixel(
    size: impl Strategy<Value = (u32, u32)>,
    max_depth: impl Strategy<Value = u32>,
) -> impl Strategy<Value = Scene> {
    let spheres = size.prop_flat_map(|(width, height)| {
        let pixels = (width * height) as usize;
        (Just((width, height)), vec(pixel(), pixels..=pixels))
    });
    let reflect = prop_oneof![Just(0.0), Just(1.0), 0.0..1.0];
    let palette = prop_oneof![
        1 => Just(vec![0.0]),
        1 => Just(vec![1.0]),
        4 => vec(reflect, 2..=9),
    ];
    let min_weight = prop_oneof![2 => Just(0.0), 2 => 0.0..1.0, 1 => Just(1.0)];
    let around = prop_oneof![1 => Just(None), 2 => (0.0..1.0f64).prop_map(Some)];
    let numerics = prop_oneof![4 => Just(Numerics::Robust), 1 => Just(Numerics::Textbook)];
    (spheres, palette, min_weight, around, max_depth, numerics).prop_map(
        |(((width, height), pixels), palette, min_weight, around, max_depth, numerics)| {
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (width, height);
            (draft.render.max_depth, draft.render.min_weight) = (max_depth, min_weight);
            (draft.render.numerics, draft.render.background) = (numerics, [0.2, 0.3, 0.4]);
            draft.lights.push(Light { position: [3.0, 9.0, 2.0], intensity: [0.7; 3] });
            let reflecting = |k, color| Material { reflect: Some(k), ..Material::matt(color) };
            let pitch = 2.0 * (draft.camera.fov / 2.0).to_radians().tan() / f64::from(height);
            for (i, Pixel { distance, share, aside, choice }) in (0..).zip(pixels) {
                let Some(distance) = distance else { continue };
                let (x, y) = (i % width, i / width);
                let place = |i: u32, n: u32| f64::from(i) + 0.5 - f64::from(n) / 2.0;
                let way = [place(x, width) * pitch, -place(y, height) * pitch, -1.0];
                // Less than half a pixel wide, and off the ray by less than its radius.
                let radius = 0.45 * share * pitch * distance;
                let aside = [aside[0] * radius, aside[1] * radius, 0.0];
                let center = std::array::from_fn(|i| way[i] * distance + 0.6 * aside[i]);
                let k = palette[choice % palette.len()];
                let material = reflecting(k, [0.2 + 0.5 * k, 0.9 - 0.4 * share, 0.5]);
                draft.spheres.push(Sphere {
                    center,
                    radius,
                    material: draft.materials.add(material),
                });
            }
            if let Some(k) = around {
                let material = reflecting(k, [0.5, 0.6, 0.3]);
                draft.spheres.push(Sphere {
                    center: [1.0, 2.0, 3.0],
                    radius: 300.0,
                    material: draft.materials.add(material),
                });
            }
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// Some thousands of spheres: a grid seen from outside, or a cloud that overlaps, in a small
/// picture.
pub fn thousands(size: impl Strategy<Value = (u32, u32)>) -> impl Strategy<Value = Scene> {
    let reflect = prop_oneof![2 => Just(0.0), 3 => 0.1..1.0f64];
    let min_weight = prop_oneof![2 => Just(0.0), 1 => 0.0..1.0];
    let count = prop_oneof![8u32..=12, 12u32..=15];
    (size, count, reflect, 0u32..=4, min_weight, any::<u64>(), any::<bool>()).prop_map(
        |((width, height), edge, reflect, max_depth, min_weight, seed, cloud)| {
            let lattice = Lattice { edge, reflect, seed, ..Lattice::default() };
            let count = edge * edge * edge;
            let placement = Placement::Anywhere;
            let random = Random { balls: count, placement, reflect, seed, ..Random::default() };
            let draft = if cloud { random.draft() } else { lattice.draft() };
            let mut draft = draft.expect("parameters in their ranges");
            (draft.image.width, draft.image.height) = (width, height);
            (draft.render.max_depth, draft.render.min_weight) = (max_depth, min_weight);
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// What stands before one pixel.
#[derive(Clone, Debug)]
struct Pixel {
    /// How far away the sphere is; none, if there is none.
    distance: Option<f64>,
    /// Its size, as a share of the largest one.
    share: f64,
    /// How far it stands off the ray, in radii, on both axes of the picture.
    aside: [f64; 2],
    /// Which material.
    choice: usize,
}

fn pixel() -> impl Strategy<Value = Pixel> {
    let distance = prop_oneof![1 => Just(None), 15 => (20.0..60.0f64).prop_map(Some)];
    (distance, 0.2..1.0, [-1.0..1.0, -1.0..1.0], any::<usize>())
        .prop_map(|(distance, share, aside, choice)| Pixel { distance, share, aside, choice })
}
