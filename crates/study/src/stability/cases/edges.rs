//! The ends of ranges, and odd places for the eye and the lights.

use catoptric_reference::truth::{Precision, Truth};
use catoptric_scene::{Draft, Light, Material, Scene, Sphere, View};

use super::super::finding::{Effort, Finding, Findings};
use super::super::generic::{PLACE, along, placed};
use super::scenes::{empty_room, glossy, sized, workshop};
use crate::formula::Formula;
use crate::light::LightBounds;
use crate::metrics::{Metrics, difference};

pub(crate) fn run(_: Effort) -> Vec<Finding> {
    let mut findings = Findings::new();
    for (case, tested, draft) in scenes() {
        let scene = Formula::RobustF32.scene(&draft);
        let truth = truth_of(&scene);
        let mut dark = draft.clone();
        dark.lights.clear();
        let dark = truth_of(&Formula::RobustF32.scene(&dark));
        let lit = truth.iter().zip(&dark).filter(|(a, b)| a != b).count();
        // A case of lights in which no light reaches anything would test nothing.
        let unlit = lit == 0 && !draft.lights.is_empty() && !draft.spheres.is_empty();
        for formula in Formula::ALL {
            let found = formula.picture(&draft).expect("paths that end soon");
            let metrics = Metrics::of(&found, &truth);
            let outside = outside(&found, brightest(&formula.scene(&draft)));
            // In f64 an error far below a level is wrong already.
            let off = match formula {
                Formula::RobustF64 => {
                    found.iter().zip(&truth).filter(|(a, b)| difference(a, b) > 1e-9).count() as u64
                }
                _ => metrics.off_by_more,
            };
            let sentence = format!(
                "Largest error {:.1e}; {outside} pixels not in [0, B]; lamps light {lit} pixels.",
                metrics.max
            );
            let wrong = (off + metrics.not_finite + outside) as f64;
            let wrong = if unlit { f64::INFINITY } else { wrong };
            findings.push(case, formula, tested, wrong, sentence);
        }
    }
    findings.done()
}

fn truth_of(scene: &Scene) -> Vec<[f64; 3]> {
    let truth = Truth::new(scene, Precision::DoubleDouble);
    truth.render(&View::whole(scene)).expect("paths that end soon").pixels
}

/// B: the most that a pixel can hold, by channel.
pub(crate) fn brightest(scene: &Scene) -> [f64; 3] {
    let of_channel = |c| LightBounds::of_channel(scene, c).brightest(scene.render.max_depth);
    std::array::from_fn(of_channel)
}

/// Pixels that are not in [0, B]; B is the sum of a series, so f32 may round above it.
pub(crate) fn outside(picture: &[[f64; 3]], most: [f64; 3]) -> u64 {
    let inside = |pixel: &[f64; 3]| {
        pixel.iter().zip(most).all(|(x, most)| (0.0..=most * (1.0 + 1e-5) + 1e-44).contains(x))
    };
    picture.iter().filter(|pixel| !inside(pixel)).count() as u64
}

/// A glossy sphere of radius 2 before the eye, and a light.
fn ball() -> Draft {
    let mut draft = Draft::default();
    draft.camera.look_at = [0.11, -0.07, -1.0];
    draft.camera.fov = 50.0;
    draft.render.background = [0.2, 0.3, 0.4];
    draft.lights.push(Light { position: [3.1, 4.7, 1.3], intensity: [0.9; 3] });
    draft.spheres.push(Sphere {
        center: [0.23, 0.17, -5.3],
        radius: 2.0,
        material: draft.materials.add(glossy(0.5)),
    });
    let center = [-0.93, -0.87, -3.91];
    draft.spheres.push(Sphere { center, radius: 0.61, material: draft.materials.add(glossy(0.3)) });
    sized(draft, 48, 36, 8)
}

/// The sphere around the eye.
fn around(offset: [f64; 3]) -> Draft {
    let mut draft = ball();
    draft.spheres.truncate(1);
    draft.spheres[0].center = offset;
    draft.lights[0].position = along(offset, [0.31, 0.42, -0.27], 1.0);
    draft
}

fn scenes() -> Vec<(&'static str, &'static str, Draft)> {
    let with = |change: fn(&mut Draft)| {
        let mut draft = ball();
        change(&mut draft);
        placed(&draft)
    };
    // Neat numbers: the eye or the light is on the sphere exactly, 3^2 + 4^2 = 5^2.
    let on_surface = |toward: f64| {
        let mut draft = ball();
        let center = [0.0, -4.0, -3.0];
        draft.spheres.clear();
        draft.spheres.push(Sphere {
            center,
            radius: 5.0,
            material: draft.materials.add(glossy(0.5)),
        });
        // Something to see and to light, outwards.
        let center = [0.57, 5.03, 4.11];
        draft.spheres.push(Sphere {
            center,
            radius: 1.0,
            material: draft.materials.add(glossy(0.3)),
        });
        draft.camera.look_at = [0.3, 4.0 * toward, 3.0 * toward];
        draft.camera.up = [1.0, 0.0, 0.0];
        draft
    };
    // The light exactly on a sphere.
    let mut lamp_on = ball();
    (lamp_on.spheres[0].center, lamp_on.spheres[0].radius) = ([0.0, -4.0, -8.0], 5.0);
    lamp_on.lights[0].position = [0.0, 0.0, -5.0];
    lamp_on.spheres[1].center = [-1.13, 0.43, -4.31];
    // The light at the point that the middle pixel sees.
    let mut lamp_at_hit = ball();
    lamp_at_hit.spheres[0].center = [0.0, 0.0, -5.0];
    lamp_at_hit.lights[0].position = [0.0, 0.0, -3.0];
    // Nearer than that point, so that its light reaches something: the other sphere.
    lamp_at_hit.spheres[1].center = [-0.63, -0.47, -2.21];
    lamp_at_hit.spheres[1].radius = 0.31;
    lamp_at_hit.lights.push(ball().lights[0]);
    lamp_at_hit.camera.look_at = [0.0, 0.0, -1.0];
    let lamp_at_hit = sized(lamp_at_hit, 47, 35, 8);
    // First where the eye is, then where lights are, then the limits of depth and of content.
    vec![
        (
            "eye at the centre",
            "the eye at the centre of a mirror ball, k 0.5, 48x36, depth 8",
            placed(&around([0.0; 3])),
        ),
        (
            "eye inside",
            "the eye inside a mirror ball, off its centre",
            placed(&around([0.7, -0.9, 0.4])),
        ),
        (
            "eye close below the surface",
            "the eye inside a ball of radius 2, 2e-6 from its surface",
            placed(&around([0.0, 1.999_998, 0.0])),
        ),
        (
            "eye on the surface, outwards",
            "the eye exactly on a ball of radius 5, looking away",
            on_surface(1.0),
        ),
        (
            "eye on the surface, inwards",
            "the eye exactly on a ball of radius 5, looking at its centre",
            on_surface(-1.0),
        ),
        (
            "lamp inside a ball",
            "a lamp inside one of two mirror balls, which hides it, and another lamp",
            with(|d| d.lights.push(Light { position: [0.5, 0.9, -4.9], intensity: [0.7; 3] })),
        ),
        ("lamp on a ball", "a lamp exactly on a ball", lamp_on),
        (
            "lamp at the hit point",
            "a lamp exactly at the point that the middle pixel sees, and another lamp",
            lamp_at_hit,
        ),
        ("lamp at the eye", "a lamp at the eye", with(|d| d.lights[0].position = [0.0; 3])),
        ("depth 0", "two mirror balls, depth 0", with(|d| d.render.max_depth = 0)),
        ("depth 1", "two mirror balls, depth 1", with(|d| d.render.max_depth = 1)),
        (
            "depth 1 000 000",
            "the workshop's scene, ground k 0.3, 48x36, depth 1 000 000",
            placed(&workshop(48, 36, 1_000_000, 0.3)),
        ),
        ("no spheres", "nothing but background", with(|d| d.spheres.clear())),
        ("no lights", "two mirror balls without lamps", with(|d| d.lights.clear())),
        (
            "no mirrors",
            "two matt balls",
            with(|d| d.materials.iter_mut().for_each(|m| *m = Material::matt([0.7, 0.5, 0.3]))),
        ),
        ("k just below 1", "inside a mirror ball, k = 1 - 2^-24, depth 64", {
            let mut draft = placed(&empty_room(48, 36, 64, 1.0 - 1.0 / 16_777_216.0));
            draft.render.background = [1.0; 3];
            draft.render.ambient = [0.003; 3];
            draft.lights.push(Light { position: PLACE, intensity: [0.004; 3] });
            draft
        }),
    ]
}
