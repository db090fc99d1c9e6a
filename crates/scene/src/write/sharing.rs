//! Which materials several bodies share.

use std::collections::HashMap;

use crate::{Draft, Material};

/// A material's numbers as bits: what is written once must be the same to the bit.
type Bits = ([u64; 6], Option<u64>);

/// The materials that more than one body has, in the order of their first bodies.
pub(super) struct Sharing<'a> {
    shared: Vec<&'a Material>,
    index: HashMap<Bits, usize>,
}

impl<'a> Sharing<'a> {
    pub(super) fn of(draft: &'a Draft) -> Self {
        let spheres = draft.spheres.iter().map(|sphere| &sphere.material);
        let materials = spheres.chain(draft.planes.iter().map(|plane| &plane.material));
        let mut bodies: HashMap<Bits, usize> = HashMap::new();
        for material in materials.clone() {
            *bodies.entry(bits(material)).or_default() += 1;
        }
        let mut shared = Vec::new();
        let mut index = HashMap::new();
        for material in materials {
            let key = bits(material);
            if bodies[&key] > 1 && !index.contains_key(&key) {
                index.insert(key, shared.len());
                shared.push(material);
            }
        }
        Self { shared, index }
    }

    /// The name of a material, if it is shared.
    pub(super) fn name(&self, material: &Material) -> Option<String> {
        self.index.get(&bits(material)).map(|&index| name(index))
    }

    /// All shared materials with their names.
    pub(super) fn shared(&self) -> impl Iterator<Item = (String, &'a Material)> {
        self.shared.iter().enumerate().map(|(index, &material)| (name(index), material))
    }
}

fn name(index: usize) -> String {
    format!("m{index}")
}

fn bits(material: &Material) -> Bits {
    let &Material { color: [r, g, b], diffuse, specular, shininess, reflect } = material;
    let numbers = [r, g, b, diffuse, specular, shininess].map(f64::to_bits);
    (numbers, reflect.map(f64::to_bits))
}
