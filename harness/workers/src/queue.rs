//! A queue between threads. The channels of the standard library do more (bounds, selection) and are compiled anew for each type
//! of task and of result, which costs a build several seconds in each crate that has workers.

use std::collections::{BTreeMap, VecDeque};
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

/// Puts results back into the order of their tasks, which are numbered from 0.
#[derive(Debug)]
pub struct Reorder<R> {
    waiting: BTreeMap<usize, R>,
    next: usize,
}

impl<R> Default for Reorder<R> {
    /// Returns a buffer that waits for the result of task 0.
    fn default() -> Reorder<R> {
        Reorder {
            waiting: BTreeMap::new(),
            next: 0,
        }
    }
}

impl<R> Reorder<R> {
    /// Keeps the result of the task with this number until its turn comes.
    pub fn put(&mut self, number: usize, result: R) {
        self.waiting.insert(number, result);
    }

    /// Takes out the result whose turn it is; `None` while its task has not ended.
    pub fn pop(&mut self) -> Option<R> {
        let result = self.waiting.remove(&self.next)?;
        self.next += 1;
        Some(result)
    }

    /// Returns how many results were taken out, which is the number of the task whose turn it is.
    #[must_use]
    pub const fn taken(&self) -> usize {
        self.next
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

    #[test]
    fn results_come_out_in_the_order_of_their_tasks_however_they_come_in() {
        let mut reorder = Reorder::default();
        let mut put = |number| {
            reorder.put(number, number);
            std::iter::from_fn(|| reorder.pop()).collect::<Vec<usize>>()
        };
        assert!(put(2).is_empty());
        assert!(put(1).is_empty());
        assert_eq!(put(0), [0, 1, 2]);
        assert_eq!(put(3), [3]);
        assert_eq!(reorder.taken(), 4);
    }
}
