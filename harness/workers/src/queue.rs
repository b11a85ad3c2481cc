//! A queue between threads. The channels of the standard library do more (bounds, selection) and are compiled anew for each type
//! of task and of result, which costs a build several seconds in each crate that has workers.

use std::collections::VecDeque;
use std::sync::{Condvar, Mutex, MutexGuard, PoisonError};

/// A queue of items, which any thread may put in and take out, until it is closed.
pub(crate) struct Queue<T> {
    state: Mutex<QueueState<T>>,
    /// Is notified of each new item and of the end.
    changed: Condvar,
}

struct QueueState<T> {
    items: VecDeque<T>,
    is_closed: bool,
}

/// Closes a queue when it is dropped.
pub(crate) struct QueueCloser<'q, T>(&'q Queue<T>);

impl<T> Queue<T> {
    /// Puts an item at the end.
    pub(crate) fn push(&self, item: T) {
        self.lock().items.push_back(item);
        self.changed.notify_one();
    }

    /// Takes the first item, waiting for one. Returns `None` once the queue is closed and nothing is left in it.
    pub(crate) fn pop(&self) -> Option<T> {
        let waiting = |state: &mut QueueState<T>| state.items.is_empty() && !state.is_closed;
        let state = self.changed.wait_while(self.lock(), waiting);
        state.unwrap_or_else(PoisonError::into_inner).items.pop_front()
    }

    /// Returns a guard that closes the queue.
    pub(crate) const fn close_on_drop(&self) -> QueueCloser<'_, T> {
        QueueCloser(self)
    }

    /// Locks the state. It is consistent whatever a thread did while it had the lock, since nothing in this file panics.
    fn lock(&self) -> MutexGuard<'_, QueueState<T>> {
        self.state.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

impl<T> Default for Queue<T> {
    fn default() -> Queue<T> {
        Queue {
            state: Mutex::new(QueueState {
                items: VecDeque::new(),
                is_closed: false,
            }),
            changed: Condvar::new(),
        }
    }
}

impl<T> Drop for QueueCloser<'_, T> {
    fn drop(&mut self) {
        self.0.lock().is_closed = true;
        self.0.changed.notify_all();
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use std::thread;

    #[test]
    fn all_items_come_out_in_their_order_before_the_end() {
        let queue = Queue::default();
        let taken = thread::scope(|scope| {
            let taker = scope.spawn(|| std::iter::from_fn(|| queue.pop()).collect::<Vec<u32>>());
            let closer = queue.close_on_drop();
            (0..100).for_each(|item| queue.push(item));
            drop(closer);
            taker.join().unwrap()
        });
        assert_eq!(taken, (0..100).collect::<Vec<_>>());
    }

    #[test]
    fn an_item_that_comes_later_ends_the_waiting() {
        let (asked, answered) = (Queue::default(), Queue::default());
        thread::scope(|scope| {
            let _closer = asked.close_on_drop();
            scope.spawn(|| std::iter::from_fn(|| asked.pop()).for_each(|item: u32| answered.push(item + 1)));
            for item in 0..100 {
                asked.push(item);
                assert_eq!(answered.pop(), Some(item + 1));
            }
        });
    }
}
