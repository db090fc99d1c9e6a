//! Scenes with a plane, or a sphere around everything, behind which nothing is ever met; and a
//! thing of any size that stands there.

use catoptric_scene::{Draft, Material, Numerics, Plane, Scene, Sphere};
use proptest::prelude::*;

use crate::generate;

/// What stands behind the shield, sizes and distances in powers of ten.
#[derive(Clone, Debug)]
struct Thing {
    /// A plane, or a sphere of this radius.
    radius: Option<f64>,
    /// How far behind the shield, over its least distance.
    behind: f64,
    /// Which way, along the shield.
    aside: [f64; 3],
    /// How far that way.
    off: f64,
}

/// A scene, and the same with one thing more that no ray meets. Paths never leave the eye's side
/// of a plane, nor the inside of a sphere around the eye, so what stands on the other side is met
/// by no eye ray, by no mirrored ray and on no way to a lamp.
pub fn pair() -> impl Strategy<Value = [Scene; 2]> {
    let exponent = || -6.0..9.0f64;
    let shield = (any::<bool>(), direction(), exponent().prop_map(power));
    let thing = (
        prop_oneof![1 => Just(None), 4 => exponent().prop_map(|e| Some(power(e)))],
        exponent().prop_map(power),
        direction(),
        exponent().prop_map(power),
    );
    let thing = thing.prop_map(|(radius, behind, aside, off)| Thing { radius, behind, aside, off });
    (generate::scene(8, (1u32..=24, 1u32..=18)), shield, thing).prop_map(
        |(scene, (plane, way, height), thing)| {
            let mut draft = scene.into_draft();
            draft.render.numerics = Numerics::Robust;
            let eye = draft.camera.position;
            let extent = draft.spheres.iter().map(|s| distance(s.center, eye) + s.radius);
            let extent = extent.fold(0.0, f64::max);
            let material = Material { reflect: Some(0.3), ..Material::matt([0.4, 0.5, 0.6]) };
            // The shield's point nearest the eye, and the thing behind it.
            let added = if plane {
                let foot = along(eye, way, -height);
                draft.planes.push(Plane {
                    point: foot,
                    normal: way,
                    material: draft.materials.add(material),
                });
                behind_plane(extent + height, foot, way, &thing)
            } else {
                let radius = height + 1.0;
                let center = along(eye, way, height);
                draft.spheres.push(Sphere {
                    center,
                    radius,
                    material: draft.materials.add(material),
                });
                outside(extent + height, center, radius, way, &thing)
            };
            let mut more = draft.clone();
            let material = more.materials.add(Material::matt([9.0, 0.0, 9.0]));
            match added {
                Added::Sphere { center, radius } => {
                    more.spheres.push(Sphere { center, radius, material });
                }
                Added::Plane { point, normal } => {
                    more.planes.push(Plane { point, normal, material });
                }
            }
            [draft, more].map(|draft: Draft| Scene::new(draft).expect("in range"))
        },
    )
}

enum Added {
    Sphere { center: [f64; 3], radius: f64 },
    Plane { point: [f64; 3], normal: [f64; 3] },
}

/// Its nearest point is farther behind than rounding could ever lead a ray: a hundredth of its size
/// and of how far from the eye a ray may come from a sphere.
fn behind_plane(extent: f64, foot: [f64; 3], normal: [f64; 3], thing: &Thing) -> Added {
    let margin = |size: f64| thing.behind + 0.01 * (size + extent);
    let Some(radius) = thing.radius else {
        let point = along(foot, normal, -margin(0.0));
        return Added::Plane { point, normal };
    };
    let dot: f64 = (0..3).map(|i| thing.aside[i] * normal[i]).sum();
    let aside = along(thing.aside, normal, -dot);
    let at = along(foot, aside, thing.off);
    let center = along(at, normal, -(margin(radius + thing.off) + radius));
    Added::Sphere { center, radius }
}

/// Beside a sphere around the eye.
fn outside(extent: f64, center: [f64; 3], radius: f64, way: [f64; 3], thing: &Thing) -> Added {
    let size = thing.radius.unwrap_or(thing.off);
    let way = if thing.off > 1.0 { way.map(|x| -x) } else { thing.aside };
    let margin = thing.behind + 0.01 * (size + radius + extent);
    Added::Sphere { center: along(center, way, radius + margin + size), radius: size }
}

fn power(exponent: f64) -> f64 {
    10f64.powf(exponent)
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0..1.0)
        .prop_filter("not short", |v: &[f64; 3]| distance(*v, [0.0; 3]) > 0.1)
        .prop_map(|v| v.map(|x| x / distance(v, [0.0; 3])))
}

fn along(from: [f64; 3], way: [f64; 3], length: f64) -> [f64; 3] {
    std::array::from_fn(|i| from[i] + way[i] * length)
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
}
