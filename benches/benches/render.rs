//! Whole pictures: the recursion and the engine on 1 and 2 threads, as reflections go deeper.
//!
//! Every picture is checked bit for bit before it is timed and after.

use std::time::Duration;

use catoptric_benches::runner::Runner;
use catoptric_benches::scenes::{corridor, flake, workshop};
use catoptric_benches::subject::Subject;
use catoptric_benches::test_mode;
use catoptric_core::Isa;
use catoptric_scene::Draft;
use catoptric_tests::scenes::sized;
use criterion::{BenchmarkId, Criterion, Throughput};

/// Columns and rows of most pictures.
const SIZE: (u32, u32) = (640, 360);

/// Columns and rows of the headline.
const HEADLINE: (u32, u32) = (1920, 1080);

/// Columns and rows where nothing is measured; not a multiple of eight.
const TEST_SIZE: (u32, u32) = (61, 34);

/// Reflections followed.
const DEPTHS: [u32; 5] = [0, 1, 5, 16, 64];

/// The depth of the headline, and the one at which the portable path is timed too.
const USUAL_DEPTH: u32 = 5;

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .nresamples(20_000)
        .configure_from_args();
    for (name, draft) in [("workshop", workshop()), ("corridor", corridor()), ("flake", flake())] {
        group(&mut criterion, name, &draft, SIZE, &DEPTHS);
    }
    group(&mut criterion, "workshop", &workshop(), HEADLINE, &[USUAL_DEPTH]);
    criterion.final_summary();
}

/// One scene at one size; throughput is in rays of all kinds.
fn group(criterion: &mut Criterion, name: &str, draft: &Draft, size: (u32, u32), depths: &[u32]) {
    let title = format!("render/{name}-{}x{}", size.0, size.1);
    let (width, height) = if test_mode::is_on() { TEST_SIZE } else { size };
    let mut group = criterion.benchmark_group(&title);
    for &depth in depths {
        let scene = sized(draft, width, height, depth);
        let subject = Subject::checked(&format!("{title} depth {depth}"), &scene);
        group.throughput(Throughput::Elements(subject.rays()));
        for runner in runners(depth) {
            let id = BenchmarkId::new(runner.to_string(), depth);
            let mut film = subject.film();
            group.bench_function(id, |bencher| {
                bencher.iter_custom(|times| runner.time(&subject, &mut film, times));
                subject.confirm(&film);
            });
        }
    }
    group.finish();
}

/// Who is timed at that depth.
fn runners(depth: u32) -> Vec<Runner> {
    let best = Isa::detected();
    let mut runners = vec![
        Runner::recursion(1),
        Runner::recursion(2),
        Runner::engine(best, 1),
        Runner::engine(best, 2),
    ];
    if depth == USUAL_DEPTH && best != Isa::Portable {
        runners.push(Runner::engine(Isa::Portable, 1));
    }
    runners
}
