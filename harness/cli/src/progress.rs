//! Progress bars, on stderr and only where that is a terminal.

use indicatif::{ProgressBar, ProgressStyle};
use std::time::Duration;

/// Makes a bar of a form, which shows nothing where stderr is no terminal; without a length it only turns.
pub fn bar(length: Option<u64>, template: &str) -> ProgressBar {
    let bar = length.map_or_else(ProgressBar::new_spinner, ProgressBar::new);
    // The templates are constants; if one were wrong, the bar would look plain.
    if let Ok(style) = ProgressStyle::with_template(template) {
        bar.set_style(style);
    }
    bar.enable_steady_tick(Duration::from_millis(100));
    bar
}

/// The progress bar of a run or sweep.
pub struct Progress {
    bar: ProgressBar,
}

impl Progress {
    /// Makes a bar for a number of cases or inputs.
    pub fn new(cases: u64) -> Progress {
        Progress {
            bar: bar(Some(cases), "{wide_bar} {human_pos}/{human_len} {elapsed}{msg}"),
        }
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
