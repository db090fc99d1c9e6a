//! The history of the speed-up: `history record [FILE]` measures and adds one line a scene,
//! `history check [FILE]` judges the last line of each scene.
//!
//! FILE is `benches/history.csv` unless given. Exit codes: 0 done, also where nothing could be
//! judged; 1 a line is worse than the noise; 2 wrong use, or a file that cannot be read or
//! written.

use std::env;
use std::path::{Path, PathBuf};
use std::process::ExitCode;
use std::time::SystemTime;

use catoptric_benches::history::entry::plain;
use catoptric_benches::history::measure::{self, Occasion, THREADS};
use catoptric_benches::history::rule::{self, Verdict};
use catoptric_benches::history::{commit, table};
use catoptric_core::Isa;
use catoptric_report::occasion;
use catoptric_tests::scenes::root;

const USAGE: &str = "usage: history record [FILE] | history check [FILE]";

fn main() -> ExitCode {
    let arguments: Vec<String> = env::args().skip(1).collect();
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let usual = || root().join("benches/history.csv");
    let result = match arguments[..] {
        ["record"] => record(&usual()),
        ["record", file] => record(&PathBuf::from(file)),
        ["check"] => check(&usual()),
        ["check", file] => check(&PathBuf::from(file)),
        _ => Err(USAGE.to_owned()),
    };
    result.unwrap_or_else(|message| {
        eprintln!("history: {message}");
        ExitCode::from(2)
    })
}

/// Measures every scene, then adds all lines at once.
fn record(path: &Path) -> Result<ExitCode, String> {
    if cfg!(debug_assertions) {
        return Err("a debug build is not recorded: use `cargo run --release`".to_owned());
    }
    let processors = std::thread::available_parallelism().map_or(1, usize::from);
    if processors < THREADS {
        return Err(format!("{THREADS} threads need {THREADS} processors, this has {processors}"));
    }
    // A file that cannot be added to is found before the measuring, not after.
    table::read(path).map_err(|error| error.to_string())?;
    let occasion = Occasion {
        date: occasion::iso8601(SystemTime::now()),
        commit: commit::of(&root()),
        processor: plain(&occasion::processor()),
        isa: Isa::detected(),
    };
    let mut entries = Vec::new();
    for (name, scene) in measure::scenes() {
        let entry = measure::entry(&occasion, name, &scene);
        println!(
            "{name} {} depth {}: {:.2}x over 1 thread, {:.2}x over {THREADS} (medians; spread \
             {:.1}%), {:.2} ns a ray, {} rounds",
            entry.size,
            entry.depth,
            entry.over_one_median,
            entry.over_same_median,
            100.0 * entry.over_same_spread,
            entry.ns_per_ray_median,
            entry.rounds
        );
        entries.push(entry);
    }
    table::append(path, &entries).map_err(|error| error.to_string())?;
    println!("{} lines added to {}", entries.len(), path.display());
    Ok(ExitCode::SUCCESS)
}

/// Prints a verdict a scene.
fn check(path: &Path) -> Result<ExitCode, String> {
    let history = table::read(path).map_err(|error| error.to_string())?;
    if history.is_empty() {
        println!("nothing to check: {} has no lines yet", path.display());
    }
    let mut worse = false;
    for (line, verdict) in rule::judge_all(&history) {
        println!(
            "{} {} depth {}, {} threads, {} {}, commit {}: {:.2}x min, {:.2}x median: {verdict}",
            line.scene,
            line.size,
            line.depth,
            line.threads,
            line.processor,
            line.isa,
            line.commit,
            line.over_same_min,
            line.over_same_median
        );
        worse |= matches!(verdict, Verdict::Worse(_));
    }
    Ok(if worse { ExitCode::FAILURE } else { ExitCode::SUCCESS })
}
