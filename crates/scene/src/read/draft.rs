//! Values to draft: which keys there are, and their defaults.

use std::collections::BTreeMap;

use super::nearest::list;
use super::table::Table;
use super::value::Value;
use crate::error::{Fault, Trail};
use crate::validate::allowed::{
    AMOUNT, COMPONENT, COORDINATE, DEPTH, FIELD_OF_VIEW, MIRROR, RADIUS, SIDE,
};
use crate::{Camera, Draft, Image, Light, Material, Numerics, Plane, Render, Sphere, Transfer};

const POINT: &str = "[x, y, z]";
const RGB: &str = "[r, g, b]";
const MATERIAL_KEYS: [&str; 5] = ["color", "diffuse", "specular", "shininess", "reflect"];

type Materials<'a> = BTreeMap<&'a str, Material>;

/// The draft that a file states, and all materials that it names, by name.
pub(super) fn read(root: &Value) -> Result<(Draft, Vec<(String, Material)>), Fault> {
    let top = Trail::Root;
    let keys = ["image", "camera", "render", "lights", "materials", "spheres", "planes"];
    let scene = Table::open(root, &top, &keys)?;
    let materials = materials(&scene)?;
    let draft = Draft {
        image: scene.get("image").map_or(Ok(Image::default()), image)?,
        camera: scene.get("camera").map_or(Ok(Camera::default()), camera)?,
        render: scene.get("render").map_or(Ok(Render::default()), render)?,
        lights: each(&scene, "lights", light)?,
        spheres: each(&scene, "spheres", |entry| sphere(entry, &materials))?,
        planes: each(&scene, "planes", |entry| plane(entry, &materials))?,
    };
    Ok((draft, materials.into_iter().map(|(name, made)| (name.to_owned(), made)).collect()))
}

/// Reads each table of an array.
fn each<T>(
    scene: &Table<'_>,
    key: &str,
    read: impl Fn((&Value, Trail<'_>)) -> Result<T, Fault>,
) -> Result<Vec<T>, Fault> {
    let trail = scene.trail.key(key);
    let entries = scene.entries(key)?.iter().enumerate();
    entries.map(|(index, entry)| read((entry, trail.index(index)))).collect()
}

fn image((value, trail): (&Value, Trail<'_>)) -> Result<Image, Fault> {
    let table = Table::open(value, &trail, &["width", "height", "transfer"])?;
    let default = Image::default();
    let transfers = [("linear", Transfer::Linear), ("srgb", Transfer::Srgb)];
    Ok(Image {
        width: table.integer("width", &SIDE)?.unwrap_or(default.width),
        height: table.integer("height", &SIDE)?.unwrap_or(default.height),
        transfer: table.word("transfer", transfers)?.unwrap_or(default.transfer),
    })
}

fn camera((value, trail): (&Value, Trail<'_>)) -> Result<Camera, Fault> {
    let table = Table::open(value, &trail, &["position", "look_at", "up", "fov"])?;
    let default = Camera::default();
    Ok(Camera {
        position: table.triple("position", POINT, &COORDINATE)?.unwrap_or(default.position),
        look_at: table.triple("look_at", POINT, &COORDINATE)?.unwrap_or(default.look_at),
        up: table.triple("up", POINT, &COMPONENT)?.unwrap_or(default.up),
        fov: table.number("fov", &FIELD_OF_VIEW)?.unwrap_or(default.fov),
    })
}

fn render((value, trail): (&Value, Trail<'_>)) -> Result<Render, Fault> {
    let keys = ["max_depth", "min_weight", "background", "ambient", "numerics"];
    let table = Table::open(value, &trail, &keys)?;
    let default = Render::default();
    let numerics = [("robust", Numerics::Robust), ("textbook", Numerics::Textbook)];
    Ok(Render {
        max_depth: table.integer("max_depth", &DEPTH)?.unwrap_or(default.max_depth),
        min_weight: table.number("min_weight", &AMOUNT)?.unwrap_or(default.min_weight),
        background: table.triple("background", RGB, &AMOUNT)?.unwrap_or(default.background),
        ambient: table.light("ambient", &AMOUNT)?.unwrap_or(default.ambient),
        numerics: table.word("numerics", numerics)?.unwrap_or(default.numerics),
    })
}

fn light((value, trail): (&Value, Trail<'_>)) -> Result<Light, Fault> {
    let table = Table::open(value, &trail, &["position", "intensity"])?;
    let position = table.triple("position", POINT, &COORDINATE)?;
    Ok(Light {
        position: position.ok_or_else(|| table.missing("position", POINT))?,
        intensity: table.light("intensity", &AMOUNT)?.unwrap_or([1.0; 3]),
    })
}

fn sphere((value, trail): (&Value, Trail<'_>), materials: &Materials<'_>) -> Result<Sphere, Fault> {
    let table = Table::open(value, &trail, &body_keys(["center", "radius"]))?;
    let center = table.triple("center", POINT, &COORDINATE)?;
    let radius = table.number("radius", &RADIUS)?;
    Ok(Sphere {
        center: center.ok_or_else(|| table.missing("center", POINT))?,
        radius: radius.ok_or_else(|| table.missing("radius", RADIUS.text))?,
        material: body_material(&table, materials)?,
    })
}

fn plane((value, trail): (&Value, Trail<'_>), materials: &Materials<'_>) -> Result<Plane, Fault> {
    let table = Table::open(value, &trail, &body_keys(["point", "normal"]))?;
    let point = table.triple("point", POINT, &COORDINATE)?;
    let normal = table.triple("normal", POINT, &COMPONENT)?;
    Ok(Plane {
        point: point.ok_or_else(|| table.missing("point", POINT))?,
        normal: normal.ok_or_else(|| table.missing("normal", POINT))?,
        material: body_material(&table, materials)?,
    })
}

/// The keys of a body: its own two, `material`, and a material's keys.
fn body_keys([first, second]: [&'static str; 2]) -> [&'static str; 8] {
    let [color, diffuse, specular, shininess, reflect] = MATERIAL_KEYS;
    [first, second, "material", color, diffuse, specular, shininess, reflect]
}

/// A body's material: named or inline, never both.
fn body_material(table: &Table<'_>, materials: &Materials<'_>) -> Result<Material, Fault> {
    let words = "the name of one of the materials";
    if let Some((found @ Value::Table(_), trail)) = table.get("material") {
        let keys = MATERIAL_KEYS.join(", ");
        let allowed = format!("{words}; without one, {keys} stand beside the body's own keys");
        return Err(Fault::new(trail, found.describe(), allowed));
    }
    let Some(name) = table.text("material", words)? else {
        return material(
            table,
            "[r, g, b] here, or `material` with the name of one of the materials",
        );
    };
    if let Some(key) = MATERIAL_KEYS.into_iter().find(|key| table.get(key).is_some()) {
        let allowed = "either the name of a material or a material's keys inline, not both";
        return Err(Fault::key(
            table.trail.key(key),
            format!("both `{key}` and `material`"),
            allowed,
        ));
    }
    materials.get(name).copied().ok_or_else(|| {
        let allowed = if materials.is_empty() {
            format!("{words}, and there are none")
        } else {
            format!("{words}: {}", list(name, materials.keys().copied()))
        };
        Fault::new(table.trail.key("material"), Value::Text(name.to_owned()).describe(), allowed)
    })
}

fn materials<'a>(scene: &Table<'a>) -> Result<Materials<'a>, Fault> {
    let Some((value, trail)) = scene.get("materials") else {
        return Ok(Materials::new());
    };
    let Value::Table(named) = value else {
        return Err(Fault::new(
            trail,
            value.describe(),
            "a table of materials by name, such as [materials.red] in TOML",
        ));
    };
    named
        .iter()
        .map(|(name, value)| {
            let trail = trail.key(name);
            let table = Table::open(value, &trail, &MATERIAL_KEYS)?;
            Ok((name.as_str(), material(&table, RGB)?))
        })
        .collect()
}

/// The keys of a material, wherever they stand.
fn material(table: &Table<'_>, color_allowed: &str) -> Result<Material, Fault> {
    let color = table.triple("color", RGB, &AMOUNT)?;
    let default = Material::matt(color.ok_or_else(|| table.missing("color", color_allowed))?);
    Ok(Material {
        diffuse: table.number("diffuse", &AMOUNT)?.unwrap_or(default.diffuse),
        specular: table.number("specular", &AMOUNT)?.unwrap_or(default.specular),
        shininess: table.number("shininess", &AMOUNT)?.unwrap_or(default.shininess),
        reflect: table.number("reflect", &MIRROR)?,
        ..default
    })
}
