//! Chooses the number of jobs that a worker is given at a time.

use std::ops::Range;
use std::time::Duration;

/// The time below which the next batch is made larger: workers then seldom wake the thread that passes their events on, and
/// slow engines still show progress.
const QUICK_BATCH: Duration = Duration::from_millis(50);

/// The maximum number of jobs in a batch where no engine packs.
const MAX_BATCH_LEN: usize = 64;

/// The maximum number of jobs by which the fastest worker may be ahead of the slowest. It bounds the number of waiting
/// events.
const MAX_AHEAD: usize = 4096;

/// The number of batches of each worker that may be ahead, however large they are.
const BATCHES_AHEAD: usize = 4;

/// Divides the jobs of a run into batches.
#[derive(Debug)]
pub(super) struct Batches {
    jobs: usize,
    threads: usize,
    /// The index of the first job that is in no batch yet.
    next: usize,
    len: usize,
    /// Whether `len` adapts to the time that batches take.
    adapts: bool,
}

impl Batches {
    /// Divides this many jobs among so many threads, into batches of `len` jobs each, or, where that is `None`, of as many
    /// as are done in a short time.
    pub(super) fn new(jobs: usize, threads: usize, len: Option<usize>) -> Batches {
        Batches {
            jobs,
            threads,
            next: 0,
            len: len.unwrap_or(1),
            adapts: len.is_none(),
        }
    }

    /// Returns the jobs of the next batch: fewer towards the end, so that no worker is left alone with many; `None` at the
    /// end, and while the jobs are too far ahead of the `given` ones, whose events were passed on.
    pub(super) fn next(&mut self, given: usize) -> Option<Range<usize>> {
        let ahead = MAX_AHEAD.max(self.len * self.threads * BATCHES_AHEAD);
        if self.next >= self.jobs || self.next >= given + ahead {
            return None;
        }
        let share = (self.jobs - self.next).div_ceil(self.threads * 2);
        let start = self.next;
        self.next += self.len.min(share);
        Some(start..self.next)
    }

    /// Adapts the length of batches to the time that a batch of so many jobs took.
    pub(super) fn took(&mut self, len: usize, time: Duration) {
        if self.adapts {
            self.len = if time < QUICK_BATCH {
                MAX_BATCH_LEN.min(len * 2)
            } else {
                1.max(len / 2)
            };
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn jobs_are_handed_out_once_each_and_no_further_ahead_than_allowed() {
        let mut batches = Batches::new(MAX_AHEAD * 3, 1, Some(MAX_AHEAD / 4));
        for batch in 0..4 {
            let start = batch * MAX_AHEAD / 4;
            assert_eq!(batches.next(0), Some(start..start + MAX_AHEAD / 4));
        }
        assert_eq!(batches.next(0), None);
        assert_eq!(batches.next(1), Some(MAX_AHEAD..MAX_AHEAD + MAX_AHEAD / 4));
    }

    #[test]
    fn towards_the_end_workers_get_ever_fewer_jobs_until_all_are_handed_out() {
        let mut batches = Batches::new(100, 2, Some(40));
        let lengths: Vec<usize> = std::iter::from_fn(|| batches.next(0).map(|jobs| jobs.len())).collect();
        assert_eq!(lengths[..3], [25, 19, 14]);
        assert_eq!(lengths.last(), Some(&1));
        assert_eq!(lengths.iter().sum::<usize>(), 100);
    }

    #[test]
    fn quick_batches_grow_and_slow_ones_shrink() {
        let mut batches = Batches::new(10_000, 2, None);
        let mut length_after = |len, time| {
            batches.took(len, time);
            batches.next(0).map(|jobs| jobs.len())
        };
        assert_eq!(length_after(1, Duration::ZERO), Some(2));
        assert_eq!(length_after(MAX_BATCH_LEN, Duration::ZERO), Some(MAX_BATCH_LEN));
        assert_eq!(length_after(MAX_BATCH_LEN, QUICK_BATCH), Some(MAX_BATCH_LEN / 2));
        assert_eq!(length_after(1, QUICK_BATCH), Some(1));
    }
}
