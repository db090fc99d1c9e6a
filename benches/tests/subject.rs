//! What is timed is checked.

use catoptric_benches::runner::Runner;
use catoptric_benches::scenes::workshop;
use catoptric_benches::subject::Subject;
use catoptric_core::Isa;
use catoptric_tests::scenes::sized;

fn subject() -> Subject {
    Subject::checked("workshop", &sized(&workshop(), 19, 11, 5))
}

#[test]
fn every_runner_leaves_the_recursions_picture() {
    let subject = subject();
    for threads in [1, 2] {
        for runner in [
            Runner::recursion(threads),
            Runner::engine(Isa::Portable, threads),
            Runner::engine(Isa::detected(), threads),
        ] {
            let mut film = subject.film();
            let once = runner.time(&subject, &mut film, 1);
            assert!(!once.is_zero(), "{runner}");
            subject.confirm(&film);
        }
    }
}

#[test]
#[should_panic(expected = "workshop: the timed picture is not the recursion's")]
fn a_film_that_nothing_was_rendered_on_is_refused() {
    let subject = subject();
    subject.confirm(&subject.film());
}

#[test]
#[should_panic(expected = "the timed picture is not the recursion's")]
fn one_bit_is_enough() {
    let subject = subject();
    let mut film = subject.film();
    let _ = Runner::recursion(1).time(&subject, &mut film, 1);
    let last = film.pixels_mut().last_mut().expect("a pixel");
    last[2] = f32::from_bits(last[2].to_bits() ^ 1);
    subject.confirm(&film);
}

/// Eye, reflection and shadow rays, each counted once.
#[test]
fn rays_are_of_all_kinds() {
    let at = |depth| Subject::checked("workshop", &sized(&workshop(), 19, 11, depth)).rays();
    assert!(at(0) > 19 * 11, "shadow rays beside the eye rays");
    assert!(at(1) > at(0), "reflections");
    assert_eq!(subject().eye_rays(), 19 * 11);
}
