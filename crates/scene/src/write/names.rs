//! Names that a written file gives to materials.

use std::collections::{BTreeMap, BTreeSet};

use crate::{Body, Draft, MaterialId};

/// Names of materials, in the order in which they are written: the draft's own names, then m0, m1,
/// ... for unnamed materials that several bodies share. Other materials stand inline.
pub(super) struct Names {
    pub(super) written: Vec<(MaterialId, String)>,
    places: BTreeMap<MaterialId, usize>,
}

impl Names {
    pub(super) fn of(draft: &Draft) -> Self {
        let materials = &draft.materials;
        let taken: BTreeSet<&str> = materials.named().map(|(name, _)| name).collect();
        let mut free = (0..).map(|number| format!("m{number}")).filter(|m| !taken.contains(&**m));
        let own = materials.iter().filter_map(|(id, _)| Some((id, materials.name(id)?.to_owned())));
        let mut written: Vec<_> = own.collect();
        let mut places: BTreeMap<_, _> = written.iter().map(|&(id, _)| id).zip(0..).collect();

        // Bodies that share a material without a name, in their order.
        let mut bodies = vec![0_u32; materials.len()];
        draft.bodies().map(Body::material).for_each(|id| bodies[id.index()] += 1);
        for id in draft.bodies().map(Body::material).filter(|id| bodies[id.index()] > 1) {
            places.entry(id).or_insert_with(|| {
                written.push((id, free.next().expect("numbers do not end")));
                written.len() - 1
            });
        }
        Self { written, places }
    }

    /// The name of a material; `None` where it stands inline.
    pub(super) fn of_material(&self, id: MaterialId) -> Option<&str> {
        self.places.get(&id).map(|&place| self.written[place].1.as_str())
    }
}
