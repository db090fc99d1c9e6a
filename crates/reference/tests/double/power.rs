//! The highlight's power in f64 against arbitrary precision: the bounds that its head states.

use catoptric_reference::double::power;
use catoptric_scene::{Compiled, Draft, Material, Power, Scene, Sphere};
use dashu_float::{FBig, round::mode::HalfEven};

type Number = FBig<HalfEven, 2>;

/// Steps over the results from 1 down to the cut.
const STEPS: u32 = 500;

/// The exponent as a scene's highlight has it.
fn compiled(shininess: f64) -> Power<f64> {
    let mut draft = Draft::default();
    let material = Material { shininess, ..Material::matt([1.0; 3]) };
    draft.spheres.push(Sphere {
        center: [0.0, 0.0, -5.0],
        radius: 1.0,
        material: draft.materials.add(material),
    });
    Compiled::of(&Scene::new(draft).expect("valid")).materials[0].power
}

fn exact(x: f64, p: f64) -> f64 {
    let number = |x: f64| Number::try_from(x).expect("finite").with_precision(160).value();
    (number(x).ln() * number(p)).exp().to_f64().value()
}

/// The largest relative error where the result is above 1e-3, and anywhere.
fn errors(p: f64) -> [f64; 2] {
    let [mut large, mut any] = [0.0_f64; 2];
    for step in 0..STEPS {
        let exponent = -59.9 * (f64::from(step) + 0.5) / f64::from(STEPS);
        let x = (exponent / p).exp2();
        let expected = exact(x, p);
        let error = ((power(x, compiled(p)) - expected) / expected).abs();
        any = any.max(error);
        if expected > 1e-3 {
            large = large.max(error);
        }
    }
    [large, any]
}

#[test]
fn any_power() {
    for p in [0.3, 0.5, 2.5, 7.25, 20.5, 100.5, 1025.0, 1e4 + 0.5, 1e6] {
        let worst = errors(p);
        assert!(worst[0] < 2e-15 && worst[1] < 1.5e-14, "{p}: {worst:?}");
        assert!(worst[1] > 1e-16, "{p}: {worst:?}");
    }
}

#[test]
fn whole_powers() {
    for p in [1.0, 2.0, 3.0, 20.0, 63.0, 200.0, 1024.0] {
        let [_, any] = errors(p);
        assert!(any < p / 2.0 * f64::EPSILON, "{p}: {any:e}");
    }
}

#[test]
fn what_is_below_the_cut_is_black() {
    for p in [0.3_f64, 1.0, 20.0, 20.5, 1e6] {
        let cut = (-60.0 / p).exp2();
        assert_eq!(power(cut * (1.0 - 1e-15), compiled(p)), 0.0, "{p}");
        assert!(power(cut * (1.0 + 1e-15), compiled(p)) > 8.6e-19, "{p}");
        assert_eq!(power(f64::NAN, compiled(p)), 0.0, "{p}");
        assert_eq!(power(1.0 + 1e-15, compiled(p)), 1.0, "{p}");
    }
    assert_eq!(power(0.0, compiled(0.0)), 1.0);
}
