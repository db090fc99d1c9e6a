//! Single steps of the tracing on one thread, timed through scenes in which they dominate.
//!
//! Throughput is in intersections (`forms`), eye rays (`shading`) or calls (`power`); every
//! picture is checked bit for bit before it is timed and after.

use std::hint::black_box;
use std::time::Duration;

use catoptric_benches::kernels::{self, PRIMITIVES};
use catoptric_benches::runner::Runner;
use catoptric_benches::subject::Subject;
use catoptric_benches::test_mode;
use catoptric_core::Isa;
use catoptric_reference::power;
use catoptric_scene::{Compiled, Draft};
use catoptric_tests::scenes::sized;
use criterion::measurement::WallTime;
use criterion::{BenchmarkGroup, BenchmarkId, Criterion, Throughput};

/// Columns and rows.
const SIDE: u32 = 256;

/// Columns and rows where nothing is measured; not a multiple of eight.
const TEST_SIDE: u32 = 21;

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(200))
        .measurement_time(Duration::from_millis(700))
        .nresamples(20_000)
        .configure_from_args();
    forms(&mut criterion);
    shading(&mut criterion);
    powers(&mut criterion);
    criterion.final_summary();
}

/// Eye rays against primitives of one form.
fn forms(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kernels/forms");
    for form in kernels::forms() {
        let subject = subject(form.name, &form.draft);
        let shapes = subject.compiled.primitives.iter().map(|p| &p.shape);
        assert!(shapes.clone().all(form.is), "{}: compiled to another form", form.name);
        assert_eq!(shapes.count(), PRIMITIVES as usize, "{}", form.name);
        group.throughput(Throughput::Elements(subject.eye_rays() * u64::from(PRIMITIVES)));
        time(&mut group, &subject);
    }
    group.finish();
}

/// One ball that fills the view.
fn shading(criterion: &mut Criterion) {
    let mut group = criterion.benchmark_group("kernels/shading");
    for (name, draft) in kernels::shading() {
        let subject = subject(name, &draft);
        group.throughput(Throughput::Elements(subject.eye_rays()));
        time(&mut group, &subject);
    }
    group.finish();
}

/// The recursion's power by itself, on bases above the cut of every exponent.
fn powers(criterion: &mut Criterion) {
    let bases: Vec<f32> = (1..=1024u16).map(|i| 0.85 + 0.15 * f32::from(i) / 1024.0).collect();
    let mut group = criterion.benchmark_group("kernels/power");
    group.throughput(Throughput::Elements(bases.len() as u64));
    for (name, draft) in kernels::shading() {
        let Some(exponent) = name.strip_prefix("highlight-") else { continue };
        let p = Compiled::new(&sized(&draft, 1, 1, 0)).materials[0].power;
        group.bench_function(BenchmarkId::new("recursion", exponent), |bencher| {
            bencher.iter(|| {
                for &x in &bases {
                    black_box(power(black_box(x), p));
                }
            });
        });
    }
    group.finish();
}

/// The checked picture, at the depth that the draft states.
fn subject(name: &str, draft: &Draft) -> Subject {
    let side = if test_mode::is_on() { TEST_SIDE } else { SIDE };
    Subject::checked(name, &sized(draft, side, side, draft.render.max_depth))
}

/// The recursion and each instruction set of the engine, on one thread.
fn time(group: &mut BenchmarkGroup<'_, WallTime>, subject: &Subject) {
    let isas = Isa::ALL.into_iter().filter(|&isa| isa <= Isa::detected());
    let engines = isas.map(|isa| Runner::engine(isa, 1));
    for runner in std::iter::once(Runner::recursion(1)).chain(engines) {
        let mut film = subject.film();
        group.bench_function(BenchmarkId::new(runner.to_string(), &subject.name), |bencher| {
            bencher.iter_custom(|times| runner.time(subject, &mut film, times));
            subject.confirm(&film);
        });
    }
}
