//! Tests of the history, of the kernels' scenes and of what is timed, in one binary.

mod commit;
mod kernel_scenes;
mod rule;
mod statistics;
mod subject;
mod table;

use catoptric_benches::history::entry::Entry;

/// A valid line of the workshop; every field differs from every other.
fn line() -> Entry {
    Entry {
        date: "2026-01-31T10:20:30Z".into(),
        commit: "abc1234+".into(),
        processor: "A Processor 9000".into(),
        isa: "avx2".into(),
        threads: 2,
        scene: "workshop".into(),
        size: "1920x1080".into(),
        depth: 5,
        rays: 4_000_000,
        rounds: 25,
        over_one_min: 21.5,
        over_one_median: 20.25,
        over_same_min: 10.5,
        over_same_median: 10.0,
        over_same_spread: 0.0125,
        ns_per_ray_min: 3.5,
        ns_per_ray_median: 3.75,
    }
}
