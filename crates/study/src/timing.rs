//! How long things take, in turn, so that what the machine does meanwhile hits all alike.

use std::time::Duration;

use crate::Watch;

/// How often each thing is run.
#[derive(Clone, Copy, Debug)]
pub enum Repeat {
    /// At least 20 times or for 2 seconds, whichever is less (the practice of work-precision
    /// diagrams, where a run of over 2 s is made once).
    Enough,
    /// That many times.
    Times(u32),
}

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

    /// Adds a run.
    pub fn add(&mut self, time: Duration) {
        self.runs.push(time);
    }

    fn enough(&self, repeat: Repeat) -> bool {
        match repeat {
            Repeat::Enough => {
                self.runs.len() >= 20 || self.runs.iter().sum::<Duration>().as_secs() >= 2
            }
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
    mut run: impl FnMut(usize) -> Option<Duration>,
) -> Vec<Times> {
    let mut times = vec![Times::default(); count];
    let mut waiting: Vec<usize> = (0..count).collect();
    while !waiting.is_empty() {
        waiting.retain(|&i| {
            if watch.stopped() {
                return false;
            }
            let Some(time) = run(i) else { return false };
            times[i].add(time);
            !times[i].enough(repeat)
        });
    }
    times
}

fn ms(time: Duration) -> f64 {
    time.as_secs_f64() * 1e3
}
