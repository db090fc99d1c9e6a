//! Things that no ray meets: inside of the workshop's spheres, and outside of a closed room.

use catoptric_scene::family::Room;
use catoptric_scene::{Draft, Material, Plane, Sphere};

use super::super::super::finding::Findings;
use super::super::super::generic::{PLACE, along, placed, unit};
use super::super::scenes::{sized, workshop};
use super::engines::{both, differing};
use crate::formula::Formula;

/// One thing more at a time, from a thousandth to 1e12 large.
pub(super) fn run(findings: &mut Findings) {
    const CASE: &str = "unseen things";
    let tested = "the workshop's scene (80x60, depth 8, ground k 0.3), turned, with balls in its balls and its ground and a closed room with balls and planes outside, 1e-3 to 1e12 large; by both engines";
    let room = Room { balls: 3, ..Room::default() }.draft().expect("in range");
    let outside = room.spheres[0].radius;
    let room = sized(placed(&room), 80, 60, 8);
    // Spheres within spheres: nothing sees them from outside.
    let mut workshop = placed(&workshop(80, 60, 8, 0.3));
    let magenta = Material::matt([9.0, 0.0, 9.0]);
    let material = workshop.materials.add(magenta);
    let within = workshop.spheres.iter().flat_map(|sphere| {
        [0.5, 1e-2, 1e-4].map(|share| Sphere {
            center: sphere.center,
            radius: share * sphere.radius,
            material,
        })
    });
    let mut pairs: Vec<[Draft; 2]> = within
        .map(|sphere| {
            let mut more = workshop.clone();
            more.spheres.push(sphere);
            [workshop.clone(), more]
        })
        .collect();
    // Spheres and planes outside a closed room, of every size.
    for exponent in -3..=12 {
        let size = 10_f64.powf(f64::from(exponent));
        let way = unit(PLACE);
        let mut more = room.clone();
        let center = along(room.spheres[0].center, way, 1.1 * (outside + size) + 1.0);
        more.spheres.push(Sphere { center, radius: size, material: more.materials.add(magenta) });
        pairs.push([room.clone(), more.clone()]);
        let point = along(room.spheres[0].center, way, 1.1 * outside + size);
        more.planes.push(Plane { point, normal: way, material: more.materials.add(magenta) });
        pairs.push([room.clone(), more]);
    }
    for formula in Formula::ALL {
        // A picture must be the same to the bit with the thing and without it.
        let off =
            pairs.iter().map(|[once, more]| differing(&both(formula, once), &both(formula, more)));
        let off: Vec<usize> = off.collect();
        let changed = off.iter().filter(|pixels| **pixels > 0).count();
        let sentence = format!("{changed} of {} things change a pixel.", off.len());
        findings.push(CASE, formula, tested, off.iter().sum::<usize>() as f64, sentence);
    }
}
