//! Batches of results that workers finish in any order, given on in the order of their cases.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicBool, Ordering};
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};
use std::time::Duration;

/// How many cases the fastest worker may be ahead of the slowest; it bounds what waits to be given on.
const WINDOW: usize = 4096;

/// So many batches of each worker lie within the window, however large they are.
const BATCHES: usize = 4;

/// Hands out cases to workers and keeps the fast ones from running away from the slow ones.
pub(crate) struct Dispenser {
    state: Mutex<State>,
    room: Condvar,
    total: usize,
    workers: usize,
}

struct State {
    next: usize,
    given_on: usize,
}

impl Dispenser {
    /// A dispenser of `total` cases to so many workers.
    pub(crate) fn new(total: usize, workers: usize) -> Dispenser {
        Dispenser {
            state: Mutex::new(State { next: 0, given_on: 0 }),
            room: Condvar::new(),
            total,
            workers,
        }
    }

    /// The next `size` cases (fewer towards the end, so that no worker is left alone with many), once they are near enough to
    /// what was given on last; `None` at the end or when the run stops. The worker with the lowest case never waits, so
    /// waiting ends.
    pub(crate) fn claim(&self, size: usize, stop: &AtomicBool) -> Option<std::ops::Range<usize>> {
        let window = WINDOW.max(size * self.workers * BATCHES);
        let mut state = self.lock();
        while state.next < self.total && state.next >= state.given_on + window {
            if stop.load(Ordering::Relaxed) {
                return None;
            }
            // A stopped run leaves a gap that is never given on: hence the look at the clock.
            let waited = self.room.wait_timeout(state, Duration::from_millis(20));
            state = waited.unwrap_or_else(PoisonError::into_inner).0;
        }
        if state.next >= self.total || stop.load(Ordering::Relaxed) {
            return None;
        }
        let start = state.next;
        let share = (self.total - start).div_ceil(self.workers * 2);
        state.next = start + size.min(share);
        Some(start..state.next)
    }

    /// Tells that all cases before `case` were given on.
    pub(crate) fn given_on(&self, case: usize) {
        self.lock().given_on = case;
        self.room.notify_all();
    }

    fn lock(&self) -> MutexGuard<'_, State> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

/// Puts batches back into order.
pub(crate) struct Reorder<T> {
    waiting: BTreeMap<usize, Vec<T>>,
    next: usize,
}

impl<T> Reorder<T> {
    /// An empty buffer that waits for case 0.
    pub(crate) fn new() -> Reorder<T> {
        Reorder {
            waiting: BTreeMap::new(),
            next: 0,
        }
    }

    /// Takes the batch that begins with case `start` and gives on whatever is now complete from the front.
    /// Gives the case that is waited for next.
    pub(crate) fn take(&mut self, start: usize, batch: Vec<T>, mut give: impl FnMut(T)) -> usize {
        self.waiting.insert(start, batch);
        while let Some(batch) = self.waiting.remove(&self.next) {
            self.next += batch.len();
            batch.into_iter().for_each(&mut give);
        }
        self.next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn batches_come_out_in_order_however_they_come_in() {
        let mut reorder = Reorder::new();
        let mut out = Vec::new();
        assert_eq!(reorder.take(2, vec![2, 3, 4], |item| out.push(item)), 0);
        assert_eq!(reorder.take(5, vec![5], |item| out.push(item)), 0);
        assert_eq!(reorder.take(0, vec![0, 1], |item| out.push(item)), 6);
        assert_eq!(out, [0, 1, 2, 3, 4, 5]);
    }

    #[test]
    fn an_empty_batch_leaves_a_gap_and_no_endless_loop() {
        let mut reorder = Reorder::new();
        assert_eq!(reorder.take(0, Vec::<u8>::new(), |_| ()), 0);
        assert_eq!(reorder.take(3, vec![1], |_| panic!("beyond the gap")), 0);
    }

    #[test]
    fn cases_are_handed_out_once_each_and_no_further_than_the_window() {
        let stop = AtomicBool::new(false);
        let dispenser = Dispenser::new(WINDOW * 3, 1);
        assert_eq!(dispenser.claim(WINDOW / 4, &stop), Some(0..WINDOW / 4));
        for batch in 1..4 {
            let start = batch * WINDOW / 4;
            assert_eq!(
                dispenser.claim(WINDOW / 4, &stop),
                Some(start..start + WINDOW / 4)
            );
        }
        stop.store(true, Ordering::Relaxed);
        assert_eq!(dispenser.claim(1, &stop), None, "stopped while it waits for room");
        stop.store(false, Ordering::Relaxed);
        dispenser.given_on(1);
        assert_eq!(dispenser.claim(100, &stop), Some(WINDOW..WINDOW + 100));
    }

    #[test]
    fn towards_the_end_workers_get_ever_fewer_cases_until_all_are_handed_out() {
        let stop = AtomicBool::new(false);
        let dispenser = Dispenser::new(100, 2);
        let sizes: Vec<usize> =
            std::iter::from_fn(|| dispenser.claim(40, &stop).map(|range| range.len())).collect();
        assert_eq!(sizes[..3], [25, 19, 14]);
        assert_eq!(sizes.last(), Some(&1));
        assert_eq!(sizes.iter().sum::<usize>(), 100);
    }
}
