//! The condition map.

use catoptric_report::Cell;
use catoptric_scene::{Image, Material, Plane, View};
use catoptric_study::formula::U;
use catoptric_study::stability::condition::{
    Condition, FACTOR, Foretold, REACH, condition, foretold, pictures, table,
};

use super::scenes::{matt, scene, seen};

/// A wall at z = -1 lit from the eye has the colour 0.8 |d_z| = 0.8 cos θ, whose derivative by
/// the direction is 0.8 sin θ.
#[test]
fn the_derivative_is_that_of_the_closed_form() {
    let mut draft = seen([9, 7], 100.0, [0.0; 3], &[]);
    let material = Material::matt([0.8, 0.7, 0.6]);
    let material = draft.materials.add(material);
    draft.planes = vec![Plane { point: [0.3, 0.1, -1.0], normal: [0.0, 0.0, 2.0], material }];
    // The same picture whichever way the camera stands.
    draft.camera.up = [0.3, 1.0, 0.0];
    let scene = scene(draft);
    let view = View::whole(&scene);
    let map = condition(&scene, &view).expect("shallow");
    for (index, value) in map.amplified.iter().enumerate() {
        let (column, row) = (index as f64 % 9.0 - 4.0, (index / 9) as f64 - 3.0);
        // Pixels are square, 2 tan 50°/7 wide.
        let off = column.hypot(row) * 2.0 * 50.0_f64.to_radians().tan() / 7.0;
        let sine = off / off.hypot(1.0);
        assert!((value - 0.8 * sine * U).abs() < 1e-5 * U, "pixel {index}: {value}");
        // Linear as far as it reaches, in one of two directions across.
        let (least, most) = (0.7 * REACH * value, 1.01 * REACH * value + 1e-13);
        assert!((least..=most).contains(&map.moved[index]), "pixel {index}");
    }
}

/// Pixels 1 u apart, looking past a bright ball of radius 1: each step across the rim shows it
/// to the four pixels on either side, as a full step, and the derivative does not.
#[test]
fn edges_within_reach_are_seen_and_no_others() {
    let ball = matt([1.0, 0.0, -7.0], 1.0);
    let mut draft = seen([32, 1], 1.0, [0.0; 3], &[ball]);
    draft.remake_materials(|material| material.color = [1.0; 3]);
    draft.render.ambient = [0.5; 3];
    draft.lights.clear();
    // The left tangent from the eye: at the angle of the centre less asin(r/|c|), which is 0
    // where the ball touches the line ahead ... for |c| and r in a right angle.
    let distance = 50.0_f64.sqrt();
    let angle = (1.0 / 7.0_f64).atan() - (1.0 / distance).asin();
    draft.camera.look_at = [angle.sin(), 0.0, -angle.cos()];
    draft.camera.fov = (U / 2.0).atan().to_degrees() * 2.0;
    draft.image = Image { width: 32, height: 1, ..draft.image };
    let scene = scene(draft);
    let map = condition(&scene, &View::whole(&scene)).expect("shallow");
    let near: Vec<_> = (0..32).filter(|x| map.moved[*x] > 0.4).collect();
    assert!((6..=8).contains(&near.len()), "{near:?}");
    assert!(near.windows(2).all(|pair| pair[1] == pair[0] + 1), "{near:?}");
    let others = (0..32).filter(|x| !near.contains(x));
    assert!(others.into_iter().all(|x| map.moved[x] == 0.0));
    assert!(map.amplified.iter().all(|value| *value == 0.0));
}

#[test]
fn recall_and_precision_count_what_they_say() {
    let level = 1.0 / 255.0;
    let truth = [[0.5; 3]; 6];
    let off = |by: f64| [0.5, 0.5 + by, 0.5];
    let found =
        [off(0.0), off(3.0 * level), off(3.0 * level), off(3.0 * level), off(1e-4), [f64::NAN; 3]];
    // Fine; foretold; just not; not at all; flagged for nothing; NaN never is.
    let map = [0.0, 3.0 * level / FACTOR * 1.001, 2.9 * level / FACTOR, 0.0, level, 1.0];
    let sum = foretold(&map, &found, &truth);
    assert_eq!(sum, Foretold { wrong: 4, foretold: 1, flagged: 4, flagged_wrong: 3 });
    assert_eq!((sum.recall(), sum.precision()), (Some(0.25), Some(0.75)));
    let nothing = foretold(&[0.0], &truth[..1], &truth[..1]);
    assert_eq!((nothing.recall(), nothing.precision()), (None, None));
    let rows = table(&[("x".into(), "amplified", nothing)]).rows;
    assert_eq!(rows[0][4], Cell::from("no wrong pixel"));
}

#[test]
fn both_pictures_get_lighter_with_their_values() {
    let values: Vec<_> = (0..=90).map(|i| 10.0_f64.powf(f64::from(i) / 10.0 - 8.5)).collect();
    let dark = [0x44, 0x01, 0x54];
    let map = |amplified, moved| Condition { width: 91, height: 1, amplified, moved };
    let of = [(0, map(values.clone(), vec![0.0; 91])), (1, map(vec![0.0; 91], values))];
    for (which, map) in of {
        let pictures = pictures("x", &map, 2);
        let light = |[r, g, b]: &[u8; 3]| {
            0.2126 * f64::from(*r) + 0.7152 * f64::from(*g) + 0.0722 * f64::from(*b)
        };
        let shown = &pictures[which].pixels;
        assert!(shown.iter().map(light).is_sorted());
        assert_eq!((shown[0], shown[90]), (dark, [0xfd, 0xe7, 0x25]));
        assert_eq!(pictures[1 - which].pixels, [dark; 91], "the other map's");
    }
    let none =
        Condition { moved: vec![0.0, f64::NAN], amplified: vec![0.0; 2], width: 2, height: 1 };
    assert_eq!(pictures("x", &none, 1)[1].pixels, [dark; 2]);
}
