//! The progress bar of a run or sweep, on stderr and only where that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// The progress bar of a run or sweep.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// Makes a bar for a number of cases or inputs, which shows nothing where stderr is no terminal.
    pub fn new(cases: u64) -> Progress {
        let bar = ProgressBar::new(cases);
        // The template is a constant; if it were wrong, the bar would look plain.
        if let Ok(style) = ProgressStyle::with_template("{wide_bar} {human_pos}/{human_len} {elapsed}{msg}") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress { bar }
    }

    /// Makes a bar for the search for causes, whose groups of cases are not counted yet.
    pub fn of_causes() -> Progress {
        let progress = Progress::new(0);
        progress.bar.set_message(", looking for causes");
        progress
    }

    /// Sets how many of all groups of failing cases were looked at.
    pub fn look_at(&self, done: u64, of: u64) {
        self.bar.set_length(of);
        self.bar.set_position(done);
    }

    /// Counts one more case; `failed` is the number of all cases so far that were not as expected.
    pub fn advance(&self, failed: u64) {
        self.bar.inc(1);
        if failed > 0 && self.bar.position().is_multiple_of(64) {
            self.bar.set_message(format!(", {failed} not as expected"));
        }
    }

    /// Sets the number of inputs that are done, and the number of those that were not as expected.
    pub fn reach(&self, done: u64, failed: u64) {
        self.bar.set_position(done);
        if failed > 0 {
            self.bar.set_message(format!(", {failed} not as expected"));
        }
    }

    /// Removes the bar.
    pub fn finish(&self) {
        self.bar.finish_and_clear();
    }
}
