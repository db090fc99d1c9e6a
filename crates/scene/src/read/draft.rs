//! Values to draft: which keys there are, and their defaults.
//!
//! A scene arrives value by value, in any order: the settings, and each body and material on its
//! own. Thus there is never a tree of the whole scene. A body may come before the material that it
//! names: the draft then holds a stand-in until the file states the material.

use std::collections::BTreeMap;

use super::memory::Memory;
use super::nearest::list;
use super::table::{Table, check_key};
use super::value::Value;
use crate::error::{Fault, Problem, Trail};
use crate::validate::allowed::{
    AMOUNT, COMPONENT, COORDINATE, DEPTH, FIELD_OF_VIEW, LIGHT, MIRROR, RADIUS, SIDE, SPECULAR,
};
use crate::{
    Body, Camera, Draft, Image, Light, Material, MaterialId, Materials, Numerics, Plane, Render,
    Sphere, Transfer,
};

const POINT: &str = "[x, y, z]";
const RGB: &str = "[r, g, b]";
const MATERIAL_KEYS: [&str; 5] = ["color", "diffuse", "specular", "shininess", "reflect"];
const MATERIAL_NAME: &str = "the name of one of the materials";

/// The keys of the top level.
pub(super) const KEYS: [&str; 7] =
    ["image", "camera", "render", "lights", "materials", "spheres", "planes"];

/// The key of the materials, a table of tables by name.
pub(super) const MATERIALS: &str = "materials";

/// The keys that hold lists of tables, read entry by entry.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum List {
    Lights,
    Spheres,
    Planes,
}

impl List {
    /// The list that a key holds, if it holds one.
    pub(super) fn of_key(key: &str) -> Option<Self> {
        [Self::Lights, Self::Spheres, Self::Planes].into_iter().find(|list| list.key() == key)
    }

    pub(super) fn key(self) -> &'static str {
        match self {
            Self::Lights => "lights",
            Self::Spheres => "spheres",
            Self::Planes => "planes",
        }
    }
}

/// What a file states so far.
pub(super) struct Reader {
    draft: Draft,
    memory: Memory,
    /// The first fault. After it, text is parsed but not read: broken syntax is reported first.
    fault: Option<Fault>,
    names: Names,
}

/// Materials by name: stated by the file, or named by a body.
#[derive(Default)]
struct Names(BTreeMap<String, Named>);

#[derive(Clone, Copy)]
struct Named {
    id: MaterialId,
    /// Whether the file has stated the material yet. Until then the draft holds a stand-in.
    stated: bool,
}

/// Bytes that a name takes beside its letters: entries here and in the draft, and a share of
/// half-full nodes.
const NAME_BYTES: u64 = 240;

impl Names {
    /// The material of a name; adds a stand-in if the name is new, as the file may state it later.
    fn named(
        &mut self,
        name: &str,
        materials: &mut Materials,
        memory: &mut Memory,
    ) -> Result<&mut Named, Problem> {
        if !self.0.contains_key(name) {
            memory.take(name.len() as u64 + NAME_BYTES)?;
            let id = push_material(Material::matt([0.0; 3]), materials, memory)?;
            self.0.insert(name.to_owned(), Named { id, stated: false });
        }
        Ok(self.0.get_mut(name).expect("it is there"))
    }

    /// Names that have a material, in order.
    fn known(&self) -> Vec<&str> {
        let stated = self.0.iter().filter(|(_, named)| named.stated);
        stated.map(|(name, _)| name.as_str()).collect()
    }
}

/// Adds a material whose bytes are counted.
fn push_material(
    material: Material,
    materials: &mut Materials,
    memory: &mut Memory,
) -> Result<MaterialId, Problem> {
    let id = MaterialId::at(materials.len());
    memory.push(materials.stated_mut(), material)?;
    Ok(id)
}

impl Reader {
    /// An empty scene with all its defaults.
    pub(super) fn new(memory: Memory) -> Self {
        Self { draft: Draft::default(), memory, fault: None, names: Names::default() }
    }

    pub(super) fn memory(&self) -> &Memory {
        &self.memory
    }

    /// Checks a key of the top level, before its value.
    pub(super) fn key(&mut self, key: &str) {
        self.keep(check_key(key, &Trail::Root, &KEYS));
    }

    /// Keeps the fault of a scene that is not a table.
    pub(super) fn not_a_table(&mut self, value: &Value) {
        self.keep(Table::open(value, &Trail::Root, &KEYS).map(|_| ()));
    }

    /// Reads a top-level value that comes whole. Unknown keys were refused by [`Self::key`].
    pub(super) fn setting(&mut self, key: &str, value: &Value) {
        let trail = Trail::Root.key(key);
        let at = (value, trail);
        let read = match key {
            "image" => image(at).map(|image| self.draft.image = image),
            "camera" => camera(at).map(|camera| self.draft.camera = camera),
            "render" => render(at).map(|render| self.draft.render = render),
            MATERIALS => Err(Fault::new(
                trail,
                value.describe(),
                "a table of materials by name, such as [materials.red] in TOML",
            )),
            _ => List::of_key(key).map_or(Ok(()), |list| {
                let key = list.key();
                let allowed = format!("an array of tables (in TOML, [[{key}]] before each)");
                Err(Fault::new(trail, value.describe(), allowed))
            }),
        };
        self.keep(read);
    }

    /// Reads the next entry of a list.
    ///
    /// # Errors
    /// The memory is not enough; faults are kept.
    pub(super) fn entry(&mut self, list: List, value: &Value) -> Result<(), Problem> {
        if self.fault.is_some() {
            return Ok(());
        }
        let trail = Trail::Root.key(list.key());
        let Self { draft, memory, names, .. } = self;
        let read = match list {
            List::Lights => light((value, trail.index(draft.lights.len())))
                .map_err(Problem::from)
                .and_then(|light| memory.push(&mut draft.lights, light)),
            List::Spheres => {
                let at = (value, trail.index(draft.spheres.len()));
                sphere(at, names, &mut draft.materials, memory)
                    .and_then(|sphere| memory.push(&mut draft.spheres, sphere))
            }
            List::Planes => {
                let at = (value, trail.index(draft.planes.len()));
                plane(at, names, &mut draft.materials, memory)
                    .and_then(|plane| memory.push(&mut draft.planes, plane))
            }
        };
        match read {
            Err(Problem::Key(fault)) => {
                self.fault = Some(fault);
                Ok(())
            }
            read => read,
        }
    }

    /// Reads a material of a name; false if the file stated that name before.
    ///
    /// # Errors
    /// The memory is not enough; faults are kept.
    pub(super) fn material(&mut self, name: &str, value: &Value) -> Result<bool, Problem> {
        let trail = Trail::Root.key(MATERIALS);
        let trail = trail.key(name);
        let table = Table::open(value, &trail, &MATERIAL_KEYS);
        match table.and_then(|table| material(&table, RGB)) {
            Ok(made) => {
                let materials = &mut self.draft.materials;
                let named = self.names.named(name, materials, &mut self.memory)?;
                materials[named.id] = made;
                Ok(!std::mem::replace(&mut named.stated, true))
            }
            Err(fault) => {
                self.keep(Err(fault));
                Ok(true)
            }
        }
    }

    fn keep(&mut self, read: Result<(), Fault>) {
        if let Err(fault) = read {
            self.fault.get_or_insert(fault);
        }
    }

    /// The draft that the file states.
    ///
    /// # Errors
    /// The first fault, or a material that is named and not there.
    pub(super) fn finish(mut self) -> Result<Draft, Problem> {
        if let Some(fault) = self.fault {
            return Err(fault.into());
        }
        if let Some(fault) = unknown_material(&self.draft, &self.names) {
            return Err(fault.into());
        }
        for (name, named) in self.names.0 {
            self.draft.materials.set_name(named.id, name);
        }
        Ok(self.draft)
    }
}

/// The first body whose material is named and not stated.
fn unknown_material(draft: &Draft, names: &Names) -> Option<Fault> {
    let missing = names.0.iter().filter(|(_, named)| !named.stated);
    let missing: BTreeMap<_, _> = missing.map(|(name, named)| (named.id, name)).collect();
    if missing.is_empty() {
        return None;
    }
    let of_body = |body: Body<'_>| missing.get(&body.material());
    let (place, name) =
        draft.bodies().enumerate().find_map(|(place, body)| Some((place, of_body(body)?)))?;
    let known = names.known();
    let allowed = if known.is_empty() {
        format!("{MATERIAL_NAME}, and there are none")
    } else {
        format!("{MATERIAL_NAME}: {}", list(name, known.iter().copied()))
    };
    let found = Value::Text((*name).clone()).describe();
    let (list, index) = match place.checked_sub(draft.spheres.len()) {
        None => (List::Spheres, place),
        Some(index) => (List::Planes, index),
    };
    let trail = Trail::Root.key(list.key());
    let trail = trail.index(index);
    Some(Fault::new(trail.key("material"), found, allowed))
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
        background: table.triple("background", RGB, &LIGHT)?.unwrap_or(default.background),
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

/// Reads a sphere; its material is added to the draft's, or looked up by name.
fn sphere(
    (value, trail): (&Value, Trail<'_>),
    names: &mut Names,
    materials: &mut Materials,
    memory: &mut Memory,
) -> Result<Sphere, Problem> {
    let table = Table::open(value, &trail, &body_keys(["center", "radius"]))?;
    let center = table.triple("center", POINT, &COORDINATE)?;
    let radius = table.number("radius", &RADIUS)?;
    let center = center.ok_or_else(|| table.missing("center", POINT))?;
    let radius = radius.ok_or_else(|| table.missing("radius", RADIUS.text))?;
    let material = body_material(&table, names, materials, memory)?;
    Ok(Sphere { center, radius, material })
}

/// Reads a plane; its material is added to the draft's, or looked up by name.
fn plane(
    (value, trail): (&Value, Trail<'_>),
    names: &mut Names,
    materials: &mut Materials,
    memory: &mut Memory,
) -> Result<Plane, Problem> {
    let table = Table::open(value, &trail, &body_keys(["point", "normal"]))?;
    let point = table.triple("point", POINT, &COORDINATE)?;
    let normal = table.triple("normal", POINT, &COMPONENT)?;
    let point = point.ok_or_else(|| table.missing("point", POINT))?;
    let normal = normal.ok_or_else(|| table.missing("normal", POINT))?;
    let material = body_material(&table, names, materials, memory)?;
    Ok(Plane { point, normal, material })
}

/// The keys of a body: its own two, `material`, and a material's keys.
fn body_keys([first, second]: [&'static str; 2]) -> [&'static str; 8] {
    let [color, diffuse, specular, shininess, reflect] = MATERIAL_KEYS;
    [first, second, "material", color, diffuse, specular, shininess, reflect]
}

/// Reads a body's material: stated inline, which adds a material, or named, never both.
fn body_material(
    table: &Table<'_>,
    names: &mut Names,
    materials: &mut Materials,
    memory: &mut Memory,
) -> Result<MaterialId, Problem> {
    if let Some((found @ Value::Table(_), trail)) = table.get("material") {
        let keys = MATERIAL_KEYS.join(", ");
        let allowed =
            format!("{MATERIAL_NAME}; without one, {keys} stand beside the body's own keys");
        return Err(Fault::new(trail, found.describe(), allowed).into());
    }
    let Some(name) = table.text("material", MATERIAL_NAME)? else {
        let words = "[r, g, b] here, or `material` with the name of one of the materials";
        return push_material(material(table, words)?, materials, memory);
    };
    if let Some(key) = MATERIAL_KEYS.into_iter().find(|key| table.get(key).is_some()) {
        let allowed = "either the name of a material or a material's keys inline, not both";
        return Err(Fault::key(
            table.trail.key(key),
            format!("both `{key}` and `material`"),
            allowed,
        )
        .into());
    }
    Ok(names.named(name, materials, memory)?.id)
}

/// Reads the keys of a material, in a table of its own or inline in a body.
fn material(table: &Table<'_>, color_allowed: &str) -> Result<Material, Fault> {
    let color = table.triple("color", RGB, &AMOUNT)?;
    let default = Material::matt(color.ok_or_else(|| table.missing("color", color_allowed))?);
    Ok(Material {
        diffuse: table.number("diffuse", &AMOUNT)?.unwrap_or(default.diffuse),
        specular: table.number("specular", &SPECULAR)?.unwrap_or(default.specular),
        shininess: table.number("shininess", &AMOUNT)?.unwrap_or(default.shininess),
        reflect: table.number("reflect", &MIRROR)?,
        ..default
    })
}
