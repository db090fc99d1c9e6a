//! Scenes by generation: touching, nested and coincident spheres, radii over nine decades,
//! the eye inside and outside, on surfaces, lights anywhere, every kind of material.

use catoptric_scene::{Draft, Light, Material, Numerics, Plane, Scene, Sphere};
use proptest::collection::vec;
use proptest::prelude::*;

/// Where a sphere stands.
#[derive(Clone, Debug)]
enum Place {
    /// Anywhere within some multiple of its radius.
    Free([f64; 3]),
    /// Touching an earlier sphere in that direction.
    Touching(usize, [f64; 3]),
    /// Inside an earlier sphere, touching it from within if the flag is set.
    Within(usize, [f64; 3], bool),
    /// The same centre and radius as an earlier sphere.
    Coincident(usize),
    /// Around the eye, the eye off its centre by that share of the radius.
    Around([f64; 3], f64),
    /// So that the eye is on its surface.
    UnderTheEye([f64; 3]),
}

/// Any scene that the format allows, of 0 to `spheres` spheres and the given size range.
pub fn scene(
    spheres: usize,
    size: impl Strategy<Value = (u32, u32)>,
) -> impl Strategy<Value = Scene> {
    let things = (
        vec((place(), radius(), material()), 0..=spheres),
        vec((vector(), vector(), material()), 0..=3),
        vec((vector(), colour()), 0..=3),
    );
    let eye = (vector(), direction(), field_of_view(), any::<prop::sample::Index>());
    let render = (depth(), min_weight(), colour(), colour(), numerics());
    (size, things, eye, render).prop_map(build)
}

/// The rim of a ball, or the horizon of a plane, somewhere across a narrow view: where bounds
/// on what a part of the picture shows are tight.
pub fn rim(size: impl Strategy<Value = (u32, u32)>) -> impl Strategy<Value = Scene> {
    let field_of_view = (-1.0..1.5f64).prop_map(|e: f64| 10f64.powf(e));
    let radius = prop_oneof![Just(None), (0.01..80.0f64).prop_map(Some)];
    (size, field_of_view, -0.7..0.7f64, -180.0..180.0f64, radius).prop_map(
        |((width, height), fov, share, roll, radius)| {
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (width, height);
            draft.camera.fov = fov;
            let roll = roll.to_radians();
            draft.camera.up = [roll.sin(), roll.cos(), 0.0];
            // The rim's elevation over the middle of the view.
            let rim = (fov * share).to_radians();
            let material = Material::matt([1.0; 3]);
            match radius.map(f64::to_radians) {
                None => {
                    let normal = [0.0, rim.cos(), rim.sin()];
                    draft.planes.push(Plane {
                        point: normal.map(|x| -x),
                        normal,
                        material: draft.materials.add(material),
                    });
                }
                Some(radius) => {
                    let elevation = rim - radius;
                    let center = [0.0, 50.0 * elevation.sin(), -50.0 * elevation.cos()];
                    draft.spheres.push(Sphere {
                        center,
                        radius: 50.0 * radius.sin(),
                        material: draft.materials.add(material),
                    });
                    // Something at another distance, so that the ball is not taken for flat.
                    let center = [0.0, 0.0, 900.0];
                    draft.spheres.push(Sphere {
                        center,
                        radius: 1.0,
                        material: draft.materials.add(material),
                    });
                }
            }
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// A ball whose rim passes the corner of a tile of the engine's, 32 pixels wide and 16 high, by
/// next to nothing: where bounds on what a tile shows are as tight as their margin.
pub fn corner() -> impl Strategy<Value = Scene> {
    let off = prop_oneof![
        1 => Just(0.0),
        4 => (-8.0..-2.0f64, any::<bool>())
            .prop_map(|(e, outside)| if outside { 10f64.powf(e) } else { -10f64.powf(e) }),
    ];
    let field_of_view = (-1.0..2.1f64).prop_map(|e: f64| 10f64.powf(e));
    // The first or the last pixel of a tile's row or column.
    let edge = |tile: u32| prop_oneof![Just(tile - 1), Just(tile)];
    let radius = (-3.0..0.0f64).prop_map(|e: f64| 10f64.powf(e));
    (field_of_view, edge(32), edge(16), radius, direction(), off).prop_map(
        |(fov, x, y, radius, aside, off)| {
            let mut draft = Draft::default();
            let (width, height) = (64, 32);
            (draft.image.width, draft.image.height) = (width, height);
            draft.camera.fov = fov;
            let h = (fov / 2.0).to_radians().tan();
            let place = |i: u32, n: u32| 2.0 * (f64::from(i) + 0.5) / f64::from(n) - 1.0;
            let aspect = f64::from(width) / f64::from(height);
            let ray = [place(x, width) * h * aspect, -place(y, height) * h, -1.0];
            let ray = ray.map(|v| v / distance(ray, [0.0; 3]));
            // The centre is off the ray by the angle under which the ball is seen.
            if let Some(across) = across(ray, aside) {
                let (sin, cos) = (radius.asin() * (1.0 + off)).sin_cos();
                let center = along(ray.map(|v| 50.0 * cos * v), across, 50.0 * sin);
                let material = Material::matt([1.0; 3]);
                draft.spheres.push(Sphere {
                    center,
                    radius: 50.0 * radius,
                    material: draft.materials.add(material),
                });
                // Something at another distance, so that the ball is not taken for flat.
                draft.spheres.push(Sphere {
                    center: [0.0, 0.0, 900.0],
                    radius: 1.0,
                    material: draft.materials.add(material),
                });
            }
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// A ball before a lamp, and another one at the rim of the shadow's way to it, the two on a
/// sphere so large that it curves the horizon: where bounds on what hides a lamp are tight.
pub fn eclipse(size: impl Strategy<Value = (u32, u32)>) -> impl Strategy<Value = Scene> {
    let off = prop_oneof![
        2 => Just(0.0),
        3 => (-7.0..-1.0, any::<bool>()).prop_map(|(e, sign): (f64, bool)| {
            if sign { 10f64.powf(e) } else { -10f64.powf(e) }
        }),
    ];
    let radii = ((-1.0..1.0f64), (-1.5..1.0f64)).prop_map(|(a, b)| (10f64.powf(a), 10f64.powf(b)));
    // Its radius over the ball's, and perhaps a lamp low over it, about where the ball's horizon
    // is.
    let low = prop_oneof![Just(None), (0.3..2.0f64, -3.0..0.0f64).prop_map(Some)];
    let ground = prop_oneof![1 => Just(None), 3 => (1.2..4.0f64, low).prop_map(|(e, l)| Some((10f64.powf(e), l)))];
    (size, radii, direction(), direction(), 0.02..1.2f64, 3.0..100.0f64, off, ground).prop_map(
        |((width, height), (radius, other), way, aside, share, far, off, ground)| {
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (width, height);
            draft.render.max_depth = 2;
            let mut material = Material::matt([0.8; 3]);
            material.reflect = Some(0.5);
            let center = [0.0, 0.0, -6.0 * radius];
            let mut lamp = along(center, way, radius * (1.0 + far));
            draft.spheres.push(Sphere { center, radius, material: draft.materials.add(material) });
            // Off the axis by what the cone from the lamp is wide there.
            if let Some(across) = across(way, aside) {
                let reach = radius * (1.0 + far);
                let wide = radius * (1.0 - share).abs() + other;
                let at = along(center, way, share * reach);
                let center = along(at, across, wide * (1.0 + off));
                draft.spheres.push(Sphere {
                    center,
                    radius: other,
                    material: draft.materials.add(material),
                });
            }
            if let Some((ground, low)) = ground {
                let center = along(center, [0.0, -1.0, 0.0], radius + ground * radius);
                draft.spheres.push(Sphere {
                    center,
                    radius: ground * radius,
                    material: draft.materials.add(material),
                });
                if let Some((share, height)) = low {
                    let (sin, cos) = (share * (4.0 / ground).sqrt()).sin_cos();
                    let height = radius * (ground + 10f64.powf(height));
                    lamp = along(center, [sin, cos, 0.0], height);
                }
            }
            draft.lights.push(Light { position: lamp, intensity: [1.0; 3] });
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// One place and a lamp, and a ball whose rim the way between them grazes. Eight more balls stand
/// out of the way: that many make the engine ask which of them can hide the lamp, and for one
/// place alone its bounds are as tight as their margin.
pub fn graze() -> impl Strategy<Value = Scene> {
    let off = (-7.0..-1.0f64, any::<bool>())
        .prop_map(|(e, outside)| if outside { 10f64.powf(e) } else { -10f64.powf(e) });
    let scales = ((-1.0..1.0f64), (-2.0..1.0f64)).prop_map(|(a, b)| (10f64.powf(a), 10f64.powf(b)));
    (scales, direction(), direction(), 1.0..50.0f64, 0.02..0.98f64, off).prop_map(
        |((radius, other), way, aside, far, share, off)| {
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (1, 1);
            let material = draft.materials.add(Material::matt([0.8; 3]));
            let ball = |center, radius| Sphere { center, radius, material };
            draft.spheres.push(ball([0.0, 0.0, -6.0 * radius], radius));
            let place = [0.0, 0.0, -5.0 * radius];
            // Towards the eye's side, which is the lit one.
            let way = [way[0], way[1], way[2].abs()];
            draft
                .lights
                .push(Light { position: along(place, way, far * radius), intensity: [1.0; 3] });
            let foot = along(place, way, share * far * radius);
            if let Some(across) = across(way, aside) {
                draft.spheres.push(ball(along(foot, across, other * (1.0 + off)), other));
            }
            for i in 0..8 {
                let center = [f64::from(i) * radius, 0.0, -100.0 * radius];
                draft.spheres.push(ball(center, 0.1 * radius));
            }
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// A place so far from a lamp that rounding moves the shadow there of a ball near the lamp, and
/// the ball's rim near the way between them.
pub fn far_graze() -> impl Strategy<Value = Scene> {
    let off = (-4.0..-0.3f64, any::<bool>())
        .prop_map(|(e, outside)| if outside { 10f64.powf(e) } else { -10f64.powf(e) });
    let far = (2.0..6.5f64).prop_map(|e| 10f64.powf(e));
    let scales = (far, 0.1..10.0f64, 0.1..10.0f64, 0.02..0.8f64);
    (scales, direction(), direction(), direction(), off).prop_map(
        |((far, lamp_far, from_lamp, share), away, lamp, aside, off)| {
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (8, 1);
            draft.camera.fov = 0.1;
            let material = draft.materials.add(Material::matt([0.8; 3]));
            let ball = |center, radius| Sphere { center, radius, material };
            let place = along([0.0; 3], away, far);
            draft.camera.look_at = place;
            draft.camera.up = across(away, lamp).unwrap_or([0.6, 0.48, 0.64]);
            draft.spheres.push(ball(along([0.0; 3], away, 1.5 * far), 0.5 * far));
            let lamp = along([0.0; 3], lamp, lamp_far);
            draft.lights.push(Light { position: lamp, intensity: [1.0; 3] });
            let way = [place[0] - lamp[0], place[1] - lamp[1], place[2] - lamp[2]];
            let way = along([0.0; 3], way, 1.0 / way.iter().map(|x| x * x).sum::<f64>().sqrt());
            if let Some(across) = across(way, aside) {
                let radius = share * from_lamp;
                let foot = along(lamp, way, from_lamp);
                draft.spheres.push(ball(along(foot, across, radius * (1.0 + off)), radius));
            }
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// A heap of mirror balls so far away, for their size, that rays leave them from a little inside
/// or outside; they cover few pixels each, so that rays of one packet leave different ones.
pub fn specks(size: impl Strategy<Value = (u32, u32)>) -> impl Strategy<Value = Scene> {
    let balls = vec((direction(), 0.1..1.0f64, colour()), 4..=16);
    (size, balls, direction(), direction(), -7.0..-4.0f64).prop_map(
        |((width, height), balls, away, lamp, share)| {
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (width, height);
            (draft.render.max_depth, draft.render.background) = (4, [0.3, 0.2, 0.1]);
            // The heap is about a unit wide.
            let far = 10f64.powf(-share);
            let middle = along([0.0; 3], away, far);
            draft.camera.look_at = middle;
            draft.camera.up = across(away, lamp).unwrap_or([0.6, 0.48, 0.64]);
            draft.camera.fov = (2.0 / far).to_degrees();
            for (at, radius, color) in balls {
                let material = Material { reflect: Some(0.9), ..Material::matt(color) };
                let center = along(middle, at, 1.0 - radius);
                draft.spheres.push(Sphere {
                    center,
                    radius: 0.5 * radius,
                    material: draft.materials.add(material),
                });
            }
            let position = along(middle, lamp, 10.0);
            draft.lights.push(Light { position, intensity: [1.0; 3] });
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

/// A ball just inside another one, or just out of it, where that one faces the eye, and a mirror
/// that shows both from elsewhere.
pub fn nested(size: impl Strategy<Value = (u32, u32)>) -> impl Strategy<Value = Scene> {
    let gap = (-7.5..-3.0f64, any::<bool>())
        .prop_map(|(e, inside)| if inside { 10f64.powf(e) } else { -10f64.powf(e) });
    let scales = ((-2.0..2.0f64), (0.02..1.2f64), (-1.5..-0.001f64));
    (size, scales, direction(), direction(), direction(), gap).prop_map(
        |((width, height), (radius, far, share), aside, lamp, mirror, gap)| {
            let (radius, far) = (10f64.powf(radius), 10f64.powf(far));
            let mut draft = Draft::default();
            (draft.image.width, draft.image.height) = (width, height);
            (draft.render.max_depth, draft.render.background) = (3, [0.1, 0.2, 0.3]);
            let outer = Material { reflect: Some(0.5), ..Material::matt([0.9, 0.5, 0.1]) };
            let inner = Material { reflect: Some(0.3), ..Material::matt([0.1, 0.5, 0.9]) };
            let center = [0.0, 0.0, -far * radius];
            let to_eye = along([0.0, 0.0, 1.0], aside, 0.5);
            let length = distance(to_eye, [0.0; 3]);
            let within = radius * 10f64.powf(share);
            let off = radius - within - gap * (1.0 + far) * radius;
            let at = along(center, to_eye.map(|x| x / length), off);
            // Where they are closest, so near that what stands out covers some pixels.
            let closest = along(center, to_eye.map(|x| x / length), radius);
            let cap = (2.0 * within * gap.abs() * (1.0 + far) * radius).sqrt();
            draft.camera.look_at = closest;
            draft.camera.fov = (4.0 * cap / distance(closest, [0.0; 3])).to_degrees().min(120.0);
            draft.spheres.push(Sphere {
                center: at,
                radius: within,
                material: draft.materials.add(inner),
            });
            draft.spheres.push(Sphere { center, radius, material: draft.materials.add(outer) });
            let shows = along(center, mirror, 3.0 * radius);
            if distance(shows, [0.0; 3]) > radius {
                draft.spheres.push(Sphere {
                    center: shows,
                    radius,
                    material: draft.materials.add(outer),
                });
            }
            let position = along(center, lamp, 5.0 * radius);
            draft.lights.push(Light { position, intensity: [1.0; 3] });
            Scene::new(draft).expect("generated scenes are valid")
        },
    )
}

type Things =
    (Vec<(Place, f64, Material)>, Vec<([f64; 3], [f64; 3], Material)>, Vec<([f64; 3], [f64; 3])>);
type Eye = ([f64; 3], [f64; 3], f64, prop::sample::Index);
type Render = (u32, f64, [f64; 3], [f64; 3], Numerics);

fn build(((width, height), things, eye, render): ((u32, u32), Things, Eye, Render)) -> Scene {
    let (spheres, planes, lights) = things;
    let (position, aside, fov, target) = eye;
    let mut draft = Draft::default();
    draft.image.width = width;
    draft.image.height = height;
    (draft.render.max_depth, draft.render.min_weight, ..) = render;
    (_, _, draft.render.background, draft.render.ambient, draft.render.numerics) = render;
    for (place, radius, material) in spheres {
        let (center, radius) = place_sphere(&draft.spheres, position, &place, radius);
        draft.spheres.push(Sphere { center, radius, material: draft.materials.add(material) });
    }
    for (point, normal, material) in planes {
        draft.planes.push(Plane { point, normal, material: draft.materials.add(material) });
    }
    draft.lights =
        lights.into_iter().map(|(position, intensity)| Light { position, intensity }).collect();
    // Look at something, or the picture is background.
    draft.camera.position = position;
    draft.camera.fov = fov;
    draft.camera.look_at = along(position, aside, 1.0);
    if !draft.spheres.is_empty() {
        let center = target.get(&draft.spheres).center;
        if distance(center, position) > 1e-6 {
            draft.camera.look_at = center;
        }
    }
    let view: [f64; 3] = std::array::from_fn(|i| draft.camera.look_at[i] - position[i]);
    // Any vector that is not along the view: the axis of its least component.
    let least = (0..3).min_by(|&a, &b| view[a].abs().total_cmp(&view[b].abs()));
    draft.camera.up = [0.0; 3];
    draft.camera.up[least.expect("three components")] = 1.0;
    Scene::new(draft).expect("generated scenes are valid")
}

fn place_sphere(earlier: &[Sphere], eye: [f64; 3], place: &Place, radius: f64) -> ([f64; 3], f64) {
    let other = |i: usize| earlier.get(i % earlier.len().max(1)).copied();
    let (center, radius) = match *place {
        Place::Free(at) => (at.map(|x| x * (1.0 + radius)), radius),
        Place::Touching(i, way) => match other(i) {
            Some(o) => (along(o.center, way, o.radius + radius), radius),
            None => (along(eye, way, 3.0 * radius), radius),
        },
        Place::Within(i, way, touching) => match other(i) {
            Some(o) => {
                let inner = o.radius * 0.4;
                (along(o.center, way, if touching { o.radius - inner } else { inner }), inner)
            }
            None => (along(eye, way, 2.0 * radius), radius),
        },
        Place::Coincident(i) => match other(i) {
            Some(o) => (o.center, o.radius),
            None => (along(eye, [0.0, 0.0, -1.0], 4.0 * radius), radius),
        },
        Place::Around(way, share) => (along(eye, way, share * radius), radius),
        Place::UnderTheEye(way) => (along(eye, way, radius), radius),
    };
    // Placed against a tiny sphere, a radius may leave the format's range.
    (center, if radius < 1e-9 { 1e-9 } else { radius })
}

fn along(from: [f64; 3], way: [f64; 3], length: f64) -> [f64; 3] {
    std::array::from_fn(|i| from[i] + way[i] * length)
}

/// The part of `aside` that is at right angles to the unit vector `way`, as a unit vector.
fn across(way: [f64; 3], aside: [f64; 3]) -> Option<[f64; 3]> {
    let dot: f64 = (0..3).map(|i| way[i] * aside[i]).sum();
    let across: [f64; 3] = std::array::from_fn(|i| aside[i] - dot * way[i]);
    let length = distance(across, [0.0; 3]);
    (length > 1e-3).then(|| across.map(|x| x / length))
}

fn distance(a: [f64; 3], b: [f64; 3]) -> f64 {
    (0..3).map(|i| (a[i] - b[i]) * (a[i] - b[i])).sum::<f64>().sqrt()
}

fn vector() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![
        4 => prop::array::uniform3(-10.0..10.0),
        1 => prop::array::uniform3(-1e4..1e4),
        1 => prop::array::uniform3((-3i32..=3).prop_map(f64::from)),
    ]
    .prop_filter("not zero", |v| v.iter().any(|x| x.abs() > 1e-3))
}

fn direction() -> impl Strategy<Value = [f64; 3]> {
    prop::array::uniform3(-1.0..1.0)
        .prop_filter("not short", |v: &[f64; 3]| distance(*v, [0.0; 3]) > 0.1)
        .prop_map(|v| v.map(|x| x / distance(v, [0.0; 3])))
}

fn radius() -> impl Strategy<Value = f64> {
    prop_oneof![
        6 => (-1.0..1.0).prop_map(|e: f64| 10f64.powf(e)),
        2 => (-3.0..6.0).prop_map(|e: f64| 10f64.powf(e)),
    ]
}

fn place() -> impl Strategy<Value = Place> {
    prop_oneof![
        4 => prop::array::uniform3(-5.0..5.0).prop_map(Place::Free),
        3 => (0..40usize, direction()).prop_map(|(i, d)| Place::Touching(i, d)),
        1 => (0..40usize, direction(), any::<bool>()).prop_map(|(i, d, t)| Place::Within(i, d, t)),
        1 => (0..40usize).prop_map(Place::Coincident),
        1 => (direction(), 0.0..1.0).prop_map(|(d, s)| Place::Around(d, s)),
        1 => direction().prop_map(Place::UnderTheEye),
    ]
}

fn colour() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![
        3 => prop::array::uniform3(0.0..1.0),
        1 => (0.0..1.5).prop_map(|x| [x; 3]),
        1 => Just([0.0; 3]),
    ]
}

fn material() -> impl Strategy<Value = Material> {
    let factor = || prop_oneof![Just(0.0), Just(1.0), 0.0..1.0];
    let shininess = prop_oneof![
        3 => (0u32..=40).prop_map(f64::from),
        1 => prop::sample::select(vec![200.0, 1023.0, 1024.0, 1025.0, 1e6, 1e-3]),
        2 => 0.0..300.0,
    ];
    let reflect = prop_oneof![1 => Just(None), 2 => factor().prop_map(Some)];
    (colour(), factor(), factor(), shininess, reflect).prop_map(
        |(color, diffuse, specular, shininess, reflect)| Material {
            color,
            diffuse,
            specular,
            shininess,
            reflect,
        },
    )
}

fn field_of_view() -> impl Strategy<Value = f64> {
    prop_oneof![4 => 1.0..120.0, 1 => 0.01..1.0, 1 => 120.0..179.9]
}

fn depth() -> impl Strategy<Value = u32> {
    prop_oneof![3 => 0u32..8, 1 => 8u32..80]
}

fn min_weight() -> impl Strategy<Value = f64> {
    prop_oneof![3 => Just(0.0), 1 => 0.0..1.0, 1 => Just(1.0), 1 => Just(1.5)]
}

fn numerics() -> impl Strategy<Value = Numerics> {
    prop_oneof![2 => Just(Numerics::Robust), 1 => Just(Numerics::Textbook)]
}
