//! How deep truth goes, and what it says beyond.

use std::thread;

use catoptric_reference::truth::{DEPTH_ALLOWED, STACK_BYTES, TooDeep, Truth};
use catoptric_scene::{Camera, Draft, Image, Scene, Sphere, View};

use super::scenes::{BOTH, mirror};

/// A closed mirror ball, one pixel.
fn ball(max_depth: u32) -> Scene {
    let mut draft = Draft {
        image: Image { width: 1, height: 1, ..Image::default() },
        camera: Camera { look_at: [0.3, 1.0, -4.0], ..Camera::default() },
        ..Draft::default()
    };
    let material = draft.materials.add(mirror(1.0));
    draft.spheres.push(Sphere { center: [1.0, 2.0, 3.0], radius: 10.0, material });
    draft.render.max_depth = max_depth;
    Scene::new(draft).expect("valid")
}

/// Ends the program if a level takes more than the stated bytes.
#[test]
fn the_stated_stack_carries_the_allowed_depth_and_no_more_is_followed() {
    let deep = || {
        for precision in BOTH {
            let scene = ball(DEPTH_ALLOWED);
            let truth = Truth::new(&scene, precision);
            let [red, ..] = truth.radiance(&View::whole(&scene), 0, 0).expect("just allowed");
            let expected = 0.1 * f64::from(DEPTH_ALLOWED + 1);
            assert!((red / expected - 1.0).abs() < 1e-11, "{red} is not {expected}");

            let scene = ball(u32::MAX);
            let truth = Truth::new(&scene, precision);
            let error = TooDeep { allowed: DEPTH_ALLOWED };
            assert_eq!(truth.radiance(&View::whole(&scene), 0, 0), Err(error));
            assert_eq!(truth.render(&View::whole(&scene)), Err(error));
        }
    };
    // `render` runs on rayon's threads, which need the stack too.
    let pool = rayon::ThreadPoolBuilder::new().num_threads(1).stack_size(STACK_BYTES);
    let pool = pool.build().expect("a pool");
    let caller = thread::Builder::new().stack_size(STACK_BYTES);
    let caller = caller.spawn(move || pool.install(deep)).expect("a thread");
    caller.join().expect("no failure on the deep thread");
}

#[test]
fn the_error_says_what_to_do() {
    let text = TooDeep { allowed: DEPTH_ALLOWED }.to_string();
    assert!(text.contains("100000") && text.contains("max_depth"), "{text}");
}
