//! The keys that are written, and their values' spelling, which TOML and JSON share.

use super::names::Names;
use super::text::text;
use crate::error::number;
use crate::{Camera, Draft, Image, Light, Material, MaterialId, Numerics, Render, Transfer};

/// Keys and values of one table.
pub(super) type Entries = Vec<(&'static str, String)>;

/// One key of the top level.
pub(super) enum Section {
    Table(&'static str, Entries),
    /// Tables, each with a name of its own.
    Named(&'static str, Vec<(String, Entries)>),
    Array(&'static str, Vec<Entries>),
}

/// A draft's sections in the order of the format, without empty ones. The draft's numbers must be
/// finite: JSON has no others.
pub(super) fn sections(draft: &Draft) -> Vec<Section> {
    // A material with a name to be written is referred to by it; others stand inline.
    let names = Names::of(draft);
    let made_of = |id: MaterialId| match names.of_material(id) {
        Some(name) => vec![("material", text(name))],
        None => material(&draft.materials[id]),
    };
    let spheres = draft.spheres.iter().map(|sphere| {
        let own = [("center", triple(sphere.center)), ("radius", number(sphere.radius))];
        own.into_iter().chain(made_of(sphere.material)).collect()
    });
    let planes = draft.planes.iter().map(|plane| {
        let own = [("point", triple(plane.point)), ("normal", triple(plane.normal))];
        own.into_iter().chain(made_of(plane.material)).collect()
    });
    // Materials stand once under their names, also the ones that no body has.
    let named =
        names.written.iter().map(|(id, name)| (name.clone(), material(&draft.materials[*id])));
    let mut sections = vec![
        Section::Table("image", image(&draft.image)),
        Section::Table("camera", camera(&draft.camera)),
        Section::Table("render", render(&draft.render)),
        Section::Array("lights", draft.lights.iter().map(light).collect()),
        Section::Named("materials", named.collect()),
        Section::Array("spheres", spheres.collect()),
        Section::Array("planes", planes.collect()),
    ];
    // Empty lists are left out: they are the default. Settings always have keys.
    sections.retain(|section| match section {
        Section::Table(..) => true,
        Section::Named(_, tables) => !tables.is_empty(),
        Section::Array(_, tables) => !tables.is_empty(),
    });
    sections
}

fn image(image: &Image) -> Entries {
    let mut entries =
        vec![("width", image.width.to_string()), ("height", image.height.to_string())];
    match image.transfer {
        Transfer::Linear => {}
        Transfer::Srgb => entries.push(("transfer", "\"srgb\"".to_owned())),
    }
    entries
}

fn camera(camera: &Camera) -> Entries {
    vec![
        ("position", triple(camera.position)),
        ("look_at", triple(camera.look_at)),
        ("up", triple(camera.up)),
        ("fov", number(camera.fov)),
    ]
}

fn render(render: &Render) -> Entries {
    let default = Render::default();
    let mut entries = vec![("max_depth", render.max_depth.to_string())];
    if differs(render.min_weight, default.min_weight) {
        entries.push(("min_weight", number(render.min_weight)));
    }
    if differs3(render.background, default.background) {
        entries.push(("background", triple(render.background)));
    }
    if differs3(render.ambient, default.ambient) {
        entries.push(("ambient", amount(render.ambient)));
    }
    match render.numerics {
        Numerics::Robust => {}
        Numerics::Textbook => entries.push(("numerics", "\"textbook\"".to_owned())),
    }
    entries
}

fn light(light: &Light) -> Entries {
    let mut entries = vec![("position", triple(light.position))];
    if differs3(light.intensity, [1.0; 3]) {
        entries.push(("intensity", amount(light.intensity)));
    }
    entries
}

fn material(material: &Material) -> Entries {
    let default = Material::matt(material.color);
    let mut entries = vec![("color", triple(material.color))];
    let factors = [
        ("diffuse", material.diffuse, default.diffuse),
        ("specular", material.specular, default.specular),
        ("shininess", material.shininess, default.shininess),
    ];
    for (key, value, default) in factors {
        if differs(value, default) {
            entries.push((key, number(value)));
        }
    }
    entries.extend(material.reflect.map(|reflect| ("reflect", number(reflect))));
    entries
}

/// Whether two numbers differ as bits: -0 is not 0 here.
fn differs(a: f64, b: f64) -> bool {
    a.to_bits() != b.to_bits()
}

fn differs3(a: [f64; 3], b: [f64; 3]) -> bool {
    a.map(f64::to_bits) != b.map(f64::to_bits)
}

fn triple(v: [f64; 3]) -> String {
    format!("[{}]", v.map(number).join(", "))
}

/// Three numbers, written as one where they are equal.
fn amount(v: [f64; 3]) -> String {
    if differs3(v, [v[0]; 3]) { triple(v) } else { number(v[0]) }
}
