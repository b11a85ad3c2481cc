//! Watches over a run: a mutant that never ends, or takes all memory, is found out in seconds.

use std::sync::Arc;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::{Duration, Instant};

/// The time that a case may take. The reference takes less than a tenth of a second for the longest, and the machine may be
/// busy.
const CASE_TIMEOUT: Duration = Duration::from_secs(10);

/// The memory that the process may hold, in pages of (almost everywhere) four KiB: two GiB.
const MAX_PAGES: usize = 1 << 19;

/// The progress of a run: the index of the case that is being judged.
#[derive(Clone, Default)]
pub struct Lookout(Arc<AtomicUsize>);

impl Lookout {
    /// Begins to watch. `give_up` is called with the index of the case and what is wrong with it, and ends the process.
    pub fn begin(give_up: impl Fn(usize, &str) + Send + 'static) -> Lookout {
        let lookout = Lookout::default();
        let at = lookout.clone();
        std::thread::spawn(move || at.watch(&give_up));
        lookout
    }

    /// Notes that the run has come to this case.
    pub fn at(&self, index: usize) {
        self.0.store(index, Ordering::Relaxed);
    }

    fn watch(&self, give_up: &impl Fn(usize, &str)) {
        let mut last = (usize::MAX, Instant::now());
        loop {
            std::thread::sleep(Duration::from_millis(100));
            let index = self.0.load(Ordering::Relaxed);
            if index != last.0 {
                last = (index, Instant::now());
            } else if last.1.elapsed() > CASE_TIMEOUT {
                give_up(index, "it does not end");
            }
            if pages_in_memory().is_some_and(|pages| pages > MAX_PAGES) {
                give_up(index, "it takes too much memory");
            }
        }
    }
}

/// Returns how much memory the process holds, in pages; `None` where the system does not tell in Linux's way.
fn pages_in_memory() -> Option<usize> {
    let text = std::fs::read_to_string("/proc/self/statm").ok()?;
    text.split_ascii_whitespace().nth(1)?.parse().ok()
}
