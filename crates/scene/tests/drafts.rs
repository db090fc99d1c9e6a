//! Generated drafts that are valid scenes.

use std::collections::BTreeSet;

use catoptric_scene::{
    Camera, Draft, Image, Light, Material, Materials, Numerics, Plane, Render, Scene, Sphere,
    Transfer,
};
use proptest::collection::vec;
use proptest::prelude::*;
use proptest::sample::select;

/// Any bits whose number lies between 0 and `most`, often a plain one.
fn amount(most: f64) -> impl Strategy<Value = f64> {
    let any_bits = any::<u64>().prop_map(f64::from_bits);
    let odd = any_bits.prop_map(move |x| if x.abs() <= most { x.abs() } else { most });
    prop_oneof![odd, 0.0..1.0_f64, select(vec![0.0, -0.0, 0.1, 1.0, f64::from_bits(1)])]
}

/// Any bits within ±`most`.
fn signed(most: f64) -> impl Strategy<Value = f64> {
    (amount(most), any::<bool>()).prop_map(|(x, negative)| if negative { -x } else { x })
}

fn place() -> impl Strategy<Value = [f64; 3]> {
    [signed(1e15), signed(1e15), signed(1e15)]
}

/// Small enough that factors, colours and lights multiplied stay within f32.
fn rgb() -> impl Strategy<Value = [f64; 3]> {
    [amount(1e9), amount(1e9), amount(1e9)]
}

/// One number for all channels half of the time.
fn light_rgb() -> impl Strategy<Value = [f64; 3]> {
    prop_oneof![rgb(), amount(1e9).prop_map(|x| [x; 3])]
}

fn material() -> impl Strategy<Value = Material> {
    let factors = (amount(1e9), amount(1.0), amount(1e30));
    (rgb(), factors, proptest::option::of(amount(1.0))).prop_map(
        |(color, (diffuse, specular, shininess), reflect)| Material {
            color,
            diffuse,
            specular,
            shininess,
            reflect,
        },
    )
}

/// Words that some file may call a material, with every kind of character.
fn name() -> impl Strategy<Value = String> {
    prop_oneof![
        "[a-z0-9_-]{0,3}",
        "m[0-2]",
        "\\PC{1,4}",
        vec(any::<char>(), 0..4).prop_map(String::from_iter)
    ]
}

fn image() -> impl Strategy<Value = Image> {
    let transfer = select(vec![Transfer::Linear, Transfer::Srgb]);
    (1..=65_535_u32, 1..=65_535_u32, transfer).prop_map(|(width, height, transfer)| Image {
        width,
        height,
        transfer,
    })
}

fn camera() -> impl Strategy<Value = Camera> {
    (place(), place(), place(), 1e-30..180.0_f64).prop_map(|(position, look_at, up, fov)| Camera {
        position,
        look_at,
        up,
        fov,
    })
}

fn render() -> impl Strategy<Value = Render> {
    let numerics = select(vec![Numerics::Robust, Numerics::Textbook]);
    (any::<u32>(), amount(2.0), rgb(), light_rgb(), numerics).prop_map(
        |(max_depth, min_weight, background, ambient, numerics)| Render {
            max_depth,
            min_weight,
            background,
            ambient,
            numerics,
        },
    )
}

fn light() -> impl Strategy<Value = Light> {
    (place(), light_rgb()).prop_map(|(position, intensity)| Light { position, intensity })
}

/// Drafts that are valid. Few materials, so that bodies share some; some have names, some no body.
pub(crate) fn draft() -> impl Strategy<Value = Draft> {
    let bodies = vec((material(), proptest::option::of(name())), 1..4).prop_flat_map(|made| {
        let mut materials = Materials::default();
        let mut ids = Vec::new();
        let mut taken = BTreeSet::new();
        for (made, name) in made {
            let name = name.filter(|name| taken.insert(name.clone()));
            ids.push(match name {
                Some(name) => materials.add_named(name, made),
                None => materials.add(made),
            });
        }
        let made = select(ids);
        let sphere = (place(), 1e-12..1e12_f64, made.clone())
            .prop_map(|(center, radius, material)| Sphere { center, radius, material });
        let plane = (place(), place(), made).prop_map(|(point, normal, material)| Plane {
            point,
            normal,
            material,
        });
        (Just(materials), vec(sphere, 0..6), vec(plane, 0..4))
    });
    ((image(), camera(), render()), vec(light(), 0..4), bodies)
        .prop_map(|((image, camera, render), lights, (materials, spheres, planes))| Draft {
            image,
            camera,
            render,
            lights,
            materials,
            spheres,
            planes,
        })
        // Nearly all are; a few cameras look along their up, a few normals are zero.
        .prop_filter("valid", |draft| Scene::new(draft.clone()).is_ok())
}
