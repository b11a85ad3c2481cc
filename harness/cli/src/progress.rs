//! The bar that shows how far a run is, on stderr and only where that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// The bar that shows how far a run is.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// Makes a bar for so many cases or inputs, which shows nothing where stderr is no terminal.
    pub fn new(cases: u64) -> Progress {
        let bar = ProgressBar::new(cases);
        // The template is a constant; if it were wrong, the bar would look plain.
        if let Ok(style) = ProgressStyle::with_template("{wide_bar} {human_pos}/{human_len} {elapsed}{msg}") {
            bar.set_style(style);
        }
        bar.enable_steady_tick(Duration::from_millis(100));
        Progress { bar }
    }

    /// Counts one case more; `failed` of all so far were not as expected.
    pub fn advance(&self, failed: u64) {
        self.bar.inc(1);
        if failed > 0 && self.bar.position().is_multiple_of(64) {
            self.bar.set_message(format!(", {failed} not as expected"));
        }
    }

    /// Sets how many are done, and how many of them were not as expected.
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
