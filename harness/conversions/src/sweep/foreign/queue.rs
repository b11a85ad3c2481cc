//! The queue of inputs, which adapts the number of inputs in a program to the speed of the engine.

use std::ops::Range;
use std::sync::atomic::{AtomicU64, Ordering};
use std::sync::{Mutex, PoisonError};
use std::time::Duration;

/// The number of operands in a list.
const LIST_LEN: u64 = 400;
/// The number of inputs that the first program counts through.
pub const FIRST_COUNT: u64 = 1 << 14;
/// The maximum number of inputs that one program counts through, so that its counter, a DINT, holds them.
const MAX_COUNT: u64 = 1 << 28;
/// The time within which a program must be answered for the next one to be twice as large.
const GROWTH_LIMIT: Duration = Duration::from_secs(1);

/// The places of a sweep's inputs, taken in order by all workers.
pub struct Queue {
    stretches: Vec<Range<u64>>,
    /// The index of the current stretch, and the place up to which it was taken.
    reached: Mutex<(usize, u64)>,
    /// The number of inputs of the next program.
    size: AtomicU64,
    /// The maximum number of inputs of the next program.
    limit: AtomicU64,
}

impl Queue {
    /// Makes the queue of the places in the given stretches, for programs that count (`counted`) or that list operands.
    pub fn new(stretches: Vec<Range<u64>>, counted: bool) -> Queue {
        let (size, limit) = if counted {
            (FIRST_COUNT, MAX_COUNT)
        } else {
            (LIST_LEN, LIST_LEN)
        };
        let start = stretches.first().map_or(0, |stretch| stretch.start);
        Queue {
            stretches,
            reached: Mutex::new((0, start)),
            size: AtomicU64::new(size),
            limit: AtomicU64::new(limit),
        }
    }

    /// Takes the places of the next program; `None` where all are taken.
    pub fn claim(&self) -> Option<Range<u64>> {
        let mut reached = self.reached.lock().unwrap_or_else(PoisonError::into_inner);
        let (index, start) = *reached;
        let stretch = self.stretches.get(index)?;
        let end = stretch.end.min(start + self.size.load(Ordering::Relaxed));
        let next = self.stretches.get(index + 1).map_or(0, |next| next.start);
        *reached = if end < stretch.end {
            (index, end)
        } else {
            (index + 1, next)
        };
        Some(start..end)
    }

    /// Records the time in which a program of the given number of inputs was answered.
    pub fn answered(&self, inputs: u64, took: Duration) {
        let limit = self.limit.load(Ordering::Relaxed);
        if took < GROWTH_LIMIT && 2 * inputs <= limit {
            self.size.fetch_max(2 * inputs, Ordering::Relaxed);
        }
    }

    /// Records that a program of the given number of inputs took too long.
    pub fn too_long(&self, inputs: u64) {
        let less = (inputs / 2).max(1);
        self.limit.fetch_min(less, Ordering::Relaxed);
        self.size.fetch_min(less, Ordering::Relaxed);
    }
}

#[cfg(test)]
mod tests {
    use super::{FIRST_COUNT, LIST_LEN, Queue};
    use std::time::Duration;

    #[test]
    fn every_place_is_taken_once_and_no_piece_crosses_a_stretch() {
        let stretches = vec![0..1, 1..500, 1_000..100_000];
        for counted in [false, true] {
            let queue = Queue::new(stretches.clone(), counted);
            let pieces: Vec<_> = std::iter::from_fn(|| queue.claim()).collect();
            let longest = if counted { FIRST_COUNT } else { LIST_LEN };
            for stretch in &stretches {
                let mut reached = stretch.start;
                for piece in pieces.iter().filter(|piece| stretch.contains(&piece.start)) {
                    assert_eq!(piece.start, reached);
                    assert!(piece.end - piece.start <= longest);
                    reached = piece.end;
                }
                assert_eq!(reached, stretch.end);
            }
        }
    }

    #[test]
    fn programs_grow_until_one_takes_too_long() {
        let queue = Queue::new(std::iter::once(0..u64::MAX >> 1).collect(), true);
        let size = || queue.claim().map(|piece| piece.end - piece.start);
        queue.answered(FIRST_COUNT, Duration::ZERO);
        assert_eq!(size(), Some(2 * FIRST_COUNT));
        queue.answered(2 * FIRST_COUNT, Duration::from_secs(2));
        assert_eq!(size(), Some(2 * FIRST_COUNT));
        queue.too_long(2 * FIRST_COUNT);
        queue.answered(FIRST_COUNT, Duration::ZERO);
        assert_eq!(size(), Some(FIRST_COUNT));
    }
}
