//! How long things take, in turn, so that what the machine does meanwhile hits all alike.

use std::time::{Duration, Instant};

use crate::Watch;

/// How often each thing is run.
#[derive(Clone, Copy, Debug)]
pub enum Repeat {
    /// 20 times, but not again once a run has taken over [`LONG`] (the practice of
    /// work-precision diagrams), and in turn no longer than [`LONGEST`].
    Enough,
    /// A fixed number of times.
    Times(u32),
}

/// A run that takes longer is not made again.
pub const LONG: Duration = Duration::from_secs(2);

/// Time for all things in turn together. After it nothing that was run once is run again.
pub const LONGEST: Duration = Duration::from_secs(600);

/// Above that ratio of median to minimum the machine was not quiet.
const QUIET: f64 = 1.5;

/// The times of one thing.
#[derive(Clone, Debug, Default)]
pub struct Times {
    runs: Vec<Duration>,
}

impl Times {
    /// How often it was run.
    #[must_use]
    pub fn runs(&self) -> usize {
        self.runs.len()
    }

    /// The least time in ms: what it takes undisturbed. `None` before the first run.
    #[must_use]
    pub fn min_ms(&self) -> Option<f64> {
        self.runs.iter().min().map(|time| ms(*time))
    }

    /// The median in ms, of an even number the mean of the two in the middle.
    #[must_use]
    pub fn median_ms(&self) -> Option<f64> {
        let mut runs = self.runs.clone();
        runs.sort_unstable();
        let high = runs.get(runs.len() / 2)?;
        let low = runs.get((runs.len() - 1) / 2)?;
        Some((ms(*low) + ms(*high)) / 2.0)
    }

    /// The median over the minimum.
    #[must_use]
    pub fn spread(&self) -> Option<f64> {
        Some(self.median_ms()? / self.min_ms()?)
    }

    /// Adds a run.
    pub fn add(&mut self, time: Duration) {
        self.runs.push(time);
    }

    fn enough(&self, repeat: Repeat) -> bool {
        match repeat {
            Repeat::Enough => self.runs.len() >= 20 || self.runs.iter().any(|run| *run > LONG),
            Repeat::Times(times) => self.runs.len() >= times as usize,
        }
    }
}

/// Runs `count` things in turn, again and again, until each has run often enough. `run`
/// gives the time of thing i; `None` leaves it out from then on.
///
/// Stopped by `watch`, it gives the times until then.
pub fn in_turn(
    count: usize,
    repeat: Repeat,
    watch: &dyn Watch,
    run: impl FnMut(usize) -> Option<Duration>,
) -> Vec<Times> {
    more_in_turn(vec![Times::default(); count], repeat, watch, run)
}

/// [`in_turn`] of things of which some have been run before.
pub fn more_in_turn(
    mut times: Vec<Times>,
    repeat: Repeat,
    watch: &dyn Watch,
    mut run: impl FnMut(usize) -> Option<Duration>,
) -> Vec<Times> {
    let begun = Instant::now();
    let late = || matches!(repeat, Repeat::Enough) && begun.elapsed() > LONGEST;
    let mut waiting: Vec<usize> = (0..times.len()).collect();
    waiting.retain(|&i| !times[i].enough(repeat));
    while !waiting.is_empty() {
        waiting.retain(|&i| {
            if watch.stopped() || (times[i].runs() > 0 && late()) {
                return false;
            }
            let Some(time) = run(i) else { return false };
            times[i].add(time);
            !times[i].enough(repeat)
        });
    }
    times
}

/// Says, where the machine was not quiet, how far it was from that.
#[must_use]
pub fn noise<'a>(times: impl IntoIterator<Item = &'a Times>) -> Option<String> {
    let spreads: Vec<f64> = times.into_iter().filter_map(Times::spread).collect();
    let noisy: Vec<f64> = spreads.iter().copied().filter(|spread| *spread > QUIET).collect();
    let worst = noisy.iter().copied().max_by(f64::total_cmp)?;
    Some(format!(
        "The machine was not quiet: of {} rows {} have a median of more than {QUIET} times the \
         minimum, {worst:.1} times at most.",
        spreads.len(),
        noisy.len(),
    ))
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
