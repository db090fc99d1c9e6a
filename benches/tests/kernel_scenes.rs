//! The scenes of the kernels are what they say.

use catoptric_benches::kernels;
use catoptric_scene::{Compiled, Grid, View};
use catoptric_tests::identity::{assert_identical, recursive};
use catoptric_tests::scenes::sized;

#[test]
fn every_form_is_compiled_to_what_it_is_called() {
    for form in kernels::forms() {
        let scene = sized(&form.draft, 9, 9, 0);
        let primitives = Compiled::new(&scene).primitives;
        assert_eq!(primitives.len(), kernels::PRIMITIVES as usize, "{}", form.name);
        assert!(primitives.iter().all(|p| (form.is)(&p.shape)), "{}", form.name);
        assert_identical(form.name, &scene);
    }
}

/// All pixels do the same: every eye ray hits, and is lit where there is a lamp.
#[test]
fn every_pixel_of_a_shading_scene_does_the_step() {
    for (name, draft) in kernels::shading() {
        let scene = sized(&draft, 13, 13, draft.render.max_depth);
        assert_identical(name, &scene);
        let grid = Grid::new(&View::whole(&scene));
        let (_, counts) = recursive(&Compiled::new(&scene), &grid);
        let full = 13 * 13;
        let hits = if name == "empty" { 0 } else { full };
        let shadow = if scene.lights.is_empty() { 0 } else { full };
        let reflection = if name == "mirror" { full } else { 0 };
        assert_eq!(counts.primary(), full, "{name}");
        assert_eq!(counts.depths[0].hits, hits, "{name}");
        assert_eq!(counts.shadow(), shadow, "{name}");
        assert_eq!(counts.reflection(), reflection, "{name}");
    }
}
