//! What each omission of a plan saves: the picture by its plan, with each omission not made in
//! turn, and with none made; on one thread.
//!
//! Every picture is checked bit for bit before it is timed and after.

use std::time::{Duration, Instant};

use catoptric_benches::scenes::{corridor, flake, workshop};
use catoptric_benches::subject::Subject;
use catoptric_benches::test_mode;
use catoptric_core::{Engine, Isa, Plan, Settings};
use catoptric_scene::{Draft, Material};
use catoptric_tests::identity::pool;
use catoptric_tests::scenes::{named, sized};
use criterion::Criterion;

fn main() {
    let mut criterion = Criterion::default()
        .sample_size(10)
        .warm_up_time(Duration::from_millis(300))
        .measurement_time(Duration::from_secs(1))
        .nresamples(20_000)
        .configure_from_args();
    group(&mut criterion, "workshop", &workshop(), 5);
    group(&mut criterion, "workshop-plain", &plain(workshop()), 5);
    group(&mut criterion, "flake", &flake(), 5);
    group(&mut criterion, "corridor", &corridor(), 16);
    for name in ["kissing", "planes", "coloured-lights"] {
        group(&mut criterion, name, &named(name), 8);
    }
    criterion.final_summary();
}

/// Without mirrors and highlights.
fn plain(mut draft: Draft) -> Draft {
    for sphere in &mut draft.spheres {
        let plain = draft.materials[sphere.material];
        let plain = Material { specular: 0.0, reflect: Some(0.0), ..plain };
        sphere.material = draft.materials.add(plain);
    }
    draft
}

fn group(criterion: &mut Criterion, name: &str, draft: &Draft, depth: u32) {
    let title = format!("omissions/{name}");
    let (width, height) = if test_mode::is_on() { (61, 34) } else { (640, 360) };
    let subject = Subject::checked(&title, &sized(draft, width, height, depth));
    let plan = Plan::new(&subject.compiled, &subject.grid);
    let mut plans = vec![("all-made".to_owned(), plan.clone())];
    for omission in plan.omissions().iter() {
        plans.push((format!("without-{}", omission.name()), plan.clone().without(omission)));
    }
    plans.push(("none-made".to_owned(), plan.clone().everything()));

    let settings = Settings { isa: Isa::detected(), stack_limit: 1 << 30 };
    let mut group = criterion.benchmark_group(&title);
    for (id, plan) in plans {
        let mut film = subject.film();
        group.bench_function(id, |bencher| {
            bencher.iter_custom(|times| {
                pool(1).install(|| {
                    let engine = Engine::new(&subject.compiled).with(settings);
                    let start = Instant::now();
                    for _ in 0..times {
                        engine
                            .render_planned(&plan, &mut film)
                            .expect("the engine's stack holds the path");
                    }
                    start.elapsed()
                })
            });
            subject.confirm(&film);
        });
    }
    group.finish();
}
