//! The place, time, machine and program with which a study was measured.

use std::fmt;
use std::time::SystemTime;

use chrono::{DateTime, SecondsFormat, Utc};
use serde::Serialize;

/// What a reader must know to compare figures.
#[derive(Clone, Debug, Serialize)]
pub struct Occasion {
    /// When the study began, UTC, `2026-01-31T23:59:59Z`.
    pub date: String,
    /// The version of this workspace.
    pub program: &'static str,
    /// The commit that was built, with `+` where the sources differed from it; `unknown`
    /// outside a repository.
    pub commit: &'static str,
    /// What the processor calls itself.
    pub processor: String,
    /// Processors that this process may run on.
    pub processors: usize,
    /// The packet engine's instruction set.
    pub isa: &'static str,
    /// Threads that traced, unless a row says otherwise.
    pub threads: usize,
    /// The command line.
    pub command: String,
}

impl Occasion {
    /// Here and now; `isa` is the name of the engine's instruction set.
    #[must_use]
    pub fn now(isa: &'static str, threads: usize, command: String) -> Self {
        Self {
            date: iso8601(SystemTime::now()),
            program: env!("CARGO_PKG_VERSION"),
            commit: env!("CATOPTRIC_COMMIT"),
            processor: processor(),
            processors: std::thread::available_parallelism().map_or(1, usize::from),
            isa,
            threads,
            command,
        }
    }
}

impl fmt::Display for Occasion {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Self { date, program, commit, processor, processors, isa, threads, command } = self;
        write!(
            f,
            "Made by `{command}`, {date}, version {program}, commit {commit}; {processor}, \
             {processors} processors, {isa}, {threads} threads."
        )
    }
}

/// A time as `2026-01-31T23:59:59Z`.
#[must_use]
pub fn iso8601(time: SystemTime) -> String {
    DateTime::<Utc>::from(time).to_rfc3339_opts(SecondsFormat::Secs, true)
}

/// The first model name of `/proc/cpuinfo`; elsewhere `unknown` and the architecture.
#[must_use]
pub fn processor() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    model_in(&text).unwrap_or_else(|| format!("unknown {}", std::env::consts::ARCH))
}

/// The value of the first `model name` line.
#[must_use]
pub fn model_in(cpuinfo: &str) -> Option<String> {
    let mut pairs = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    let (_, model) = pairs.find(|(key, _)| key.trim() == "model name")?;
    (!model.trim().is_empty()).then(|| model.trim().to_owned())
}
