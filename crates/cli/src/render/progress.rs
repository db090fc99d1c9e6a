//! The progress bar.

use std::io::{self, IsTerminal, Write};

use clap::ValueEnum;
use indicatif::{ProgressBar, ProgressDrawTarget, ProgressStyle, TermLike};

/// Whether to show progress.
#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
pub(super) enum When {
    Auto,
    Always,
    Never,
}

/// Redrawings a second, at most.
const RATE: u8 = 10;

/// A bar of that many pixels on stderr, or one that is never drawn.
pub(super) fn bar(pixels: u64, when: When, quiet: bool) -> ProgressBar {
    let terminal = io::stderr().is_terminal();
    let target = match when {
        _ if quiet => return ProgressBar::hidden(),
        When::Never => return ProgressBar::hidden(),
        When::Auto if !terminal => return ProgressBar::hidden(),
        When::Always if !terminal => ProgressDrawTarget::term_like_with_hz(Box::new(Stderr), RATE),
        When::Auto | When::Always => ProgressDrawTarget::stderr_with_hz(RATE),
    };
    let style = ProgressStyle::with_template("{bar:40} {percent:>3} %  {elapsed} of {duration}")
        .expect("the template is well formed");
    ProgressBar::with_draw_target(Some(pixels), target).with_style(style)
}

/// A stderr that is no terminal, drawn on all the same: each state is a line of its own.
#[derive(Debug)]
struct Stderr;

impl TermLike for Stderr {
    fn width(&self) -> u16 {
        80
    }

    fn move_cursor_up(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_down(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_right(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn move_cursor_left(&self, _: usize) -> io::Result<()> {
        Ok(())
    }

    fn write_line(&self, text: &str) -> io::Result<()> {
        writeln!(io::stderr(), "{text}")
    }

    fn write_str(&self, text: &str) -> io::Result<()> {
        match text.trim_end() {
            "" => Ok(()),
            text => self.write_line(text),
        }
    }

    fn clear_line(&self) -> io::Result<()> {
        Ok(())
    }

    fn flush(&self) -> io::Result<()> {
        io::stderr().flush()
    }
}
