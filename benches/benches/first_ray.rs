//! The time to the first ray: what is done once a picture, however few pixels it has, as balls grow
//! many. Each step apart: compiling the scene, planning, and a picture of one pixel by that plan.
//!
//! The pixel is checked bit for bit before it is timed and after.

use std::hint::black_box;
use std::time::{Duration, Instant};

use catoptric_benches::crowds::Crowd;
use catoptric_benches::subject::Subject;
use catoptric_benches::test_mode;
use catoptric_core::{Engine, Isa, Plan, Settings};
use catoptric_scene::Compiled;
use catoptric_tests::identity::pool;
use catoptric_tests::scenes::sized;
use criterion::{BenchmarkId, Criterion, Throughput};

/// Balls of each scene.
const BALLS: [u32; 6] = [10, 100, 1_000, 10_000, 100_000, 1_000_000];

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .nresamples(20_000)
        .configure_from_args();
    for crowd in Crowd::ALL {
        group(&mut criterion, crowd);
    }
    criterion.final_summary();
}

/// One way to place balls; throughput is in balls, so that a rate that stays is a cost that grows
/// with them and no faster.
fn group(criterion: &mut Criterion, crowd: Crowd) {
    let title = format!("first-ray/{}", crowd.name());
    let settings = Settings { isa: Isa::detected(), stack_limit: 1 << 30 };
    let mut group = criterion.benchmark_group(&title);
    for balls in BALLS.into_iter().take(if test_mode::is_on() { 3 } else { BALLS.len() }) {
        let scene = sized(&crowd.draft(balls), 1, 1, 0);
        let subject = Subject::checked(&format!("{title} of {balls}"), &scene);
        let (compiled, grid) = (&subject.compiled, &subject.grid);
        group.throughput(Throughput::Elements(balls.into()));
        group.bench_function(BenchmarkId::new("compile", balls), |bencher| {
            bencher.iter_with_large_drop(|| Compiled::new(black_box(&scene)));
        });
        group.bench_function(BenchmarkId::new("plan", balls), |bencher| {
            bencher.iter_with_large_drop(|| Plan::new(black_box(compiled), grid));
        });
        let (plan, mut film) = (Plan::new(compiled, grid), subject.film());
        let engine = Engine::new(compiled).with(settings);
        group.bench_function(BenchmarkId::new("pixel", balls), |bencher| {
            bencher.iter_custom(|times| {
                pool(1).install(|| {
                    let start = Instant::now();
                    for _ in 0..times {
                        black_box(engine)
                            .render_planned(&plan, &mut film)
                            .expect("no path is deep");
                    }
                    start.elapsed()
                })
            });
            subject.confirm(&film);
        });
    }
    group.finish();
}
