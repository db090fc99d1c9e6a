//! What a scene's own settings have to do with what is measured.

use catoptric_scene::{Numerics, Scene};

use super::enough::{Enough, enough};
use super::request::Request;
use crate::stability::paths::with_numerics;
use crate::tracer::Tracer;

/// What of a scene's own settings the sweeps do without, in words.
pub(super) fn left_out(own: &Scene) -> String {
    let weight = own.render.min_weight;
    if weight > 0.0 {
        format!(" The scene's own min_weight, {weight}, is left out of truth and of every sweep.")
    } else {
        String::new()
    }
}

/// Says which `max_depth` is enough for the scene with its own numerics and weight cut.
pub(super) fn enough_depths(own: &Scene, sized: &Scene, request: &Request) -> String {
    let Tracer::Packet(isa) = request.tracer else { return String::new() };
    let (numerics, weight) = (own.render.numerics, own.render.min_weight);
    let mut draft = sized.clone().into_draft();
    draft.render.min_weight = weight;
    let scene = with_numerics(&draft, numerics);
    let Ok(enough) = request.threads.most().install(|| enough(&scene, isa)) else {
        return String::new();
    };
    let Enough { same_bits, within_a_level, deepest_ray, .. } = enough;
    let cut = if weight > 0.0 {
        format!("with the scene's min_weight, {weight}")
    } else {
        "without a weight cut".to_owned()
    };
    let formulas = match numerics {
        Numerics::Robust => "robust",
        Numerics::Textbook => "textbook",
    };
    format!(
        " Of the f32 picture of that size, {formulas} formulas, {cut}: the deepest ray has {deepest_ray} \
         reflections, max_depth {same_bits} gives the same bits as any deeper, {within_a_level} \
         stays within one 8-bit level of it."
    )
}
