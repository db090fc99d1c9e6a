//! Materials, which bodies refer to by number.

use std::collections::BTreeMap;
use std::ops::{Index, IndexMut};

/// Phong's reflection model plus a mirror.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear RGB of the ambient and diffuse terms.
    pub color: [f64; 3],
    /// Diffuse factor kd; does not scale ambient.
    pub diffuse: f64,
    /// Specular factor ks, the highlight's.
    pub specular: f64,
    /// The highlight's exponent; x^0 is 1, also for x = 0.
    pub shininess: f64,
    /// Mirror factor k in [0, 1]; `None` takes `specular`.
    pub reflect: Option<f64>,
}

impl Material {
    /// A matt material of a colour: diffuse 1, no highlight, no mirror.
    #[must_use]
    pub fn matt(color: [f64; 3]) -> Self {
        Self { color, diffuse: 1.0, specular: 0.0, shininess: 0.0, reflect: None }
    }

    /// The mirror factor k: `reflect` where given, else `specular`.
    #[must_use]
    pub fn mirror(&self) -> f64 {
        self.reflect.unwrap_or(self.specular)
    }
}

/// Number of a material in one draft's [`Materials`].
///
/// An id means nothing to another draft. Validation refuses one that a draft does not have.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub struct MaterialId(u32);

impl MaterialId {
    /// Place in the order in which materials were added, from 0.
    #[must_use]
    pub fn index(self) -> usize {
        self.0 as usize
    }

    /// The id of a place in that order.
    pub(crate) fn at(index: usize) -> Self {
        Self(u32::try_from(index).expect("fewer than 2^32 materials fit in memory"))
    }
}

/// A draft's materials, some of them with names.
///
/// A name is what files call a material; a body whose material has none states it inline.
/// `materials[id]` is the material itself. To change it is to change every body that has it; to
/// change one body, add a material and give its id to the body.
///
/// ```
/// use catoptric_scene::{Draft, Material, Sphere};
///
/// let mut draft = Draft::default();
/// let red = draft.materials.add_named("red", Material::matt([1.0, 0.0, 0.0]));
/// draft.spheres.push(Sphere { center: [0.0, 0.0, -5.0], radius: 1.0, material: red });
/// draft.materials[red].reflect = Some(0.5);
/// assert_eq!(draft.materials.name(red), Some("red"));
/// ```
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Materials {
    stated: Vec<Material>,
    names: BTreeMap<MaterialId, String>,
}

impl Materials {
    /// Adds a material without a name.
    pub fn add(&mut self, material: Material) -> MaterialId {
        self.stated.push(material);
        MaterialId::at(self.stated.len() - 1)
    }

    /// Adds a material with a name. Validation refuses a name that two materials have.
    pub fn add_named(&mut self, name: impl Into<String>, material: Material) -> MaterialId {
        let id = self.add(material);
        self.set_name(id, name.into());
        id
    }

    /// Gives a name to a material that is there.
    pub(crate) fn set_name(&mut self, id: MaterialId, name: String) {
        self.names.insert(id, name);
    }

    /// The material, unless the id is another draft's.
    #[must_use]
    pub fn get(&self, id: MaterialId) -> Option<&Material> {
        self.stated.get(id.index())
    }

    /// The name of a material, if it has one.
    #[must_use]
    pub fn name(&self, id: MaterialId) -> Option<&str> {
        self.names.get(&id).map(String::as_str)
    }

    /// How many materials there are, whether or not a body has them.
    #[must_use]
    pub fn len(&self) -> usize {
        self.stated.len()
    }

    /// Whether there are no materials.
    #[must_use]
    pub fn is_empty(&self) -> bool {
        self.stated.is_empty()
    }

    /// All materials with their ids, in the order in which they were added.
    pub fn iter(&self) -> impl Iterator<Item = (MaterialId, &Material)> {
        self.stated.iter().enumerate().map(|(index, material)| (MaterialId::at(index), material))
    }

    /// All materials, for changing them.
    pub fn iter_mut(&mut self) -> impl Iterator<Item = &mut Material> {
        self.stated.iter_mut()
    }

    /// Materials that have a name, in the order in which they were added.
    pub fn named(&self) -> impl Iterator<Item = (&str, &Material)> {
        self.names.iter().map(|(&id, name)| (name.as_str(), &self[id]))
    }

    /// Bytes that the list takes, names not counted.
    #[must_use]
    pub fn bytes(&self) -> usize {
        self.stated.capacity() * size_of::<Material>()
    }

    /// The list itself, for readers that count its memory.
    pub(crate) fn stated_mut(&mut self) -> &mut Vec<Material> {
        &mut self.stated
    }
}

impl Index<MaterialId> for Materials {
    type Output = Material;

    /// # Panics
    /// If the id is another draft's.
    fn index(&self, id: MaterialId) -> &Material {
        &self.stated[id.index()]
    }
}

impl IndexMut<MaterialId> for Materials {
    /// # Panics
    /// If the id is another draft's.
    fn index_mut(&mut self, id: MaterialId) -> &mut Material {
        &mut self.stated[id.index()]
    }
}
