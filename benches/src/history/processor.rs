//! What the processor calls itself.

use super::entry::plain;

/// The first model name of `/proc/cpuinfo`; elsewhere `unknown` and the architecture.
#[must_use]
pub fn model() -> String {
    let text = std::fs::read_to_string("/proc/cpuinfo").unwrap_or_default();
    named_in(&text).unwrap_or_else(|| format!("unknown {}", std::env::consts::ARCH))
}

/// The value of the first `model name` line, as a field of the history.
#[must_use]
pub fn named_in(cpuinfo: &str) -> Option<String> {
    let mut pairs = cpuinfo.lines().filter_map(|line| line.split_once(':'));
    let (_, model) = pairs.find(|(key, _)| key.trim() == "model name")?;
    (!model.trim().is_empty()).then(|| plain(model))
}
