//! Whether the benches only show that they run.

/// Whether criterion will run each bench once and measure nothing: under `cargo test
/// --benches`, which does not pass `--bench`, and with `--test`. Pictures are then small.
#[must_use]
pub fn is_on() -> bool {
    let asked = |flag: &str| std::env::args().any(|argument| argument == flag);
    asked("--test") || !asked("--bench")
}
