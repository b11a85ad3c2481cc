//! The order of results that come back in another one.

use std::collections::BTreeMap;

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
    pub const fn taken(&self) -> usize {
        self.next
    }
}

#[cfg(test)]
mod tests {
    use super::*;

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
