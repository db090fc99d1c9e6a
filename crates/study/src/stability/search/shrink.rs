//! A failing scene with nothing in it that the failure does not need.

use catoptric_scene::Draft;

/// Things are dropped one at a time, and settings made plain, while `fails` still holds.
///
/// The remaining scene fails, and without any one of its things it would not.
pub(super) fn shrunk(draft: &Draft, fails: impl Fn(&Draft) -> bool) -> Draft {
    let mut least = draft.clone();
    loop {
        let smaller =
            simpler(&least).into_iter().find(|smaller| *smaller != least && fails(smaller));
        match smaller {
            Some(smaller) => least = smaller,
            None => return least,
        }
    }
}

/// The draft with one thing less, or one thing plainer.
fn simpler(draft: &Draft) -> Vec<Draft> {
    let with = |change: &dyn Fn(&mut Draft)| {
        let mut draft = draft.clone();
        change(&mut draft);
        draft
    };
    let mut all = Vec::new();
    all.extend((0..draft.spheres.len()).map(|i| with(&|d| _ = d.spheres.remove(i))));
    all.extend((0..draft.planes.len()).map(|i| with(&|d| _ = d.planes.remove(i))));
    all.extend((0..draft.lights.len()).map(|i| with(&|d| _ = d.lights.remove(i))));
    // Each of these leaves a draft equal to itself at last, so that the loop ends.
    all.push(with(&|d| d.render.max_depth = d.render.max_depth.saturating_sub(1)));
    all.extend(
        (0..draft.spheres.len()).map(|i| with(&|d| plain(&mut d.materials[d.spheres[i].material]))),
    );
    all.extend(
        (0..draft.planes.len()).map(|i| with(&|d| plain(&mut d.materials[d.planes[i].material]))),
    );
    all
}

/// Without highlight, and without mirror where that does not do.
fn plain(material: &mut catoptric_scene::Material) {
    let mirror = material.mirror();
    if material.specular != 0.0 {
        (material.specular, material.shininess) = (0.0, 0.0);
        material.reflect = Some(mirror);
    } else {
        material.reflect = None;
    }
}
